"""Dragging a knot in a plot of the transformations."""

from __future__ import annotations

from PySide6.QtCore import QLineF, QPointF

from qovr_app.state.gestures import FINE
from qovr_app.state.knot_in_hand import KnotInHand
from qovr_app.widgets.knot_hand import KnotHand
from qovr_app.widgets.knot_picture import Frame, handle_places
from qovr_core.geometry.knots import Knots


class PlotHand(KnotHand):
    """Moves the knot that is held in a plot: u sideways, the others up and down."""

    def take(self, knot: KnotInHand, frame: Frame, at: QPointF, *, snaps: bool) -> None:
        """Take hold of a knot."""
        self._frame = frame
        self.hold(knot, at, snaps=snaps)

    def _take_again(self) -> None:
        super()._take_again()
        self._from = self._at

    def _gone(self) -> float:
        way = self._at - self._from
        return (way.x() if self._name == "u" else -way.y()) * self._pixel()

    def _pixel(self) -> float:
        return self._frame.pixel(self._name) * (FINE if self._is_fine else 1.0)

    @property
    def _name(self) -> str:
        return "" if self._knot is None else self._knot.place.name


def nearest_knot(frame: Frame, knots: Knots, at: QPointF, reach: float) -> str:
    """Return the knot whose handle is nearest to a pixel, within reach; empty for none."""
    places = {name: frame.at(*place) for name, place in handle_places(knots).items()}
    away = {name: QLineF(at, place).length() for name, place in places.items()}
    name = min(away, key=lambda each: away[each])
    return name if away[name] <= reach else ""
