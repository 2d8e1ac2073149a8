"""Which line is what, wherever lines of several kinds lie over the surface."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from qovr_app.view3d.painter.lines import Family
from qovr_app.view3d.painter.note import plate
from qovr_app.view3d.painter.text import SMALL, lettered, text_size, with_subscripts
from qovr_app.view3d.scene.camera import Size
from qovr_app.view3d.scene.marks import Box, Cap, Ink, Lines, Mark, Pen
from qovr_app.view3d.scene.picture import Picture

_CORNER, _BELOW_CAPTION = 8.0, 32.0
_PAD, _ROW, _LINE, _GAP = 7.0, 16.0, 20.0, 7.0
_LEAST_WIDTH = 2.0

Room = tuple[float, float, float, float]
"""Left, top, right and bottom in logical pixels."""


def legend_room(picture: Picture, families: Sequence[Family], size: Size) -> Room | None:
    """Return where the legend lies: in the upper left, or out of the way of what is read off there.

    None where the net alone is drawn, which needs none.
    """
    names = _entries(families)
    if not picture.settings.legend or not any(lines.needs_name for lines in families):
        return None
    width = 2 * _PAD + _LINE + _GAP + max(text_size(with_subscripts(name), SMALL)[0] for name in names)
    left, top = _CORNER, _BELOW_CAPTION if picture.caption else _CORNER
    if picture.probed is not None:
        left = size[0] - _CORNER - width
    return left, top, left + width, top + 2 * _PAD + _ROW * len(names)


def legend(picture: Picture, families: Sequence[Family], size: Size) -> Iterator[Mark]:
    """Yield a line of every kind beside its name."""
    room, theme = legend_room(picture, families, size), picture.theme
    if room is None:
        return
    left, top, right, bottom = room
    yield plate(Box(left, top, right - left, bottom - top), theme)
    for k, (name, lines) in enumerate(_entries(families).items()):
        x, y = left + _PAD, top + _PAD + (k + 0.5) * _ROW
        pen = Pen(Ink(lines.colour), max(_LEAST_WIDTH, 1.2 * lines.width), Cap.FLAT)
        yield Lines(np.array([[[x, y], [x + _LINE, y]]]), pen)
        yield lettered(with_subscripts(name), (x + _LINE + _GAP, y), (0, 0.5), theme.ink)


def _entries(families: Sequence[Family]) -> dict[str, Family]:
    """Return each kind of lines by its name, as they are drawn."""
    return {lines.name: lines for lines in families if lines.name}
