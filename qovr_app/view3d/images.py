"""What is seen, as an image or as the panels of a figure."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import partial

from PySide6.QtCore import QPoint, QRectF
from PySide6.QtGui import QColor, QImage, QPainter
from PySide6.QtWidgets import QWidget

from qovr_app.style.canvas import blank_image, painting
from qovr_app.style.theme import Theme
from qovr_app.view3d.figure.figure import Panel
from qovr_app.view3d.painter.backdrop import draw_backdrop
from qovr_app.view3d.painter.overlay import draw_overlay
from qovr_app.view3d.scene.picture import Picture
from qovr_app.view3d.viewport import Viewport


def view_image(view: QWidget, viewports: Sequence[Viewport], theme: Theme) -> QImage:
    """Return what the viewports of a view show, side by side as they are, at the device's resolution."""
    ratio = view.devicePixelRatioF()
    result = blank_image((view.width(), view.height()), ratio)
    result.fill(QColor(*theme.grid))
    with painting(result) as painter:
        for viewport in viewports:
            part = viewport.image()
            part.setDevicePixelRatio(ratio)
            painter.drawImage(viewport.widget.mapTo(view, QPoint(0, 0)), part)
    return result


def figure_panel(viewport: Viewport, picture: Picture) -> Panel:
    """Return a viewport as a part of a figure: at rest, and without what the mouse points at."""
    at_rest = replace(picture, moving=False, hovered=None, hand=None)
    return Panel(at_rest, viewport.logical_size, partial(_draw, viewport))


def _draw(viewport: Viewport, painter: QPainter, panel: Panel, scale: float, transparent: bool) -> None:
    picture, size = panel.picture, panel.size
    draw_backdrop(painter, picture, size, transparent=transparent)
    if picture.settings.surface:
        pixels = round(size[0] * scale), round(size[1] * scale)
        image = viewport.surface_image(picture, (pixels[0] / scale, pixels[1] / scale), pixels)
        painter.drawImage(QRectF(0, 0, *size), image)
    draw_overlay(painter, picture, size)
