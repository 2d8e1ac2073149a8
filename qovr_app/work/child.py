"""The worker process: runs one call after the other until its input ends. Knows neither Qt nor the window.

Started by ``process``; speaks over its input and its first output, which is why prints go elsewhere.
"""

from __future__ import annotations

import logging
import os
import signal
import sys
import threading
import time
from contextlib import ExitStack, suppress
from queue import SimpleQueue
from typing import Any, BinaryIO

from qovr_app.work.calls import unpacked
from qovr_app.work.failures import CancelledJobError, failure_of
from qovr_app.work.messages import (
    Cancel,
    Cancelled,
    Done,
    Failed,
    Logged,
    Reported,
    Run,
    Unknown,
    read_message,
    write_message,
)

_NICENESS = 10
"""Frames are drawn beside this process: on a machine with few cores it must be the one that waits."""

_GRACE_SECONDS = 1.0
"""When the program has gone, a job has so long to come to a report and to tidy up."""

_ALL = -1
"""Stands for every job's number: all are cancelled."""


def main() -> None:
    """Serve until the program closes this process's input, or is no more."""
    requests, replies = _own_streams()
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C is for the program, which ends this process
    if hasattr(os, "nice"):
        os.nice(_NICENESS)
    child = Child(replies)
    logging.getLogger().addHandler(_Forwarding(child))
    threading.Thread(target=child.listen, args=(requests,), daemon=True).start()
    child.serve()


class Child:
    """Runs calls in the main thread; another listens, so that a running call can be cancelled."""

    def __init__(self, replies: BinaryIO) -> None:
        self._replies = replies
        self._lock = threading.Lock()
        self._runs: SimpleQueue[Run | None] = SimpleQueue()
        self._cancelled: int | None = None

    def listen(self, requests: BinaryIO) -> None:
        """Take messages until there are no more; then leave, whatever is being done."""
        while (message := read_message(requests)) is not None:
            if isinstance(message, Cancel):
                self._cancelled = message.number
            else:
                self._runs.put(message)
        self._cancelled = _ALL
        self._runs.put(None)
        time.sleep(_GRACE_SECONDS)
        os._exit(0)

    def serve(self) -> None:
        """Run every call that comes."""
        while (run := self._runs.get()) is not None:
            try:
                self.send(self._outcome(run))
            except Exception as error:  # whatever being pickled raises where a result cannot
                self.send(Failed(run.number, failure_of(self.send, error)))

    def send(self, message: object) -> None:
        """Tell the program something, from any thread; where it has gone, the input ends as well."""
        with self._lock, suppress(OSError):
            write_message(self._replies, message)

    def _outcome(self, run: Run) -> Done | Failed | Cancelled | Unknown:
        with suppress(OSError):  # somebody may have deleted it
            os.chdir(run.folder)
        with ExitStack() as registered:
            try:
                function, values = unpacked(run.call, registered)
            except Exception:  # whatever following a name raises where it leads nowhere
                return Unknown(run.number)
            try:
                return Done(run.number, function(*values, self._report_of(run.number)))
            except CancelledJobError:
                return Cancelled(run.number)
            except BaseException as error:  # not even a call that wants to leave ends the process
                return Failed(run.number, failure_of(function, error))

    def _report_of(self, number: int) -> Any:
        def report(*values: object) -> None:
            if self._cancelled in (number, _ALL):
                raise CancelledJobError
            self.send(Reported(number, values))

        return report


class _Forwarding(logging.Handler):
    """Sends what is logged here to the program's own log, as text."""

    def __init__(self, child: Child) -> None:
        super().__init__()
        self._child = child

    def emit(self, record: logging.LogRecord) -> None:
        text = self.format(record)
        self._child.send(
            Logged(logging.LogRecord(record.name, record.levelno, record.pathname, record.lineno, text, None, None))
        )


def _own_streams() -> tuple[BinaryIO, BinaryIO]:
    """Return input and first output, which from now on are of nobody else: prints go where errors go."""
    requests, replies = os.fdopen(os.dup(0), "rb"), os.fdopen(os.dup(1), "wb")
    elsewhere = os.open(os.devnull, os.O_RDWR)
    os.dup2(elsewhere, 0)
    os.dup2(2 if sys.stderr is not None else elsewhere, 1)
    os.close(elsewhere)
    sys.stdout = sys.stderr
    return requests, replies


if __name__ == "__main__":
    main()
