"""When to draw on the coarser grid, because the next frame is near, and when on the finer one."""

from __future__ import annotations

from PySide6.QtCore import QObject, QTimer, Signal

_REST_MILLISECONDS = 150
"""After this long without a change the surface is drawn on its finer grid."""


class Refinement(QObject):
    """Knows whether something moves; ``rested`` when all has come to rest."""

    rested = Signal()

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self._is_moving = False
        self._pause = QTimer(self)
        self._pause.setSingleShot(True)
        self._pause.setInterval(_REST_MILLISECONDS)
        self._pause.timeout.connect(self.rest)

    @property
    def is_moving(self) -> bool:
        """Whether a change was seen a short time ago."""
        return self._is_moving

    def move(self) -> None:
        """Note that something has moved."""
        self._is_moving = True
        self._pause.start()

    def rest(self) -> None:
        """Take everything for being at rest now."""
        self._is_moving = False
        self.rested.emit()
