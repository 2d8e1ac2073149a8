"""A slider over the open interval of one knot, which shows where its curve does not fold back."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QPoint, QRectF, Qt, Signal
from PySide6.QtGui import QColor, QContextMenuEvent, QKeyEvent, QMouseEvent, QPainter, QPaintEvent
from PySide6.QtWidgets import QSlider, QStyle, QStyleOptionSlider, QWidget

from qovr_app.state.gestures import next_gesture
from qovr_app.style.palette import theme_in_force
from qovr_app.widgets.bursts import Bursts
from qovr_core.geometry.folding import STEPS

_BAND = 3.0


class KnotSlider(QSlider):
    """Moves one knot; Escape, the right button and a lost focus put it back, and wait for the button's release.

    Signals
    -------
    knot_moved : the wanted value, and the gesture to which the movement belongs
    gesture_begun, gesture_ended, gesture_cancelled : the handle is dragged, with its gesture
    reset_asked : the slider was clicked twice
    menu_asked : the place of the screen where the menu of the knot is wanted
    """

    knot_moved = Signal(float, int)
    gesture_begun = Signal(int)
    gesture_ended = Signal(int)
    gesture_cancelled = Signal(int)
    reset_asked = Signal()
    menu_asked = Signal(QPoint)

    _gesture = 0  # events come before the first line of __init__ has run
    _waits = False

    def __init__(self, name: str, parent: QWidget | None = None) -> None:
        super().__init__(Qt.Orientation.Horizontal, parent)
        self.setObjectName(name)
        self.setToolTip("Drag to move the knot, click twice to reset it")
        self.setRange(1, STEPS - 1)
        self.setSingleStep(STEPS // 100)
        self.setPageStep(STEPS // 10)
        self._forward: tuple[float, float] | None = None
        self._bursts = Bursts(self)
        self.sliderPressed.connect(self._on_pressed)
        self.sliderReleased.connect(self._on_released)
        self.valueChanged.connect(self._on_value_changed)

    def show_knot(self, value: float, forward: tuple[float, float] | None) -> None:
        """Show a knot, silently.

        Parameters
        ----------
        forward : between which values its curve does not fold back; None where it does whatever this knot is
        """
        was_blocked = self.blockSignals(True)
        self.setValue(round(value * STEPS))
        self.blockSignals(was_blocked)
        if forward != self._forward:
            self._forward = forward
            self.update()

    def _on_pressed(self) -> None:
        self._gesture = next_gesture()
        self.gesture_begun.emit(self._gesture)

    def _on_released(self) -> None:
        gesture, self._gesture = self._gesture, 0
        if gesture:
            self.gesture_ended.emit(gesture)

    def _cancel(self) -> None:
        """Have the knot put back; the mouse is not followed until its button is released."""
        gesture, self._gesture, self._waits = self._gesture, 0, True
        self.setSliderDown(False)
        self.gesture_cancelled.emit(gesture)

    def _on_value_changed(self, value: int) -> None:
        self.knot_moved.emit(value / STEPS, self._gesture or self._bursts.step())

    # Mouse and keys

    def event(self, event: QEvent) -> bool:
        kind = event.type()
        if self._gesture and kind in (QEvent.Type.FocusOut, QEvent.Type.Hide, QEvent.Type.WindowDeactivate):
            self._cancel()
        elif kind == QEvent.Type.ShortcutOverride and self._is_escape(event):
            event.accept()
            return True
        return super().event(event)

    def mousePressEvent(self, event: QMouseEvent) -> None:
        if self._gesture:
            self._cancel()
        elif event.button() == Qt.MouseButton.LeftButton:
            self._waits = False
            super().mousePressEvent(event)
        else:
            event.ignore()

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        if not self._waits:
            super().mouseMoveEvent(event)

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        if self._waits and event.button() != Qt.MouseButton.LeftButton:
            return
        self._waits = False
        super().mouseReleaseEvent(event)

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        if event.button() == Qt.MouseButton.LeftButton:
            self.reset_asked.emit()

    def contextMenuEvent(self, event: QContextMenuEvent) -> None:
        if not self._waits:
            self.menu_asked.emit(event.globalPos())

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if self._is_escape(event):
            self._cancel()
        elif not self._gesture:
            super().keyPressEvent(event)

    def _is_escape(self, event: QEvent) -> bool:
        return bool(self._gesture) and isinstance(event, QKeyEvent) and event.key() == Qt.Key.Key_Escape

    def paintEvent(self, event: QPaintEvent) -> None:
        super().paintEvent(event)
        if self._forward is None:
            return
        option = QStyleOptionSlider()
        self.initStyleOption(option)
        control = QStyle.ComplexControl.CC_Slider
        handle = self.style().subControlRect(control, option, QStyle.SubControl.SC_SliderHandle, self)
        groove = self.style().subControlRect(control, option, QStyle.SubControl.SC_SliderGroove, self)
        room = groove.width() - handle.width()
        start = groove.left() + handle.width() / 2
        low, high = self._forward
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(QColor(*theme_in_force().idle_ink))
        band = QRectF(start + low * room, self.height() - _BAND, (high - low) * room, _BAND)
        painter.drawRoundedRect(band, _BAND / 2, _BAND / 2)
