"""A heading of a row or column of fields, which stands for all of them."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import QEvent, Qt, Signal
from PySide6.QtGui import QColor, QEnterEvent, QMouseEvent, QPainter, QPaintEvent, QPalette
from PySide6.QtWidgets import QLabel, QSizePolicy, QWidget

from qovr_app.state.looking_intents import Picking
from qovr_app.state.scrubbing import Scrub
from qovr_app.style.palette import theme_in_force
from qovr_app.widgets.scrubbing import Scrubbing

_PICKING = {
    Qt.KeyboardModifier.ShiftModifier: Picking.ADD,
    Qt.KeyboardModifier.ControlModifier: Picking.TOGGLE,
}


class HeaderLabel(QLabel):
    """A symbol that is clicked, or dragged sideways to change the numbers of its row or column by the same amount.

    Shift and Ctrl add to what a click selects, and toggle it.

    Signals
    -------
    scrubbed : the amount, and its gesture
    gesture_begun, gesture_ended, gesture_cancelled : the drag, with its gesture
    clicked : the heading was pressed and let go; what that does to the selection, as Picking
    """

    scrubbed = Signal(float, int)
    gesture_begun = Signal(int)
    gesture_ended = Signal(int)
    gesture_cancelled = Signal(int)
    clicked = Signal(object)

    def __init__(
        self,
        html: str,
        name: str,
        take: Callable[[], Scrub],
        snaps: Callable[[], bool],
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(html, parent)
        self.setObjectName(name)
        self.setTextFormat(Qt.TextFormat.RichText)
        self.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Fixed)
        scrubbing = Scrubbing(self, take, snaps)
        scrubbing.begun.connect(self.gesture_begun)
        scrubbing.scrubbed.connect(self.scrubbed)
        scrubbing.ended.connect(self.gesture_ended)
        scrubbing.cancelled.connect(self.gesture_cancelled)
        scrubbing.clicked.connect(lambda: self.clicked.emit(Picking.REPLACE))

    def set_quiet(self) -> None:
        """Write in the ink of what is only read."""
        self.setForegroundRole(QPalette.ColorRole.PlaceholderText)

    def mousePressEvent(self, event: QMouseEvent) -> None:
        picking = next((picking for key, picking in _PICKING.items() if event.modifiers() & key), None)
        if picking is not None and event.button() == Qt.MouseButton.LeftButton:
            self.clicked.emit(picking)

    def enterEvent(self, event: QEnterEvent) -> None:
        super().enterEvent(event)
        self.update()

    def leaveEvent(self, event: QEvent) -> None:
        super().leaveEvent(event)
        self.update()

    def paintEvent(self, event: QPaintEvent) -> None:
        if self.underMouse():
            painter = QPainter(self)
            painter.setPen(QColor(*theme_in_force().hover))
            painter.drawLine(0, self.height() - 1, self.width(), self.height() - 1)
            painter.end()
        super().paintEvent(event)
