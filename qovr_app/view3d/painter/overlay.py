"""What lies over the surface: boxes, control net, curves, points, labels, colour bar.

One function draws it on the screen, in the painter's fallback and in figures. What the surface hides is
drawn dim, so that it can still be seen and picked.
"""

from __future__ import annotations

from PySide6.QtCore import QLineF
from PySide6.QtGui import QColor, QPainter, QPen

from qovr_app.view3d.painter.colour_bar import draw_colour_bar
from qovr_app.view3d.painter.hand import draw_hand
from qovr_app.view3d.painter.lines import COMPARISON_WIDTH, draw_lines, lines_of
from qovr_app.view3d.painter.net_points import draw_labels, draw_points
from qovr_app.view3d.painter.note import draw_hint, draw_note
from qovr_app.view3d.painter.readout import draw_readout
from qovr_app.view3d.painter.text import NORMAL, draw_text, plain, text_size
from qovr_app.view3d.painter.triad import draw_triad
from qovr_app.view3d.scene.camera import Size
from qovr_app.view3d.scene.occlusion import hidden_among
from qovr_app.view3d.scene.picture import Picture, has_colour_bar

LEAVES_FRAME = "Something lies outside the axes: F fits"

_LEGEND, _LEGEND_LINE, _LEGEND_GAP = (14.0, 20.0), 22.0, 20.0
"""Where the legend of a surface drawn over another begins without a caption, its line, and its distance from one."""


def draw_overlay(painter: QPainter, picture: Picture, size: Size) -> None:
    """Draw everything that lies over the surface; the painter's units are logical pixels."""
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    families, points, settings = lines_of(picture, size), picture.scene.points, picture.settings
    marks = [*(lines.points for lines in families), points]
    flags = hidden_among(picture, marks, size)
    places = [picture.camera.project(part, size)[..., :2] for part in marks]
    for lines, at, is_hidden in zip(families, places, flags, strict=False):
        draw_lines(painter, lines, at, is_hidden)
    if settings.control_points:
        draw_points(painter, picture, places[-1], flags[-1], size)
    if settings.labels:
        draw_labels(painter, picture, places[-1], flags[-1], size)
    draw_triad(painter, picture, size)
    draw_hand(painter, picture, size)
    _draw_words(painter, picture, size)


def _draw_words(painter: QPainter, picture: Picture, size: Size) -> None:
    """Draw what says in words and numbers what is seen."""
    settings = picture.settings
    if picture.scene.lines_name:
        _draw_legend(painter, picture)
    if has_colour_bar(settings, size):
        draw_colour_bar(painter, picture, size)
    if settings.surface and picture.colouring.note:
        draw_note(painter, picture.colouring.note, picture.theme, size)
    if picture.leaves_frame:
        draw_hint(painter, LEAVES_FRAME, picture.theme, size)
    if picture.probed is not None:
        draw_readout(painter, picture, picture.probed, size)


def _draw_legend(painter: QPainter, picture: Picture) -> None:
    """Say whose lines lie over the surface."""
    theme, (x, y) = picture.theme, _LEGEND
    if picture.caption:
        x += text_size(plain(picture.caption), NORMAL)[0] + _LEGEND_GAP
    painter.setPen(QPen(QColor(*theme.comparison), 2 * COMPARISON_WIDTH))
    painter.drawLine(QLineF(x, y, x + _LEGEND_LINE, y))
    text = plain(picture.scene.lines_name)
    draw_text(painter, text, (x + _LEGEND_LINE + 7, y), (0, 0.5), theme.ink, pixels=NORMAL, halo=theme.rim)
