"""What lies behind the surface: background, panes, grid, ticks and titles of the axes box."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import QLineF, QPointF, QRectF
from PySide6.QtGui import QColor, QPainter, QPen, QPolygonF

from qovr_app.style.theme import Theme
from qovr_app.view3d.painter.axis_texts import TICK_LENGTH, draw_axis_texts
from qovr_app.view3d.painter.colour_bar import bar_rect
from qovr_app.view3d.painter.text import NORMAL, draw_text, plain
from qovr_app.view3d.painter.underlay import draw_underlay
from qovr_app.view3d.scene.axes import AxisEdge, axes_box
from qovr_app.view3d.scene.camera import Size
from qovr_app.view3d.scene.picture import Picture, emphasis, has_colour_bar
from qovr_core.arrays import Array


def backdrop_key(picture: Picture, size: Size) -> tuple[object, ...]:
    """Return what the backdrop depends on: while it stays equal, a drawn backdrop can be used again."""
    limits, settings = picture.scene.frame.limits.tobytes(), picture.settings
    has_bar = settings.underlay, has_colour_bar(settings, size)
    return size, picture.camera, limits, settings.axes, settings.theme, settings.scaling, has_bar, picture.caption


def draw_backdrop(painter: QPainter, picture: Picture, size: Size, *, transparent: bool = False) -> None:
    """Draw everything that lies behind the surface.

    Parameters
    ----------
    size : the viewport in logical pixels, which are the painter's units
    transparent : leave the background and the panes out, for figures that lie on another page
    """
    theme = picture.theme
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    if not transparent:
        painter.fillRect(QRectF(0, 0, *size), QColor(*theme.background))
    box = axes_box(picture.scene.frame, picture.camera, size) if picture.settings.axes else None
    if box is not None:
        _draw_panes(painter, box.panes, theme, filled=not transparent)
    draw_underlay(painter, picture, size)
    if box is not None:
        painter.setPen(QPen(QColor(*theme.grid), 1.0))
        painter.drawLines(_lines(box.grid))
        for edge in box.edges:
            _draw_edge(painter, edge, theme)
        right = bar_rect(size).left() if has_colour_bar(picture.settings, size) else size[0]
        draw_axis_texts(painter, box.edges, theme, (right, size[1]), emphasis(size))
    if picture.caption:
        draw_text(
            painter, plain(picture.caption), (14, 12), (0, 0), theme.quiet_ink, pixels=round(emphasis(size) * NORMAL)
        )


def _lines(ends: Array) -> list[QLineF]:
    return [QLineF(*line) for line in ends.reshape(-1, 4).tolist()]


def _draw_panes(painter: QPainter, panes: Array, theme: Theme, *, filled: bool) -> None:
    painter.setPen(QPen(QColor(*theme.grid), 1.0))
    if filled:
        painter.setBrush(QColor(*theme.pane))
    for corners in panes.tolist():
        painter.drawPolygon(QPolygonF([QPointF(*corner) for corner in corners]))


def _draw_edge(painter: QPainter, edge: AxisEdge, theme: Theme) -> None:
    painter.setPen(QPen(QColor(*theme.axis), 1.0))
    painter.drawLine(QLineF(*edge.start.tolist(), *edge.end.tolist()))
    tips = edge.ticks + TICK_LENGTH * edge.outward
    painter.drawLines(_lines(np.stack([edge.ticks, tips], axis=1)))
