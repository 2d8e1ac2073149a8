"""A slider over the open interval of one knot, which shows where its curve does not fold back."""

from __future__ import annotations

from PySide6.QtCore import QRectF, Qt, Signal
from PySide6.QtGui import QColor, QPainter, QPaintEvent
from PySide6.QtWidgets import QSlider, QStyle, QStyleOptionSlider, QWidget

from qovr_app.state.gestures import next_gesture
from qovr_app.style.palette import theme_in_force
from qovr_app.widgets.bursts import Bursts

_PARTS = 1000
"""Steps of the slider from 0 to 1; both ends are left out, as a knot lies strictly between."""

_BAND = 3.0


class KnotSlider(QSlider):
    """Moves one knot.

    Signals
    -------
    knot_moved : the wanted value, and the gesture to which the movement belongs
    """

    knot_moved = Signal(float, int)

    def __init__(self, name: str, parent: QWidget | None = None) -> None:
        super().__init__(Qt.Orientation.Horizontal, parent)
        self.setObjectName(name)
        self.setRange(1, _PARTS - 1)
        self.setSingleStep(_PARTS // 100)
        self.setPageStep(_PARTS // 10)
        self._forward: tuple[float, float] | None = None
        self._gesture = 0
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
        self.setValue(round(value * _PARTS))
        self.blockSignals(was_blocked)
        if forward != self._forward:
            self._forward = forward
            self.update()

    def _on_pressed(self) -> None:
        self._gesture = next_gesture()

    def _on_released(self) -> None:
        self._gesture = 0

    def _on_value_changed(self, value: int) -> None:
        self.knot_moved.emit(value / _PARTS, self._gesture or self._bursts.step())

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
