"""The plate of numbers beside what the mouse drags."""

from __future__ import annotations

import math
from dataclasses import dataclass

from PySide6.QtCore import QRectF
from PySide6.QtGui import QPainter

from qovr_app.style.theme import Rgb
from qovr_app.view3d.painter.colour_bar import bar_rect
from qovr_app.view3d.painter.note import draw_plate
from qovr_app.view3d.painter.text import NORMAL, SMALL, Runs, draw_text, plain, text_size
from qovr_app.view3d.scene.camera import Size
from qovr_app.view3d.scene.picture import Picture, has_colour_bar
from qovr_core.arrays import Array

_GAP, _PAD, _LEADING = 16.0, 8.0, 17.0
_EDGE = 6.0
"""Pixels that the plate of numbers keeps from the viewport's sides and from the colour bar."""


@dataclass(frozen=True)
class Words:
    """What stands on the plate: a line, and a quiet one below it, or one in a colour; or none."""

    line: Runs
    below: str
    colour: Rgb | None = None


def draw_beside(painter: QPainter, picture: Picture, point: Array, words: Words, size: Size) -> None:
    """Draw a plate beside a point (3,) of the unit space; it never lies over the colour bar."""
    x, y = picture.camera.project(point[None], size)[0, :2].tolist()
    if not math.isfinite(x):
        return
    width = max(text_size(words.line, NORMAL)[0], text_size(plain(words.below), SMALL)[0]) + 2 * _PAD
    height = (2 if words.below else 1) * _LEADING + _PAD
    right = bar_rect(size).left() - _EDGE if has_colour_bar(picture.settings, size) else size[0] - _EDGE
    left = x + _GAP if x + _GAP + width <= right else x - _GAP - width
    plate = QRectF(
        min(max(left, _EDGE), right - width), min(max(y + _GAP, _EDGE), size[1] - height - _EDGE), width, height
    )
    draw_plate(painter, plate, picture.theme)
    top = plate.top() + _PAD / 2 + _LEADING / 2
    draw_text(painter, words.line, (plate.left() + _PAD, top), (0, 0.5), picture.theme.ink, pixels=NORMAL)
    quiet = words.colour or picture.theme.quiet_ink
    if words.below:
        draw_text(painter, plain(words.below), (plate.left() + _PAD, top + _LEADING), (0, 0.5), quiet)
