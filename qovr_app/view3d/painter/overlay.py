"""What lies over the surface: boxes, control net, curves, points, labels, colour bar.

One function draws it on the screen, in the painter's fallback and in figures. What the surface hides is
drawn dim, so that it can still be seen and picked.
"""

from __future__ import annotations

from PySide6.QtGui import QPainter

from qovr_app.view3d.painter.colour_bar import draw_colour_bar
from qovr_app.view3d.painter.hand import draw_hand
from qovr_app.view3d.painter.legend import draw_legend, legend_room
from qovr_app.view3d.painter.lines import draw_lines, lines_of
from qovr_app.view3d.painter.measure import draw_measure
from qovr_app.view3d.painter.net_points import SeenNet, draw_labels, draw_points
from qovr_app.view3d.painter.note import draw_hint, draw_note
from qovr_app.view3d.painter.readout import draw_readout
from qovr_app.view3d.painter.triad import draw_triad
from qovr_app.view3d.scene.camera import Size
from qovr_app.view3d.scene.net_marks import shown_part
from qovr_app.view3d.scene.occlusion import hidden_among
from qovr_app.view3d.scene.picture import Picture, has_colour_bar

LEAVES_FRAME = "Something lies outside the axes: F fits"


def draw_overlay(painter: QPainter, picture: Picture, size: Size) -> None:
    """Draw everything that lies over the surface; the painter's units are logical pixels."""
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    families, settings, part = lines_of(picture, size), picture.settings, shown_part(picture)
    marks = [*(lines.points for lines in families), part.of(picture.net_points)]
    flags = hidden_among(picture, marks, size)
    places = [picture.camera.project(part, size)[..., :2] for part in marks]
    for lines, at, is_hidden in zip(families, places, flags, strict=False):
        draw_lines(painter, lines, at, is_hidden)
    net = SeenNet(picture.scene.net_shape, part, places[-1], flags[-1])
    if settings.control_points:
        draw_points(painter, picture, net, size)
    if settings.labels:
        draw_labels(painter, picture, net, size, legend_room(picture, families, size))
    draw_legend(painter, picture, families, size)
    draw_triad(painter, picture, size)
    draw_hand(painter, picture, size)
    draw_measure(painter, picture, size)
    _draw_words(painter, picture, size)


def _draw_words(painter: QPainter, picture: Picture, size: Size) -> None:
    """Draw what says in words and numbers what is seen."""
    settings = picture.settings
    if has_colour_bar(settings, size):
        draw_colour_bar(painter, picture, size)
    if settings.surface and picture.colouring.note:
        draw_note(painter, picture.colouring.note, picture.theme, size)
    if picture.leaves_frame:
        draw_hint(painter, LEAVES_FRAME, picture.theme, size)
    if picture.probed is not None:
        draw_readout(painter, picture, picture.probed, size)
