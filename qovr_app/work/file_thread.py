"""The one thread that waits for files, so that nobody else has to."""

from __future__ import annotations

from collections.abc import Callable
from concurrent.futures import Future
from queue import SimpleQueue
from threading import Thread
from typing import Any

_PATIENCE_SECONDS = 5.0
"""At the end what was asked for is waited for so long: a share that does not answer holds the end no longer up."""


class FileThread:
    """Makes one call after the other, also those that wait when it is closed."""

    def __init__(self) -> None:
        self._calls: SimpleQueue[Callable[[], None] | None] = SimpleQueue()
        self._thread = Thread(target=self._work, name="files", daemon=True)
        self._thread.start()

    def submit(self, function: Callable[..., Any], *values: Any) -> Future[Any]:
        """Return what will come of a call."""
        outcome: Future[Any] = Future()

        def call() -> None:
            try:
                outcome.set_result(function(*values))
            except BaseException as error:  # it is told; the next call is made
                outcome.set_exception(error)

        self._calls.put(call)
        return outcome

    def close(self) -> None:
        """Make the calls that wait, and no more."""
        self._calls.put(None)
        self._thread.join(_PATIENCE_SECONDS)

    def _work(self) -> None:
        for call in iter(self._calls.get, None):
            call()
