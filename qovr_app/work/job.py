"""One job: what is to be done, and whom to tell."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from qovr_app.work.calls import Call

Callback = Callable[..., object]


@dataclass(eq=False)
class Job:
    """What ``Worker.run`` returns.

    Parameters
    ----------
    number : tells its messages from those of others
    call : the function and its values
    target : the file that it writes, if any
    on_progress, on_done, on_failed : see ``Worker.run``
    withdraw : what ends it
    """

    number: int
    call: Call
    target: Path | None
    on_progress: Callback | None
    on_done: Callback | None
    on_failed: Callback | None
    withdraw: Callable[[Job], None]
    is_over: bool = field(default=False, init=False)
    is_cancelled: bool = field(default=False, init=False)
    _on_ended: Callable[[bool], object] | None = field(default=None, init=False)

    def cancel(self, on_ended: Callable[[bool], object] | None = None) -> None:
        """End the job; from now on nobody is told anything of it but that it has ended.

        At its next report it ends by itself. Where none comes within a second, its process is killed.

        Parameters
        ----------
        on_ended : told when nothing of it is left, and whether it had been done all the same before the word came
        """
        if self.is_over or self.is_cancelled:
            return
        self.is_cancelled, self._on_ended = True, on_ended
        self.withdraw(self)

    def report(self, values: tuple[Any, ...]) -> None:
        """Tell what the job reports."""
        self._tell(self.on_progress, *values)

    def finish(self, result: object) -> None:
        """Tell what the job has returned."""
        self.is_over = True
        try:
            self._tell(self.on_done, result)
        finally:
            self._tell_of_end(was_done=True)

    def fail(self, error: Exception) -> None:
        """Tell why the job has ended early."""
        self.is_over = True
        try:
            self._tell(self.on_failed, error)
        finally:
            self._tell_of_end(was_done=False)

    def _tell(self, callback: Callback | None, *values: object) -> None:
        if callback is not None and not self.is_cancelled:
            callback(*values)

    def _tell_of_end(self, *, was_done: bool) -> None:
        if self._on_ended is not None:
            self._on_ended(was_done)
