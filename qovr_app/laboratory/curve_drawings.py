"""What the curve panel saves as a figure: the curve as it is shown, or as one of the paper's Figures 1 and 2."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum
from pathlib import Path
from typing import Any

from qovr_app.state.figure_options import FigureOptions
from qovr_core import Document, FileError
from qovr_core.laboratory.one_curve import OneCurve
from qovr_core.laboratory.planes import View

_SCREEN_DPI = 96
_ROUNDING = 1e-6
"""Part of a pixel without which a side in inches, multiplied again, could lose a whole one."""

_LEAST_MILLIMETRES = (100, 75)
"""A figure with four plots and their names has no room below this."""


class Drawing(StrEnum):
    """What is drawn; the value is what the panel calls it."""

    ALL_PARTS = "all parts"
    PARABOLAS = "1a: parabolas"
    KNOTS = "1b: knots"
    SENSITIVITY = "1c: sensitivity"
    NETWORK = "2: network"


@dataclass(frozen=True, eq=False)
class CurveDrawing:
    """A drawing that can be written as a figure.

    Parameters
    ----------
    drawing : what is drawn
    curve, document : the curve, and the document of the network
    view, equal_scales : the plane of the curve, and whether both its directions are drawn at one scale
    """

    drawing: Drawing
    curve: OneCurve
    document: Document
    view: View
    equal_scales: bool

    @property
    def name(self) -> str:
        """What is added to the document's name for that of a file."""
        return "network" if self.drawing is Drawing.NETWORK else self.curve.name

    def write(self, path: Path, options: FigureOptions, _report: object = None) -> None:
        """Write the drawing; there is nothing to report on the way.

        Raises
        ------
        FileError : another suffix, a size at which nothing could be read, or a file that cannot be written
        """
        from qovr_core.figures import write_figure

        options.check(path)
        width, height = options.millimetres
        if width < _LEAST_MILLIMETRES[0] or height < _LEAST_MILLIMETRES[1]:
            least = " x ".join(str(side) for side in _LEAST_MILLIMETRES)
            raise FileError(
                f"{path}: {width:.0f} x {height:.0f} mm is too small for this figure; expected at least {least} mm"
            )
        dpi = options.dpi or _SCREEN_DPI
        across, up = ((side + _ROUNDING) / dpi for side in options.pixels)
        write_figure(self._drawn((across, up)), path, dpi=dpi, transparent=options.transparent)

    def _drawn(self, size: tuple[float, float]) -> Any:
        """Return the drawing as a matplotlib Figure of a size in inches."""
        from qovr_core.figures import curves, draw_network

        if self.drawing is Drawing.NETWORK:
            return draw_network(self.document, size)
        draw = {
            Drawing.ALL_PARTS: curves.draw_curve,
            Drawing.PARABOLAS: curves.draw_parabolas,
            Drawing.KNOTS: curves.draw_knots,
            Drawing.SENSITIVITY: curves.draw_sensitivity,
        }[self.drawing]
        return draw(self.curve, curves.Sheet(self.view, size, self.equal_scales))
