"""The laboratory's own window, where it floats."""

from __future__ import annotations

from PySide6.QtCore import QSize, Qt, Signal
from PySide6.QtGui import QCloseEvent
from PySide6.QtWidgets import QVBoxLayout, QWidget

_FIRST_SIZE = QSize(720, 520)


class FloatingWindow(QWidget):
    """A window beside the main one, to which its keys still go; it closes only by what ``close_asked`` leads to."""

    close_asked = Signal()

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent, Qt.WindowType.Tool)
        self.setObjectName("laboratory.window")
        self.setWindowTitle("Laboratory")
        self.resize(_FIRST_SIZE)
        QVBoxLayout(self).setContentsMargins(0, 0, 0, 0)

    def closeEvent(self, event: QCloseEvent) -> None:
        event.ignore()
        self.close_asked.emit()
