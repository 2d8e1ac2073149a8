"""Displacement against distance: every sample, the envelope, and the nearest exponential."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from PySide6.QtGui import QColor
from PySide6.QtWidgets import QWidget

from qovr_app.laboratory.influence_numbers import DISTANCE
from qovr_app.laboratory.plots import Plot, Series
from qovr_app.style.symbols import coloured
from qovr_app.style.theme import Rgb, Theme
from qovr_core.arrays import Array
from qovr_core.laboratory.falloff import Falloff
from qovr_core.laboratory.influence import Influence

_EVERY = 4
"""Each fourth sample along u and v is a dot: as many as can be told apart in a plot of this size."""

_FLOOR = 1e-5
"""The logarithmic scale ends at this part of the largest displacement: below it is nothing to see."""

_HEADROOM = 1.06
_LOGARITHMIC_HEADROOM = 2.0
_CURVE_POINTS = 121
_DOT_PIXELS = 2.5
_DOT_OPACITY = 110
_LINE_PIXELS = 2.0
_DASHES = [4.0, 3.0]
_TOP_MARGIN = 5
"""Room for the upper half of a number at the end of the axis."""


class FalloffPlot(Plot):
    """Shows how an influence falls off with the distance from the place of the largest displacement."""

    def __init__(self, name: str, parent: QWidget | None = None) -> None:
        super().__init__(name, "Displacement against distance", parent)
        self.setMouseEnabled(x=False, y=False)
        self.setToolTip(f"Displacement of the surface against the distance d. {DISTANCE}")
        self.setLabel("bottom", "<i>d</i> in <i>u</i>, <i>v</i>")
        self.getAxis("left").setStyle(autoExpandTextSpace=True)
        self.getPlotItem().layout.setContentsMargins(0, _TOP_MARGIN, 0, 0)
        self._shown: tuple[Influence, Falloff] | None = None
        self._is_logarithmic = False
        self._samples = self._series(pen=None, symbol="o", symbolSize=_DOT_PIXELS, symbolPen=None)
        self.exponential, self.envelope = self._series(), self._series()
        self._reading = self.make_upright()
        self._reading.setVisible(False)

    def _series(self, **style: Any) -> Series:
        """Return a new series; what lies far outside the range is not cut, or each range would draw all anew."""
        return self.plot(dynamicRangeLimit=None, **style)

    @property
    def legend(self) -> tuple[str, str]:
        """Envelope and exponential with their lines, as rich text."""
        exponential = "<i>A</i> e<sup>−<i>d</i>/<i>L</i></sup>"
        return (
            f"{coloured('━', self.colours.accent)} envelope",
            f"{coloured('╍', self._exponential_colour)} {exponential}",
        )

    @property
    def _exponential_colour(self) -> Rgb:
        return self.colours.series[1]

    def show_theme(self, theme: Theme) -> None:
        super().show_theme(theme)
        self._samples.setSymbolBrush(QColor(*theme.quiet_ink, _DOT_OPACITY))
        self.envelope.setPen(self.pen(theme.accent, _LINE_PIXELS))
        dashed = self.pen(self._exponential_colour, _LINE_PIXELS)
        dashed.setDashPattern(_DASHES)
        self.exponential.setPen(dashed)
        self._reading.setPen(self.pen(theme.ink))

    def show_logarithmic(self, is_logarithmic: bool) -> None:
        """Choose the scale of the displacement."""
        self._is_logarithmic = is_logarithmic
        self.setLogMode(x=False, y=is_logarithmic)
        if self._shown is not None:
            self.show_influence(*self._shown)

    def show_influence(self, influence: Influence, fall: Falloff) -> None:
        """Show how an influence falls off."""
        self._shown = influence, fall
        farthest = float(fall.envelope[-1, 0])
        distances = np.linspace(0.0, farthest, _CURVE_POINTS)
        least = _FLOOR * influence.largest if self._is_logarithmic else -math.inf
        thinned = (slice(None, None, _EVERY),) * 2
        self._put(self._samples, fall.distance[thinned].ravel(), influence.magnitude[thinned].ravel(), least)
        self._put(self.envelope, fall.envelope[:, 0], fall.envelope[:, 1], least)
        self._put(self.exponential, distances, fall.exponential.at(distances), least)
        top = max(influence.largest, fall.exponential.amplitude)
        self.view_box.setXRange(0.0, farthest)
        low, high = 0.0, _HEADROOM * top
        if self._is_logarithmic:
            low, high = math.log10(_FLOOR * top), math.log10(_LOGARITHMIC_HEADROOM * top)
        self.view_box.setYRange(low, high, padding=0)

    def show_reading(self, distance: float | None) -> None:
        """Mark a distance; None takes the mark away."""
        self._reading.setVisible(distance is not None)
        if distance is not None:
            self._reading.setValue(distance)

    @staticmethod
    def _put(item: Series, distance: Array, displacement: Array, least: float) -> None:
        """Show what is more than ``least`` of a series: what is nothing has no place on a logarithmic scale."""
        kept = displacement > least
        item.setData(distance[kept], displacement[kept])
