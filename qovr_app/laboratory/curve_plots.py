"""The four plots of one curve, what stands over them, and the reading under the mouse that they share."""

from __future__ import annotations

from math import isfinite
from typing import NamedTuple

from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QGridLayout, QWidget

from qovr_app.laboratory.curve_functions import WeightsPlot
from qovr_app.laboratory.curve_geometry import GeometryPlot
from qovr_app.laboratory.curve_transformations import TransformationsPlot
from qovr_app.laboratory.panel import WIDE
from qovr_app.laboratory.plots import Captioned
from qovr_app.laboratory.wording import value_text
from qovr_app.store import Store
from qovr_app.style.palette import theme_in_force
from qovr_app.style.symbols import coloured, symbol_html
from qovr_app.style.theme import Theme
from qovr_core.formulations import Formulation
from qovr_core.geometry.combs import comb_changes
from qovr_core.laboratory.one_curve import SAMPLES, OneCurve
from qovr_core.laboratory.planes import View
from qovr_core.number_texts import number_text

_TIPS = (
    """Thin: the parabolas Q_0, Q_1, Q_2 between their points
Broad: what of them is blended
Dashed: what is blended beyond their points
Rings: where the parameter is 0, its internal knot, and 1""",
    "How much each parabola counts: (1-u)^2, 2u(1-u) and u^2",
    "How much each point counts; the five weights sum to 1",
)
"""What each plot shows, in the order of the plots; the last one says it itself."""

_Cell = tuple[int, int, int, int]


class _Arrangement(NamedTuple):
    """Where the plots stand, how high each is at least, and what columns and rows get of the room beyond that."""

    cells: tuple[_Cell, ...]
    heights: tuple[int, ...]
    columns: tuple[int, int, int]
    rows: tuple[int, int, int, int]


_BESIDE = _Arrangement(
    ((0, 0, 2, 1), (0, 1, 1, 1), (1, 1, 1, 1), (0, 2, 2, 1)), (220, 110, 110, 220), (5, 4, 4), (1, 1, 0, 0)
)
_BELOW = _Arrangement(
    ((0, 0, 1, 3), (1, 0, 1, 3), (2, 0, 1, 3), (3, 0, 1, 3)), (230, 140, 150, 190), (1, 0, 0), (3, 2, 2, 3)
)


class CurvePlots(QWidget):
    """Shows a curve and its parts; a place under the mouse in one plot is marked in all of them."""

    def __init__(self, store: Store, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._shown: tuple[OneCurve, Formulation] | None = None
        self._has_comb = False
        self._grid = QGridLayout(self)
        self._arrangement: _Arrangement | None = None
        self._geometry = GeometryPlot(self)
        parabolas = [symbol_html("w", str(p)) for p in range(3)]
        points = [symbol_html("b", str(k)) for k in range(5)]
        self._blends = WeightsPlot(
            "laboratory.curve.blends", "The weights of the three parabolas", parabolas, [1, 2, 3], self
        )
        self._weights = WeightsPlot(
            "laboratory.curve.weights", "The weights of the five points", points, [0, 1, 2, 3, 4], self
        )
        self._transformations = TransformationsPlot(store, self)
        self._functions: tuple[WeightsPlot | TransformationsPlot, ...] = (
            self._blends,
            self._weights,
            self._transformations,
        )
        self._plots = self._geometry, *self._functions
        self._captions = [Captioned(plot, plot.small_font, self) for plot in self._plots]
        self._arrange()
        self._geometry.hovered.connect(lambda place: self._show_hover(place and self._geometry.nearest(place)))
        for plot in (self._blends, self._weights):
            plot.hovered.connect(lambda place: self._show_hover(place and min(max(place[0], 0.0), 1.0)))
        self._transformations.hovered.connect(self._show_hover)

    @property
    def curve(self) -> OneCurve | None:
        """The curve that is shown."""
        return None if self._shown is None else self._shown[0]

    def show_theme(self, theme: Theme) -> None:
        """Draw in other colours."""
        for plot in (self._geometry, self._blends, self._weights):  # the other one is painted in the theme in force
            plot.show_theme(theme)
        self._show_captions(None)

    def set_equal_scales(self, are_equal: bool) -> None:
        """Draw both directions of the curve's plane at one scale, or each as large as there is room."""
        self._geometry.setAspectLocked(are_equal)

    def show_comb(self, scale: float | None) -> None:
        """Show the curve's comb, its teeth so many times as long as at first, and its number; None takes both away."""
        self._has_comb = scale is not None
        self._geometry.show_comb(scale)
        self._show_captions(None)

    def show_curve(self, curve: OneCurve, formulation: Formulation, view: View) -> None:
        """Show a curve in a plane, as a formulation uses it."""
        before, self._shown = self.curve, (curve, formulation)
        self._geometry.show_curve(curve, view)
        if before is None or (before.knots, before.decimals) != (curve.knots, curve.decimals):  # a point moves none
            self._blends.show_weights(curve.blends(SAMPLES), curve.knots.u)
            self._weights.show_weights(curve.weights(SAMPLES), curve.knots.u)
        self._transformations.show_part(curve)
        self._show_hover(None)

    def _show_hover(self, u: float | None) -> None:
        if self._shown is not None:
            for plot in self._plots:
                plot.show_hover(u)
            self._show_captions(u)

    def _show_captions(self, u: float | None) -> None:
        if self._shown is None:
            return
        curve, formulation = self._shown
        captions = _titles(curve, formulation, has_comb=self._has_comb) if u is None else _place_texts(curve, u)
        over_geometry, *over_functions = self._captions
        over_geometry.say(*captions)
        if u is None:
            over = f"over <i>{curve.parameter}</i>"
            notes = f"of the parabolas, {over}", f"of the points, {over}", _how_it_runs(curve)
            for plot, caption, note in zip(self._functions, over_functions, notes, strict=True):
                legend = _in_a_row(plot.legend())
                caption.say(f"{legend}&nbsp;&nbsp; {note}", note if plot is self._transformations else legend)
            return
        values = curve.blends([u])[0], curve.weights([u])[0], curve.transformed([u])[0]
        for plot, caption, of_plot in zip(self._functions, over_functions, values, strict=True):
            full, short = plot.legend(of_plot), plot.legend(of_plot, decimals=2)
            caption.say(*map(_in_a_row, (full, short, plot.legend(of_plot, decimals=2, named=False))))

    def _arrange(self) -> None:
        self._grid.setContentsMargins(0, 0, 0, 0)
        self._grid.setSpacing(1)
        for plot, tip in zip((self._geometry, self._blends, self._weights), _TIPS, strict=True):
            plot.setToolTip(tip)
        self._place(_BESIDE)

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._place(_BESIDE if event.size().width() >= WIDE else _BELOW)

    def _place(self, arrangement: _Arrangement) -> None:
        if arrangement is self._arrangement:
            return
        self._arrangement, grid = arrangement, self._grid
        for captioned, cell, height in zip(self._captions, arrangement.cells, arrangement.heights, strict=True):
            grid.addWidget(captioned, *cell)
            captioned.setMinimumHeight(height)
        for column in range(3):
            grid.setColumnStretch(column, arrangement.columns[column])
        for row in range(4):
            grid.setRowStretch(row, arrangement.rows[row])


def _in_a_row(texts: list[str]) -> str:
    return "&nbsp; ".join(texts)


def _titles(curve: OneCurve, formulation: Formulation, *, has_comb: bool) -> tuple[str, ...]:
    """Return what stands over the curve, at length and shorter."""
    name = f"<b>{symbol_html(curve.direction.letter, str(curve.number))}</b>(<i>{curve.parameter}</i>)"
    if not formulation.is_active(curve.direction, curve.number):
        return f"{name}: no effect on the {formulation} surface", f"{name}: no effect"
    short = f"{name}, degree {curve.knots.degree}"
    if has_comb:
        changes = float(comb_changes(curve.coefficients[None])[0])
        number = f"comb changes {value_text(changes)} / length" if isfinite(changes) else "comb changes without end"
        return f"{short}&nbsp;&nbsp; sum of {number}", f"{name}: {number}", number
    return f"{short}&nbsp;&nbsp; broad: blended&nbsp;&nbsp; dashed: beyond its points", short


def _place_texts(curve: OneCurve, u: float) -> tuple[str]:
    """Return where a parameter lies on the curve."""
    x, y, z = (number_text(round(value, 4)) for value in curve.at([u])[0].tolist())
    return (f"<i>{curve.parameter}</i> = {u:.3f}&nbsp;&nbsp; {x}, {y}, {z}",)


def _how_it_runs(curve: OneCurve) -> str:
    over = f"over <i>{curve.parameter}</i>"
    if not curve.folding_parts:
        return over
    parts = " and ".join(f"{low:.3g} to {high:.3g}" for low, high in curve.folding_parts)
    return coloured(f"folds back {parts}", theme_in_force().warn)
