"""The plate of numbers beside what the mouse drags."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass

from qovr_app.style.theme import Rgb
from qovr_app.view3d.painter.colour_bar import bar_rect
from qovr_app.view3d.painter.note import plate
from qovr_app.view3d.painter.text import NORMAL, SMALL, lettered, plain, text_size
from qovr_app.view3d.scene.camera import Size
from qovr_app.view3d.scene.marks import Box, Mark, Runs
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


def beside(picture: Picture, point: Array, words: Words, size: Size) -> Iterator[Mark]:
    """Yield a plate beside a point (3,) of the unit space; it never lies over the colour bar."""
    x, y = picture.camera.project(point[None], size)[0, :2].tolist()
    if not math.isfinite(x):
        return
    width = max(text_size(words.line, NORMAL)[0], text_size(plain(words.below), SMALL)[0]) + 2 * _PAD
    height = (2 if words.below else 1) * _LEADING + _PAD
    right = bar_rect(size).left() - _EDGE if has_colour_bar(picture.settings, size) else size[0] - _EDGE
    left = x + _GAP if x + _GAP + width <= right else x - _GAP - width
    left, top = min(max(left, _EDGE), right - width), min(max(y + _GAP, _EDGE), size[1] - height - _EDGE)
    yield plate(Box(left, top, width, height), picture.theme)
    middle = top + _PAD / 2 + _LEADING / 2
    yield lettered(words.line, (left + _PAD, middle), (0, 0.5), picture.theme.ink, pixels=NORMAL)
    quiet = words.colour or picture.theme.quiet_ink
    if words.below:
        yield lettered(plain(words.below), (left + _PAD, middle + _LEADING), (0, 0.5), quiet)
