"""Work that never stands in an edit's way: done in small pieces, while the event loop has nothing else to do."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

from PySide6.QtCore import QObject, QTimer, Signal

from qovr_core import QovrError

QUIET_MILLISECONDS = 300
"""After the last change it is so long quiet before the work begins again."""


class IdleWork(QObject):
    """Does one piece of work whenever nothing else is to do, from a while after it was asked for until it is done.

    Parameters
    ----------
    begin : starts over and returns the pieces: each ``next`` does one, and what it returns is found unless it is None

    Signals
    -------
    found : what a piece has found
    failed : the QovrError that ended the work
    """

    found = Signal(object)
    failed = Signal(object)

    def __init__(self, begin: Callable[[], Iterator[Any]], parent: QObject) -> None:
        super().__init__(parent)
        self._begin = begin
        self._pieces: Iterator[Any] = iter(())
        self._quiet = QTimer(self, singleShot=True, interval=QUIET_MILLISECONDS)
        self._quiet.timeout.connect(self._on_quiet)
        self._idle = QTimer(self, interval=0)
        self._idle.timeout.connect(self._on_idle)

    @property
    def is_running(self) -> bool:
        """Whether pieces are being done now."""
        return self._idle.isActive()

    def restart(self) -> None:
        """Drop what is being done, and begin again when it has been quiet for a while."""
        self.stop()
        self._quiet.start()

    def stop(self) -> None:
        """Drop what is being done."""
        self._quiet.stop()
        self._idle.stop()

    def _on_quiet(self) -> None:
        self._try(self._start)

    def _start(self) -> None:
        self._pieces = self._begin()
        self._idle.start()

    def _on_idle(self) -> None:
        self._try(self._do_piece)

    def _do_piece(self) -> None:
        try:
            found = next(self._pieces)
        except StopIteration:
            self.stop()
            return
        if found is not None:
            self.found.emit(found)

    def _try(self, work: Callable[[], None]) -> None:
        try:
            work()
        except QovrError as error:
            self.stop()
            self.failed.emit(error)
