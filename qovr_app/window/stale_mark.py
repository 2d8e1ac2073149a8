"""The mark over the view while its surface is older than the document."""

from __future__ import annotations

from PySide6.QtGui import QColor, QPainter, QPaintEvent
from PySide6.QtWidgets import QLabel, QWidget

from qovr_app.style.palette import theme_in_force


class StaleMark(QLabel):
    """Says over the view that the surface in it is not that of the document."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__("Stale: configure the surface to see what was set (F5)", parent)
        self.setObjectName("view.stale")
        self.setContentsMargins(10, 4, 10, 4)
        self.setVisible(False)

    def paintEvent(self, event: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(QColor(*theme_in_force().pending))
        painter.setBrush(QColor(*theme_in_force().pending_cell))
        painter.drawRoundedRect(self.rect().adjusted(0, 0, -1, -1), 4, 4)
        painter.end()
        super().paintEvent(event)
