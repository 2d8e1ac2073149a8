"""The transformations r(u), s(u), t(u) of one curve, as they are seen."""

from __future__ import annotations

from PySide6.QtCore import QPointF, QRectF, QSize
from PySide6.QtGui import QPaintEvent
from PySide6.QtWidgets import QSizePolicy, QWidget

from qovr_app.state.knot_in_hand import KnotInHand
from qovr_app.style.canvas import painting
from qovr_app.style.fonts import small_number_font
from qovr_app.style.palette import theme_in_force
from qovr_app.widgets.knot_picture import Frame, KnotPicture, frame_in, handle_places, limits_of
from qovr_app.widgets.parts import named
from qovr_app.widgets.plot_hand import PlotHand
from qovr_core.geometry.knots import Knots
from qovr_core.number_texts import number_text

LOWEST, _NARROWEST = 90, 120
"""Less than this, and a plot says nothing: nothing is drawn."""


class KnotCanvas(QWidget):
    """Shows a curve's transformations, and what a hand does to its knots."""

    def __init__(self, name: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        named(self, name)
        self.small_font = small_number_font(self.font())
        self._curve: KnotInHand | None = None
        self._used = ""
        self._hover: float | None = None
        self._limits = (0.0, 1.0)
        self._hand = PlotHand(self, in_view=False)
        self._hand.changed.connect(self.update)
        self.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Expanding)

    def sizeHint(self) -> QSize:
        return QSize(240, 170)

    def minimumSizeHint(self) -> QSize:
        return QSize(_NARROWEST, 0)

    @property
    def knots(self) -> Knots | None:
        """The knots that are shown."""
        return None if self._curve is None else self._curve.knots

    def show_curve(self, curve: KnotInHand) -> None:
        """Show the curve of a knot."""
        if curve == self._curve:
            return
        self._curve = curve
        if not self._hand.is_dragging:  # what the mouse means stays while it holds something
            self._limits = limits_of(curve.knots)
        letters = curve.place.direction.knot_letters
        values = [f"{letter} {number_text(value)}" for letter, value in zip(letters, curve.knots, strict=True)]
        name = curve.place.direction.curve_name(curve.place.curve)
        self.setAccessibleName(f"Transformations of {name} with its knots as handles")
        self.setAccessibleDescription(", ".join(values))
        self.update()

    def show_hover(self, u: float | None) -> None:
        """Mark a parameter; None takes the mark away."""
        if u != self._hover:
            self._hover = u
            self.update()

    def handle_at(self, name: str) -> QPointF:
        """Return where a knot's handle is, in the widget's pixels."""
        return QPointF() if self._curve is None else self._frame.at(*handle_places(self._curve.knots)[name])

    @property
    def _frame(self) -> Frame:
        return frame_in(QRectF(self.rect()), self._limits)

    @property
    def _has_room(self) -> bool:
        return self.height() >= LOWEST and self.width() >= _NARROWEST

    def paintEvent(self, event: QPaintEvent) -> None:
        super().paintEvent(event)
        curve, held = self._curve, self._hand.knot
        if curve is None or not self._has_room:
            return
        picture = KnotPicture(
            curve.knots,
            curve.place.direction,
            self._frame,
            theme_in_force(),
            used=self._used if held is None else held.place.name,
            begun=held.value if held is not None and self._hand.is_dragging else None,
            typed=self._hand.typed if held is not None else "",
            is_possible=self._hand.is_possible,
            hover=self._hover,
        )
        with painting(self) as painter:
            painter.setFont(self.small_font)
            picture.paint(painter)
