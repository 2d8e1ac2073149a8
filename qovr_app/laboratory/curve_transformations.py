"""The transformations r(u), s(u), t(u) among the plots of a curve's parts."""

from __future__ import annotations

from PySide6.QtWidgets import QWidget

from qovr_app.laboratory.curve_functions import legend_of
from qovr_app.state.focus import in_window
from qovr_app.state.knot_in_hand import KnotInHand
from qovr_app.store import Store
from qovr_app.style.palette import theme_in_force
from qovr_app.style.theme import KNOT_SERIES
from qovr_app.widgets.knot_plot import KnotPlot
from qovr_core.arrays import Array
from qovr_core.geometry.knots import KnotPlace
from qovr_core.laboratory.one_curve import PARABOLA_LETTERS, OneCurve


class TransformationsPlot(KnotPlot):
    """The plot that stands under the knots too, with a legend as the other plots of a curve have."""

    def __init__(self, store: Store, parent: QWidget | None = None) -> None:
        super().__init__("laboratory.curve.transformations", store, parent)

    def show_part(self, curve: OneCurve) -> None:
        """Show the transformations of a curve of the window in focus."""
        place = in_window(KnotPlace(curve.direction, curve.number, "u"), self._store.shown.window)
        self.show_curve(KnotInHand(place, curve.knots))

    def legend(self, values: Array | None = None, *, decimals: int = 3, named: bool = True) -> list[str]:
        """Return r, s and t in their colours as rich text, with their values where they are given."""
        names = [f"<i>{letter}</i>" if named else "" for letter in PARABOLA_LETTERS]
        series = theme_in_force().series
        return legend_of(names, [series[KNOT_SERIES[letter]] for letter in PARABOLA_LETTERS], values, decimals)
