"""What stands at an axis: numbers at the ticks, what they have in common, and the title; nothing over one another."""

from __future__ import annotations

import math

from PySide6.QtCore import QRectF

from qovr_app.style.theme import Rgb, Theme
from qovr_app.view3d.painter.text import NORMAL, SMALL, lettered, plain, text_size
from qovr_app.view3d.scene.axes import AxisEdge
from qovr_app.view3d.scene.camera import Size
from qovr_app.view3d.scene.marks import Alignment, Place, Text

TICK_LENGTH = 4.0
_TEXT_GAP = 5.0
_BORDER = 2.0
"""Between a text and the border of the viewport."""

_UPRIGHT = 0.98
"""The part of an axis' normal that is level where the axis stands upright."""

_LINE = 15.0
_LETTER_HEIGHT = 0.8
"""Part of a text's pixel size that digits and capitals take: where these do not touch, both can be read."""


def axis_texts(edges: list[AxisEdge], theme: Theme, size: Size, larger: float) -> list[Text]:
    """Return the texts of all axes: titles and what numbers share first, then every number that covers none of them.

    Parameters
    ----------
    size : of the part of the viewport, from its upper left corner, that is free for them
    larger : how much larger than usual they are
    """
    room, small, normal = _Room(size), round(larger * SMALL), round(larger * NORMAL)
    for edge in edges:
        place, alignment = _title_place(edge, small), _alignment(edge)
        room.write(edge.title, place, alignment, theme.ink, pixels=normal)
        if edge.labels.note:
            note_place = _note_place(edge, place, alignment, larger)
            room.write(edge.labels.note, *note_place, theme.quiet_ink, pixels=small)
    for edge in edges:
        places = edge.ticks + (TICK_LENGTH + _TEXT_GAP) * edge.outward
        for (x, y), text in zip(places.tolist(), edge.labels.texts, strict=True):
            room.write(text, (x, y), _alignment(edge), theme.quiet_ink, pixels=small, is_dispensable=True)
    return room.texts


def _alignment(edge: AxisEdge) -> Alignment:
    x, y = edge.outward.tolist()
    return 0.5 - x / 2, 0.5 - y / 2


def _title_place(edge: AxisEdge, pixels: int) -> Place:
    """Return the middle of the axis, farther out than its numbers."""
    across, down = (abs(part) for part in edge.outward.tolist())
    sizes = [text_size(plain(text), pixels) for text in edge.labels.texts]
    reach = max((across * width + down * height for width, height in sizes), default=0.0)
    x, y = ((edge.start + edge.end) / 2 + (TICK_LENGTH + 2 * _TEXT_GAP + reach) * edge.outward).tolist()
    return x, y


def _note_place(edge: AxisEdge, title: Place, alignment: Alignment, larger: float) -> tuple[Place, Alignment]:
    """Return place and alignment of what the numbers share: over an upright axis, else in a line after the title."""
    if abs(edge.outward[0]) > _UPRIGHT:
        x, y = min(edge.start.tolist(), edge.end.tolist(), key=lambda end: end[1])
        return (x, y - 2 * _TEXT_GAP), (0.5, 1.0)
    return (title[0], title[1] + math.copysign(larger * _LINE, edge.outward[1])), alignment


class _Room:
    """A viewport in which no dispensable text covers another one, and none is cut off that begins in it."""

    def __init__(self, size: Size) -> None:
        self._size = size
        self._taken: list[QRectF] = []
        self.texts: list[Text] = []

    def write(
        self,
        text: str,
        anchor: Place,
        alignment: Alignment,
        colour: Rgb,
        *,
        pixels: int,
        is_dispensable: bool = False,
    ) -> None:
        width, height = text_size(plain(text), pixels)
        x, y = anchor[0] - alignment[0] * width, anchor[1] - alignment[1] * height
        if 0 <= anchor[0] <= self._size[0] and 0 <= anchor[1] <= self._size[1]:
            x = max(_BORDER, min(x, self._size[0] - _BORDER - width))
            y = max(_BORDER, min(y, self._size[1] - _BORDER - height))
        letters = pixels * _LETTER_HEIGHT
        covered = QRectF(x, y + (height - letters) / 2, width, letters)
        if is_dispensable and any(covered.intersects(other) for other in self._taken):
            return
        self._taken.append(covered)
        self.texts.append(lettered(plain(text), (x, y), (0, 0), colour, pixels=pixels))
