"""A job for the latest of many changes: begun when they have come to rest, and dropped with the next one."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import QObject, QTimer

from qovr_app.work.job import Job

QUIET_MILLISECONDS = 300
"""After the last change it is so long quiet before the work begins."""


class QuietJob(QObject):
    """Keeps at most one job going, begun a while after it was last asked for.

    Parameters
    ----------
    begin : asks the worker for the job, of what holds then; returns None where there is nothing to do
    """

    def __init__(self, begin: Callable[[], Job | None], parent: QObject) -> None:
        super().__init__(parent)
        self._begin = begin
        self._job: Job | None = None
        self._quiet = QTimer(self, singleShot=True, interval=QUIET_MILLISECONDS)
        self._quiet.timeout.connect(self._on_quiet)

    @property
    def is_running(self) -> bool:
        """Whether there is a job that has not ended."""
        return self._job is not None and not self._job.is_over

    def restart(self) -> None:
        """Drop what is being done, and begin again when it has been quiet for a while."""
        self.stop()
        self._quiet.start()

    def stop(self) -> None:
        """Drop what is being done."""
        self._quiet.stop()
        if self._job is not None:
            self._job.cancel()
            self._job = None

    def _on_quiet(self) -> None:
        self._job = self._begin()
