"""The colours of fields and marks, light and dark; all else is the system's palette."""

from __future__ import annotations

from dataclasses import dataclass

from PySide6.QtGui import QColor, QFont, QPalette

from qovr_app.state.display import ThemeName
from qovr_app.style.theme import theme_of
from qovr_app.window.application import theme

SPACE = 4
"""The grid on which every distance in the panels is a multiple."""

_SMALLER = 0.88
"""Small text against the window's own."""


@dataclass(frozen=True)
class Look:
    """Colours of one theme.

    ``cell`` and ``edge`` are a field at rest, ``hover`` its edge under the pointer; ``accent`` marks focus and what is
    not yet set, ``warn`` what will surprise, ``bad`` what is refused; the ``*_cell`` colours lie behind text.
    """

    cell: QColor
    edge: QColor
    hover: QColor
    ink: QColor
    quiet: QColor
    accent: QColor
    accent_cell: QColor
    warn: QColor
    warn_cell: QColor
    bad: QColor
    bad_cell: QColor


_LOOKS = {
    ThemeName.LIGHT: Look(
        cell=QColor(255, 255, 255),
        edge=QColor(208, 211, 217),
        hover=QColor(150, 156, 166),
        ink=QColor(32, 36, 42),
        quiet=QColor(112, 118, 127),
        accent=QColor(*theme_of(ThemeName.LIGHT).accent),
        accent_cell=QColor(225, 236, 255),
        warn=QColor(176, 104, 0),
        warn_cell=QColor(255, 243, 217),
        bad=QColor(198, 40, 40),
        bad_cell=QColor(255, 230, 228),
    ),
    ThemeName.DARK: Look(
        cell=QColor(30, 32, 36),
        edge=QColor(74, 78, 86),
        hover=QColor(120, 126, 136),
        ink=QColor(232, 234, 238),
        quiet=QColor(148, 154, 163),
        accent=QColor(*theme_of(ThemeName.DARK).accent),
        accent_cell=QColor(36, 56, 88),
        warn=QColor(240, 180, 80),
        warn_cell=QColor(66, 52, 26),
        bad=QColor(255, 122, 115),
        bad_cell=QColor(78, 34, 34),
    ),
}


def look() -> Look:
    """Return the colours of the theme in force."""
    return _LOOKS[theme()]


def number_font(font: QFont) -> QFont:
    """Return a font whose digits are equally wide."""
    result = QFont(font)
    result.setFeature(QFont.Tag("tnum"), 1)
    return result


def small_number_font(font: QFont) -> QFont:
    """Return a number font for what stands beside or below other text."""
    result = number_font(font)
    result.setPointSizeF(_SMALLER * font.pointSizeF())
    return result


def see_through(palette: QPalette) -> QPalette:
    """Return a palette whose fields have no background of their own: the cell behind is painted by the field."""
    result = QPalette(palette)
    result.setColor(QPalette.ColorRole.Base, QColor(0, 0, 0, 0))
    return result
