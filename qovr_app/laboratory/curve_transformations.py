"""The transformations r(u), s(u), t(u), with a handle on every internal knot, and where the curve folds back."""

from __future__ import annotations

from itertools import zip_longest

from PySide6.QtCore import QSignalBlocker, Qt, Signal
from PySide6.QtWidgets import QWidget

from qovr_app.laboratory.curve_functions import FunctionPlot
from qovr_app.laboratory.pg import make_brush
from qovr_app.laboratory.plots import Handle
from qovr_app.state.gestures import next_gesture
from qovr_app.style.theme import Theme
from qovr_core.geometry.folding import MOST_FOLDS
from qovr_core.laboratory.one_curve import PARABOLA_LETTERS, SAMPLES, OneCurve

_HANDLE = 12
_STEPS = 1000
"""Handles move in this many steps from 0 to 1 and stay off both ends, as the sliders do."""

_LEAST_RANGE = (-0.5, 1.5)
"""What r, s and t reach where every knot is 0.5."""

_HEADROOM = 0.1
_FOLD_ALPHA = 44
_KNOTS_OF = {"r": ("r",), "s": ("u", "s"), "t": ("t",)}
"""The knots that each handle moves: that of s lies at (u_ip, s_ip)."""


class TransformationsPlot(FunctionPlot):
    """Shows r, s and t over u.

    The handles lie where the knots are: r_ip at u = 0, s_ip at u_ip, t_ip at u = 1. Bands stand where the curve folds
    back on evenly spaced points.

    Signals
    -------
    knots_moved : a dict of knot names and wanted values, and the drag's gesture
    """

    knots_moved = Signal(object, int)

    def __init__(self, parent: QWidget | None = None) -> None:
        spoken = "The transformations r, s and t of the curve's parameter, with its four knots as handles"
        super().__init__(
            "laboratory.curve.transformations",
            spoken,
            [f"<i>{letter}</i>" for letter in PARABOLA_LETTERS],
            [1, 2, 3],
            parent,
        )
        self._places: dict[str, tuple[float, float]] = {}
        self._gesture = 0
        self.folds = [self.make_band() for _ in range(MOST_FOLDS)]
        self._limits = [self.make_level(value) for value in (0, 1)]
        self.handles = {name: self._make_handle(name) for name in _KNOTS_OF}

    def show_theme(self, theme: Theme) -> None:
        super().show_theme(theme)
        for band in self.folds:
            band.setBrush(make_brush((*theme.warn, _FOLD_ALPHA)))
            for line in band.lines:
                line.setPen(self.pen(theme.warn, 1))
        for limit in self._limits:
            limit.setPen(self.pen(theme.axis, 1))
        for handle, colour in zip(self.handles.values(), self.series, strict=True):
            handle.setBrush(make_brush(theme.background))
            handle.setPen(self.pen(colour, 2))
            handle.setHoverBrush(make_brush(colour))
            handle.setHoverPen(self.pen(theme.ink, 2))

    def show_curve(self, curve: OneCurve) -> None:
        """Show the transformations of a curve."""
        values = curve.transformed(SAMPLES)
        low, high = (end(limit, end(values[:, 1])) for end, limit in zip((min, max), _LEAST_RANGE, strict=True))
        self.show_functions(values, curve.knots.u, (low - _HEADROOM, high + _HEADROOM))
        for band, part in zip_longest(self.folds, curve.folding_parts):
            band.setVisible(part is not None)
            if part is not None:
                band.setRegion(part)
        r, s, t = curve.internal_knots
        self._places = {"r": (0.0, r), "s": (curve.knots.u, s), "t": (1.0, t)}
        self._place_handles()

    def _make_handle(self, name: str) -> Handle:
        handle = self.make_handle(_HANDLE)
        handle.setCursor(Qt.CursorShape.SizeAllCursor if name == "s" else Qt.CursorShape.SizeVerCursor)
        handle.sigPositionChanged.connect(lambda: self._on_handle_moved(name))
        handle.sigPositionChangeFinished.connect(self._on_handle_left)
        return handle

    def _place_handles(self) -> None:
        """Put the handles where the knots are, silently."""
        for name, place in self._places.items():
            with QSignalBlocker(self.handles[name]):
                self.handles[name].setPos(*place)

    def _on_handle_moved(self, name: str) -> None:
        self._gesture = self._gesture or next_gesture()
        place = self.handles[name].pos()
        wanted = {"u": place.x(), name: place.y()}
        self._place_handles()
        self.knots_moved.emit({knot: _allowed(wanted[knot]) for knot in _KNOTS_OF[name]}, self._gesture)

    def _on_handle_left(self) -> None:
        self._gesture = 0


def _allowed(value: float) -> float:
    """Return the nearest value that a handle may give a knot."""
    return min(max(round(value * _STEPS), 1), _STEPS - 1) / _STEPS
