"""How the surface looks, whoever draws it: parameter lines, point sizes, light."""

from __future__ import annotations

from qovr_app.view3d.mesh import Counts
from qovr_app.view3d.settings import DisplaySettings, Style

POINT_SIZE = 3.0
"""Logical pixels across a sample in the style of points."""

_LINE_WIDTHS = {Style.FACETS: 1.0, Style.SMOOTH: 1.0, Style.WIREFRAME: 1.1, Style.POINTS: 0.0}
_LINE_OPACITIES = {Style.FACETS: 0.62, Style.SMOOTH: 0.30, Style.WIREFRAME: 1.0, Style.POINTS: 0.0}

_COARSE_LINES = 20
"""Lines a side that stay while finer ones fade for want of room; each is a round number of samples apart."""

_FINE_LINES = 100
_ROUND = (1, 2, 5)


def line_width(style: Style) -> float:
    """Return the width of parameter lines in logical pixels."""
    return _LINE_WIDTHS[style]


def line_opacity(settings: DisplaySettings) -> float:
    """Return the opacity of parameter lines; 0 means none."""
    shown = settings.parameter_lines or settings.style is Style.WIREFRAME
    return _LINE_OPACITIES[settings.style] if shown else 0.0


def line_periods(samples: Counts) -> tuple[tuple[float, float], tuple[float, float]]:
    """Return after how many samples along u and v a fine and a coarse parameter line comes."""
    fine, coarse = (
        tuple(float(_period(count - 1, lines)) for count in samples) for lines in (_FINE_LINES, _COARSE_LINES)
    )
    return fine, coarse


def _period(cells: int, lines: int) -> int:
    """Return the smallest of 1, 2, 5, 10, ... cells that makes no more than ``lines`` lines."""
    power = 1
    while True:
        for factor in _ROUND:
            if cells <= lines * factor * power:
                return factor * power
        power *= 10
