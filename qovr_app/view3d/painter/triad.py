"""The axes in the corner of the view, whose ends are clicked to look from there."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from qovr_app.state.names import AXES
from qovr_app.view3d.painter.hand import axis_colours
from qovr_app.view3d.painter.text import lettered, plain
from qovr_app.view3d.scene.camera import Size
from qovr_app.view3d.scene.marks import Cap, Discs, Ink, Lines, Mark, Pen
from qovr_app.view3d.scene.picture import Picture
from qovr_app.view3d.scene.triad import REACH, has_triad, triad_centre, triad_ends

_GROUND, _USED_GROUND = 0.35, 0.85
_LOW = 0.3
"""Opacity of the ground, also under the mouse, and of the low ends."""

_AXIS_WIDTH, _RIM, _USED_RIM = 2.0, 1.2, 2.0


def triad(picture: Picture, size: Size) -> Iterator[Mark]:
    """Yield the triad for whoever has a mouse there: figures have none."""
    hand, theme = picture.hand, picture.theme
    if hand is None or not has_triad(picture.settings, size):
        return
    centre = triad_centre(size)
    ground = Ink(theme.grid, _USED_GROUND if hand.view else _GROUND)
    yield Discs(np.array([centre]), REACH, None, ground)
    for end in triad_ends(picture.camera, centre):
        colour, is_used = axis_colours(theme)[end.axis], hand.view == end.view
        if end.is_high:
            yield Lines(np.array([[centre, end.at]]), Pen(Ink(colour), _AXIS_WIDTH, Cap.ROUND))
        pen = Pen(Ink(theme.ink), _USED_RIM) if is_used else Pen(Ink(colour), _RIM)
        yield Discs(end.at[None], end.radius, pen, Ink(colour, 1.0 if end.is_high or is_used else _LOW))
        if end.is_high or is_used:
            text = AXES[end.axis].upper() if end.is_high else f"−{AXES[end.axis].upper()}"
            x, y = end.at.tolist()
            yield lettered(plain(text), (x, y), (0.5, 0.5), theme.rim)
