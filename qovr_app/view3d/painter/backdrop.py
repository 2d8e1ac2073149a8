"""What lies behind the surface: background, panes, grid, ticks and titles of the axes box, and a reference picture."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from qovr_app.style.theme import Theme
from qovr_app.view3d.painter.axis_texts import TICK_LENGTH, axis_texts
from qovr_app.view3d.painter.colour_bar import bar_rect
from qovr_app.view3d.painter.text import NORMAL, lettered, plain
from qovr_app.view3d.painter.underlay import underlay
from qovr_app.view3d.scene.axes import AxisEdge, axes_box
from qovr_app.view3d.scene.camera import Size
from qovr_app.view3d.scene.marks import Ink, Lines, Mark, Pen, Polygon
from qovr_app.view3d.scene.picture import Picture, emphasis, has_colour_bar


def backdrop(picture: Picture, size: Size, *, filled: bool = True) -> Iterator[Mark]:
    """Yield everything that lies between the background and the surface, the lowest first.

    Parameters
    ----------
    size : the viewport in logical pixels
    filled : whether the panes have a colour of their own, which figures that lie on another page have not
    """
    theme = picture.theme
    grid = Pen(Ink(theme.grid), 1.0)
    box = axes_box(picture.scene.frame, picture.camera, size) if picture.settings.axes else None
    if box is not None:
        for corners in box.panes:
            yield Polygon(corners, grid, Ink(theme.pane) if filled else None)
    yield from underlay(picture, size)
    if box is not None:
        yield Lines(box.grid, grid)
        for edge in box.edges:
            yield from _edge(edge, theme)
        right = bar_rect(size).left() if has_colour_bar(picture.settings, size) else size[0]
        yield from axis_texts(box.edges, theme, (right, size[1]), emphasis(size))
    if picture.caption:
        pixels = round(emphasis(size) * NORMAL)
        yield lettered(plain(picture.caption), (14, 12), (0, 0), theme.quiet_ink, pixels=pixels)


def _edge(edge: AxisEdge, theme: Theme) -> Iterator[Mark]:
    pen = Pen(Ink(theme.axis), 1.0)
    yield Lines(np.array([[edge.start, edge.end]]), pen)
    yield Lines(np.stack([edge.ticks, edge.ticks + TICK_LENGTH * edge.outward], axis=1), pen)
