"""A job in a thread of this process: for calls that no other process could make."""

from __future__ import annotations

import threading
from collections.abc import Callable

from qovr_app.work.calls import Call
from qovr_app.work.failures import CancelledJobError, failure_of
from qovr_app.work.messages import Cancelled, Done, Failed, Reported

_GRACE_SECONDS = 1.0
"""When the window closes, a job has so long to come to a report. A thread that does not cannot be killed."""


class JobThread:
    """One job, told of as a worker process would.

    Parameters
    ----------
    deliver : takes this object and each of its messages; called in another thread
    """

    def __init__(self, deliver: Callable[[JobThread, object], None], number: int, call: Call) -> None:
        self._deliver, self._number, self._call = deliver, number, call
        self._is_cancelled = threading.Event()
        self._thread = threading.Thread(target=self._run, daemon=True)
        self._thread.start()

    def cancel(self, _number: int) -> None:
        """Ask the job to end."""
        self._is_cancelled.set()

    def end(self) -> None:
        """Ask the job to end, and no longer wait for it."""
        self._is_cancelled.set()
        self._deliver(self, Cancelled(self._number))

    def join(self) -> None:
        """Wait until the job has ended, where it does."""
        self._thread.join(_GRACE_SECONDS)

    def _run(self) -> None:
        function, values = self._call
        try:
            message: object = Done(self._number, function(*values, self._report))
        except CancelledJobError:
            message = Cancelled(self._number)
        except BaseException as error:  # as in a process of its own
            message = Failed(self._number, failure_of(function, error))
        self._deliver(self, message)

    def _report(self, *values: object) -> None:
        if self._is_cancelled.is_set():
            raise CancelledJobError
        self._deliver(self, Reported(self._number, values))
