"""The program's side of what takes time: jobs one after the other, and what comes of them told in the GUI thread."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable
from concurrent.futures import Future
from contextlib import suppress
from functools import partial
from itertools import count
from pathlib import Path
from typing import Any

from PySide6.QtCore import QObject, Qt, QTimer, Signal

from qovr_app.work.calls import packed
from qovr_app.work.failures import WorkError, failure_of
from qovr_app.work.file_thread import FileThread
from qovr_app.work.here import JobThread
from qovr_app.work.job import Callback, Job
from qovr_app.work.messages import Cancelled, Done, Failed, Reported, Unknown
from qovr_app.work.process import ChildProcess, Lost
from qovr_core.errors import reason_of

GRACE_MILLISECONDS = 1000
"""So long a cancelled job may take to come to its next report; then its process is killed."""


class Worker(QObject):
    """Runs functions of values in one process, which is started with the first job and kept for the next ones.

    Whoever asks is told in the GUI thread, in order, and never after ``close``.
    """

    _call_here = Signal(object)

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._numbers = count()
        self._waiting: deque[Job] = deque()
        self._current: Job | None = None
        self._process: ChildProcess | None = None
        self._processes: set[ChildProcess] = set()
        self._runner: ChildProcess | JobThread | None = None
        self._files: FileThread | None = None
        self._is_closed = False
        self._grace = QTimer(self, singleShot=True, interval=GRACE_MILLISECONDS)
        self._grace.timeout.connect(self._end_runner)
        self._call_here.connect(self._on_called, Qt.ConnectionType.QueuedConnection)

    def run(
        self,
        function: Callable[..., Any],
        *values: Any,
        on_progress: Callback | None = None,
        on_done: Callback | None = None,
        on_failed: Callback | None = None,
        target: Path | None = None,
    ) -> Job:
        """Run a function when all earlier jobs have ended.

        Parameters
        ----------
        function : of the values and of one more, ``report``, which it may call with whatever it has found; it must
            not depend on anything else, for it runs in another process
        on_progress : told what is reported
        on_done : told what the function returns
        on_failed : told the QovrError that has ended it
        target : the file that the function writes; where its process is killed, drafts beside it are removed
        """
        call = (function, values)
        job = Job(next(self._numbers), call, target, on_progress, on_done, on_failed, self._withdraw)
        if not self._is_closed:
            self._waiting.append(job)
            self._start_next()
        return job

    def in_thread(
        self,
        function: Callable[..., Any],
        *values: Any,
        on_done: Callback | None = None,
        on_failed: Callback | None = None,
    ) -> None:
        """Call a function that waits for files, after all earlier ones, in one thread beside this one.

        It is called even where the worker is closed before its turn: what was to be written is written.
        """
        if self._is_closed:
            return
        if self._files is None:
            self._files = FileThread()
        future = self._files.submit(function, *values)
        future.add_done_callback(lambda ended: self._post(partial(_tell, function, ended, on_done, on_failed)))

    def close(self) -> None:
        """End everything, and wait until it has ended; nobody is told anything any more."""
        self._is_closed = True
        self._grace.stop()
        self._waiting.clear()
        runners = {*self._processes, *([self._runner] if self._runner else [])}
        for runner in runners:
            runner.end()
        for runner in runners:
            runner.join()
        self._processes.clear()
        self._process = self._runner = self._current = None
        if self._files is not None:
            self._files.close()

    # One job after the other

    def _start_next(self) -> None:
        if self._current is not None or not self._waiting:
            return
        self._current = job = self._waiting.popleft()
        content = packed(job.call)
        if content is None:
            self._start_here(job)
            return
        if self._process is None or not self._process.is_alive:
            try:
                self._process = ChildProcess(self._on_message)
            except (OSError, RuntimeError) as error:  # no process, or no thread to listen to it
                refusal = WorkError(f"A process for the work cannot be started: {reason_of(error)}")
                self._end(lambda: job.fail(refusal))
                return
            self._processes.add(self._process)
        self._runner = self._process
        self._process.run(job.number, content, job.target)

    def _start_here(self, job: Job) -> None:
        self._runner = JobThread(self._on_message, job.number, job.call)

    def _withdraw(self, job: Job) -> None:
        if job in self._waiting:
            self._waiting.remove(job)
            job.fail(WorkError("The work was cancelled"))
        elif job is self._current and self._runner is not None:
            self._runner.cancel(job.number)
            self._grace.start()

    def _end_runner(self) -> None:
        """Kill what does not end by itself; the next job gets another process."""
        if self._runner is not None:
            self._runner.end()
            self._process = None

    # What comes of them

    def _on_message(self, runner: ChildProcess | JobThread, message: object) -> None:
        """Take a message in the thread that reads it."""
        self._post(partial(self._take, runner, message))

    def _post(self, call: Callable[[], None]) -> None:
        with suppress(RuntimeError):  # the window has gone without closing its worker
            self._call_here.emit(call)

    def _on_called(self, call: Callable[[], None]) -> None:
        if not self._is_closed:
            call()

    def _take(self, runner: ChildProcess | JobThread, message: object) -> None:
        """Take a message in the GUI thread; what comes from a runner that was given up means nothing any more."""
        if isinstance(message, Lost):
            self._processes.discard(runner)
        job = self._current
        if job is None or runner is not self._runner:
            return
        match message:
            case Reported():
                job.report(message.values)
            case Unknown() if not job.is_cancelled:
                self._start_here(job)
            case Done():
                self._end(lambda: job.finish(message.result))
            case Failed():
                self._end(lambda: job.fail(message.error))
            case Cancelled() | Unknown():
                self._end(lambda: job.fail(WorkError("The work was cancelled")))
            case Lost():
                self._end(lambda: job.fail(_lost(message)))

    def _end(self, tell: Callable[[], None]) -> None:
        """Begin the next job, and tell what came of this one."""
        self._grace.stop()
        self._current = self._runner = None
        self._start_next()
        tell()


def _tell(
    function: Callable[..., Any], ended: Future[Any], on_done: Callback | None, on_failed: Callback | None
) -> None:
    error = ended.exception()
    if error is None:
        if on_done is not None:
            on_done(ended.result())
        return
    failure = failure_of(function, error)
    if on_failed is not None:
        on_failed(failure)


def _lost(message: Lost) -> WorkError:
    return WorkError(f"The process that did the work ended unexpectedly (exit code {message.exit_code}); try again")
