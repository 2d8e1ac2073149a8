"""The worker process as the program sees it: started, spoken to, and ended."""

from __future__ import annotations

import logging
import os
import subprocess
import sys
import threading
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from queue import SimpleQueue

from qovr_app.work.failures import LOGGER
from qovr_app.work.messages import Cancel, Logged, Run, read_message, write_message
from qovr_core.files.drafts import remove_drafts

_ONE_THREAD = dict.fromkeys(
    ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS", "VECLIB_MAXIMUM_THREADS"), "1"
)
"""For the libraries under NumPy, and for ``geometry.grid``: the other cores are for whoever draws."""


@dataclass(frozen=True)
class Lost:
    """The process is no more, and what it left of files is gone."""

    exit_code: int


class ChildProcess:
    """One worker process.

    Parameters
    ----------
    deliver : takes this object and each of its messages, the last of which is ``Lost``; called in another thread
    """

    def __init__(self, deliver: Callable[[ChildProcess, object], None]) -> None:
        self._deliver = deliver
        self._target: Path | None = None
        self._is_ended = False
        self._outbox: SimpleQueue[Run | Cancel | None] = SimpleQueue()
        self._process = subprocess.Popen(
            # -P: nothing is imported from the folder in which the program happens to run
            [sys.executable, "-P", "-m", "qovr_app.work.child"],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            env=os.environ | _ONE_THREAD | {"PYTHONPATH": os.pathsep.join(sys.path)},
            creationflags=_creation_flags(),
        )
        self._threads = [threading.Thread(target=work, daemon=True) for work in (self._write, self._read)]
        for thread in self._threads:
            thread.start()

    @property
    def is_alive(self) -> bool:
        """Whether it can take another job."""
        return not self._is_ended and self._process.poll() is None

    def run(self, number: int, call: bytes, target: Path | None) -> None:
        """Begin a job.

        Parameters
        ----------
        target : the file that it writes, if any
        """
        self._target = target
        self._outbox.put(Run(number, call, _folder()))

    def cancel(self, number: int) -> None:
        """Ask a job to end."""
        self._outbox.put(Cancel(number))

    def end(self) -> None:
        """Kill the process; ``Lost`` says when it is no more."""
        self._process.kill()

    def join(self) -> None:
        """Wait until the process is no more, and its threads neither."""
        for thread in self._threads:
            thread.join()

    def _write(self) -> None:
        """Write messages in a thread of their own: a pipe is full until the process has started."""
        assert self._process.stdin is not None
        with suppress(OSError, ValueError):  # the process has ended, which the reading finds, and has closed the pipe
            for message in iter(self._outbox.get, None):
                write_message(self._process.stdin, message)

    def _read(self) -> None:
        assert self._process.stdout is not None
        try:
            while (message := read_message(self._process.stdout)) is not None:
                if isinstance(message, Logged):
                    logging.getLogger(message.record.name).handle(message.record)
                else:
                    self._deliver(self, message)
        except Exception as error:  # whatever a result's own way of being unpickled raises
            LOGGER.error("a message of the worker cannot be read", exc_info=error)
        finally:
            self._bury()

    def _bury(self) -> None:
        self._is_ended = True
        self._process.kill()
        exit_code = self._process.wait()
        self._outbox.put(None)
        for stream in (self._process.stdin, self._process.stdout):
            if stream is not None:
                with suppress(OSError):
                    stream.close()
        if self._target is not None:
            remove_drafts(self._target, self._process.pid)
        self._deliver(self, Lost(exit_code))


def _creation_flags() -> int:
    """Return what keeps the process in the background on Windows; elsewhere it sees to that itself."""
    if sys.platform == "win32":
        return subprocess.BELOW_NORMAL_PRIORITY_CLASS | subprocess.CREATE_NO_WINDOW
    return 0


def _folder() -> str:
    """Return the folder in which relative paths begin; any will do where somebody has deleted it."""
    try:
        return str(Path.cwd())
    except FileNotFoundError:
        return os.curdir
