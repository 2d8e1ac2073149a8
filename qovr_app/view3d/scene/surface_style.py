"""How the surface looks, whoever draws it: parameter lines, point sizes, light."""

from __future__ import annotations

from qovr_app.state.display import UNCOLOURED, DisplaySettings, Style
from qovr_app.view3d.scene.grid import Counts
from qovr_app.view3d.scene.patterns import PATTERNS
from qovr_core.fields import FIELDS

POINT_SIZE = 3.0
"""Logical pixels across a sample in the style of points."""

_LINE_WIDTHS = {Style.FACETS: 1.0, Style.SMOOTH: 1.0, Style.CLAY: 1.0, Style.WIREFRAME: 1.1, Style.POINTS: 0.0}
_LINE_OPACITIES = {Style.FACETS: 0.62, Style.SMOOTH: 0.30, Style.CLAY: 0.22, Style.WIREFRAME: 1.0, Style.POINTS: 0.0}

_FIELD_LINES = 0.55
"""Over anything but coordinates facets have lines that much paler: pale colours are to be read through them."""

_PATTERN_LINES = 0.4
"""Over stripes and bands, which are lines themselves, parameter lines are that much paler."""

_FIELD_RELIEF = 0.45
"""Light on the smooth surface is that much weaker where colours are to be compared with those of the bar."""

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
    if settings.shown_colours in PATTERNS and settings.shown_colours != UNCOLOURED:
        paler = _PATTERN_LINES
    else:
        paler = _FIELD_LINES if settings.style is Style.FACETS and _is_read(settings) else 1.0
    return _LINE_OPACITIES[settings.style] * paler if shown else 0.0


def relief(settings: DisplaySettings) -> float:
    """Return how much of the light is seen on the smooth surface, from 0 to 1."""
    return _FIELD_RELIEF if _is_read(settings) else 1.0


def _is_read(settings: DisplaySettings) -> bool:
    """Return whether the colours are read through lines and light: they say something that no axis says too."""
    field = FIELDS.get(settings.shown_colours)
    return settings.shown_colours != UNCOLOURED and (field is None or field.axis is None)


def line_periods(cells: Counts) -> tuple[tuple[float, float], tuple[float, float]]:
    """Return after how many of these cells along u and v a fine and a coarse parameter line comes."""
    n, m = cells
    fine, coarse = ((float(_period(n, most)), float(_period(m, most))) for most in (_FINE_LINES, _COARSE_LINES))
    return fine, coarse


def _period(cells: int, lines: int) -> int:
    """Return the smallest of 1, 2, 5, 10, ... cells that makes no more than ``lines`` lines."""
    power = 1
    while True:
        for factor in _ROUND:
            if cells <= lines * factor * power:
                return factor * power
        power *= 10
