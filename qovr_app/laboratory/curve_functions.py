"""Functions of the curve's parameter: the weights."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QWidget

from qovr_app.laboratory.pg import make_brush
from qovr_app.laboratory.plots import Plot
from qovr_app.style.symbols import coloured
from qovr_app.style.theme import Rgb, Theme
from qovr_core.arrays import Array
from qovr_core.laboratory.labels import label_places
from qovr_core.laboratory.one_curve import SAMPLES
from qovr_core.number_texts import fixed_text

_HEADROOM = 0.1
"""Kept free above and below what a plot must show."""


class FunctionPlot(Plot):
    """Several functions of u on [0, 1], each with its name on it.

    Parameters
    ----------
    symbols : the functions' names as rich text
    colours : for each function the number of its colour in the theme's series
    """

    def __init__(
        self, name: str, spoken: str, symbols: list[str], colours: list[int], parent: QWidget | None = None
    ) -> None:
        super().__init__(name, spoken, parent)
        self._symbols, self._colours = symbols, colours
        self.setMouseEnabled(x=False, y=False)
        self.view_box.setXRange(0, 1)
        self._knot, self._hover = self.make_upright(), self.make_upright()
        self._hover.setVisible(False)
        self._lines = [self.make_line() for _ in symbols]
        self._texts = [self.make_text() for _ in symbols]

    def show_theme(self, theme: Theme) -> None:
        super().show_theme(theme)
        self._knot.setPen(self.pen(theme.axis, 1, Qt.PenStyle.DashLine))
        self._hover.setPen(self.pen(theme.ink, 1))
        for line, text, html, colour in zip(self._lines, self._texts, self.legend(), self.series, strict=True):
            line.setPen(self.pen(colour, 1.8))
            text.setHtml(html)
            text.fill = make_brush(theme.background)

    @property
    def series(self) -> list[Rgb]:
        """The functions' colours."""
        return [self.colours.series[number] for number in self._colours]

    @property
    def values(self) -> Array:
        """What is drawn at ``SAMPLES``, (n, k)."""
        return np.stack([line.getData()[1] for line in self._lines], axis=1)

    def legend(self, values: Array | None = None, *, decimals: int = 3, named: bool = True) -> list[str]:
        """Return the functions' names in their colours as rich text, with their values where they are given."""
        names = self._symbols if named else [""] * len(self._symbols)
        return legend_of(names, self.series, values, decimals)

    def show_functions(self, values: Array, u_ip: float, bounds: tuple[float, float]) -> None:
        """Show the functions' values at ``SAMPLES``, (n, k), in a range that holds ``bounds`` at least."""
        for k, line in enumerate(self._lines):
            line.setData(SAMPLES, values[:, k])
        low, high = bounds
        for k, place in enumerate(label_places(np.where((low < values) & (values < high), values, np.nan))):
            self._texts[k].setPos(float(SAMPLES[place]), float(values[place, k]))
        self._knot.setValue(u_ip)
        self.view_box.setYRange(*bounds)
        self.settle()

    def show_hover(self, u: float | None) -> None:
        """Mark a parameter; None takes the mark away."""
        self._hover.setVisible(u is not None)
        if u is not None:
            self._hover.setValue(u)


class WeightsPlot(FunctionPlot):
    """The weights of the parabolas, or of the points."""

    def show_weights(self, values: Array, u_ip: float) -> None:
        """Show weights at ``SAMPLES``, (n, k)."""
        low, high = min(0.0, float(values.min())), max(1.0, float(values.max()))
        room = _HEADROOM * (high - low)
        self.show_functions(values, u_ip, (low - room, high + room))


def legend_of(names: Sequence[str], colours: Sequence[Rgb], values: Array | None, decimals: int) -> list[str]:
    """Return functions' names in their colours as rich text, with their values where they are given."""
    if values is not None:
        numbers = (fixed_text(value, decimals) for value in values)
        names = [f"{name} {number}".strip() for name, number in zip(names, numbers, strict=True)]
    return [coloured(name, colour) for name, colour in zip(names, colours, strict=True)]
