"""What the user ought to know of files that were written all the same, wherever they were written."""

from __future__ import annotations

import logging
from contextlib import suppress

from PySide6.QtCore import QObject, Qt, Signal, SignalInstance

from qovr_core.files.atomic import LOGGER


class Notices(QObject):
    """Passes on what the atomic writer notices, from any thread and from the worker process.

    Signals
    -------
    noticed : a sentence; in the GUI thread, after whatever its occasion itself has to say
    """

    noticed = Signal(str)
    _came = Signal(str)

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._handler = _Handler(self._came)
        self._came.connect(self.noticed, Qt.ConnectionType.QueuedConnection)
        LOGGER.addHandler(self._handler)

    def close(self) -> None:
        """Pass nothing on any more."""
        LOGGER.removeHandler(self._handler)


class _Handler(logging.Handler):
    def __init__(self, came: SignalInstance) -> None:
        super().__init__(logging.WARNING)
        self._came = came

    def emit(self, record: logging.LogRecord) -> None:
        with suppress(RuntimeError):  # the window has gone without closing
            self._came.emit(f"{record.getMessage()}.")
