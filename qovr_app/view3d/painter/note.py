"""A sentence over the picture: why it shows nothing, and what to do about it."""

from __future__ import annotations

from collections.abc import Iterator

from qovr_app.style.theme import Theme
from qovr_app.view3d.painter.text import NORMAL, lettered, plain, text_size, wrapped
from qovr_app.view3d.scene.camera import Size
from qovr_app.view3d.scene.marks import Box, Ink, Mark, Pen, Rectangle

_TOP = 46.0
"""Below the mark of a stale surface."""

_PAD_X, _PAD_Y, _LEADING = 10.0, 6.0, 18.0
_SIDE = 48.0
_OPACITY = 0.92
_HINT_BOTTOM = 8.0
_RADIUS = 4.0


def note(text: str, theme: Theme, size: Size) -> Iterator[Mark]:
    """Yield a text on a plate in the upper middle of the viewport; the letters after ``_`` are a subscript."""
    lines = wrapped(text, NORMAL, size[0] - 2 * _SIDE)
    width = max(text_size(line, NORMAL)[0] for line in lines) + 2 * _PAD_X
    left = round((size[0] - width) / 2)
    yield plate(Box(left, _TOP, width, _LEADING * len(lines) + 2 * _PAD_Y), theme)
    for k, line in enumerate(lines):
        middle = left + width / 2, _TOP + _PAD_Y + _LEADING * (k + 0.5)
        yield lettered(line, middle, (0.5, 0.5), theme.ink, pixels=NORMAL)


def hint(text: str, theme: Theme, size: Size) -> Mark:
    """Return a quiet line at the bottom of the viewport."""
    place = size[0] / 2, size[1] - _HINT_BOTTOM
    return lettered(plain(text), place, (0.5, 1), theme.quiet_ink, pixels=NORMAL, halo=theme.background)


def plate(box: Box, theme: Theme) -> Mark:
    """Return the ground on which words can be read whatever lies behind."""
    inside = Box(box.left + 0.5, box.top + 0.5, box.width - 1, box.height - 1)
    return Rectangle(inside, _RADIUS, Pen(Ink(theme.grid), 1.0), Ink(theme.pane, _OPACITY))
