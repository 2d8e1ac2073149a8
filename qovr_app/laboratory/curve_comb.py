"""The curvature comb on the curve in its plane."""

from __future__ import annotations

import numpy as np

from qovr_app.laboratory.plots import Plot
from qovr_app.style.theme import Theme
from qovr_core.geometry.combs import comb
from qovr_core.laboratory.one_curve import SAMPLES, OneCurve
from qovr_core.laboratory.planes import Plane

_EVERY = 2
"""A tooth stands at every second sample: closer together they would be one grey."""

_LONGEST = 0.5
"""The longest tooth as a part of what the curve covers, at scale 1."""


class CombLines:
    """Teeth and the line along their tips, in a plot."""

    def __init__(self, plot: Plot) -> None:
        self._plot = plot
        self._teeth, self._tips = plot.make_line(bounds=False), plot.make_line()

    def show_theme(self, theme: Theme) -> None:
        """Draw in other colours."""
        self._teeth.setPen(self._plot.pen((*theme.comparison, 130), 1))
        self._tips.setPen(self._plot.pen(theme.comparison, 1.6))

    def show_curve(self, curve: OneCurve, plane: Plane, scale: float | None) -> None:
        """Show the comb of a curve, its teeth so many times as long as at first; None takes it away."""
        if scale is None:
            for line in (self._teeth, self._tips):
                line.setData([], [])
            return
        made = comb(curve.coefficients, SAMPLES)
        feet, teeth = plane.drawn(made.feet), -plane.drawn(made.curvature)
        extents = np.ptp(plane.drawn(curve.points), axis=0)
        parts = np.linalg.norm(teeth / np.where(extents > 0, extents, np.inf), axis=1)
        longest = parts[np.isfinite(parts)].max(initial=0.0)
        tips = feet + teeth * (scale * _LONGEST / longest if longest > 0 else 0.0)
        gaps = np.full_like(feet, np.nan)
        teeth = np.stack([feet, tips, gaps], axis=1)[::_EVERY].reshape(-1, 2)
        self._teeth.setData(teeth[:, 0], teeth[:, 1], connect="finite")
        self._tips.setData(tips[:, 0], tips[:, 1], connect="finite")
