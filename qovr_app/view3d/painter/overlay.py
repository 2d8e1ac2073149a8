"""What lies over the surface: boxes, control net, curves, points, labels, colour bar.

What the surface hides is drawn dim, so that it can still be seen and picked.
"""

from __future__ import annotations

from collections.abc import Iterator

from qovr_app.view3d.painter.colour_bar import colour_bar
from qovr_app.view3d.painter.hand import hand_marks
from qovr_app.view3d.painter.legend import legend, legend_room
from qovr_app.view3d.painter.lines import line_marks, lines_of
from qovr_app.view3d.painter.measure import measure
from qovr_app.view3d.painter.net_points import SeenNet, net_points, point_labels
from qovr_app.view3d.painter.note import hint, note
from qovr_app.view3d.painter.readout import readout
from qovr_app.view3d.painter.triad import triad
from qovr_app.view3d.scene.camera import Size
from qovr_app.view3d.scene.marks import Mark
from qovr_app.view3d.scene.net_marks import shown_part
from qovr_app.view3d.scene.occlusion import hidden_among
from qovr_app.view3d.scene.picture import Picture, has_colour_bar

LEAVES_FRAME = "Something lies outside the axes: F fits"


def overlay(picture: Picture, size: Size) -> Iterator[Mark]:
    """Yield everything that lies over the surface, the lowest first; ``size`` is the viewport's in logical pixels."""
    families, settings, part = lines_of(picture, size), picture.settings, shown_part(picture)
    marks = [*(lines.points for lines in families), part.of(picture.net_points)]
    flags = hidden_among(picture, marks, size)
    places = [picture.camera.project(part, size)[..., :2] for part in marks]
    for lines, at, is_hidden in zip(families, places, flags, strict=False):
        yield from line_marks(lines, at, is_hidden)
    net = SeenNet(picture.scene.net_shape, part, places[-1], flags[-1])
    if settings.control_points:
        yield from net_points(picture, net, size)
    if settings.labels:
        yield from point_labels(picture, net, size, legend_room(picture, families, size))
    yield from legend(picture, families, size)
    yield from triad(picture, size)
    yield from hand_marks(picture, size)
    yield from measure(picture, size)
    yield from _words(picture, size)


def _words(picture: Picture, size: Size) -> Iterator[Mark]:
    """Yield what says in words and numbers what is seen."""
    settings = picture.settings
    if has_colour_bar(settings, size):
        yield from colour_bar(picture, size)
    if settings.surface and picture.colouring.note:
        yield from note(picture.colouring.note, picture.theme, size)
    if picture.leaves_frame:
        yield hint(LEAVES_FRAME, picture.theme, size)
    if picture.probed is not None:
        yield from readout(picture, picture.probed, size)
