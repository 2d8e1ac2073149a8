"""Fonts for numbers."""

from __future__ import annotations

from PySide6.QtGui import QFont

_SMALLER = 0.88
"""Small text against the window's own."""


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
