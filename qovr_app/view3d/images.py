"""What is seen, as an image or as the panels of a figure."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QPoint, QRectF
from PySide6.QtGui import QColor, QImage, QPainter
from PySide6.QtWidgets import QWidget

from qovr_app.state.figure_options import FigureOptions
from qovr_app.style.canvas import blank_image, painting
from qovr_app.style.theme import Theme
from qovr_app.view3d.painter.backdrop import backdrop
from qovr_app.view3d.painter.overlay import overlay
from qovr_app.view3d.painter.paint import paint
from qovr_app.view3d.scene.picture import Picture
from qovr_app.view3d.viewport import Viewport
from qovr_app.work.gui_calls import InGui
from qovr_core import FileError
from qovr_core.files.progress import Progress

if TYPE_CHECKING:
    from qovr_app.view3d.figure.figure import Panel

_DRAWN = 0.7
"""Part of the time of a figure after which it is drawn; the rest is for the file."""


def view_image(view: QWidget, viewports: Sequence[Viewport], theme: Theme) -> QImage:
    """Return what the viewports of a view show, where they are, at the device's resolution."""
    ratio = view.devicePixelRatioF()
    result = blank_image((view.width(), view.height()), ratio)
    result.fill(QColor(*theme.grid))
    with painting(result) as painter:
        for viewport in viewports:
            part = viewport.image()
            part.setDevicePixelRatio(ratio)
            painter.drawImage(viewport.widget.mapTo(view, QPoint(0, 0)), part)
    return result


FigureWriter = Callable[[Path, FigureOptions, Progress, InGui], None]
"""Writes a figure, from whatever thread, or raises FileError; what its progress raises cancels it."""


def figure_writer(seen: Sequence[tuple[Viewport, Picture]], *, refit: bool) -> FigureWriter:
    """Return what writes the pictures of viewports as one figure: as they are now, whenever it is called.

    Parameters
    ----------
    refit : fit each camera to the figure's shape, as the view fits it to the window's
    """
    from qovr_app.view3d.figure.figure import Panel, save_figure

    at_rest = [
        (viewport, viewport.logical_size, replace(picture, moving=False, hovered=None, hand=None))
        for viewport, picture in seen
    ]

    def write(path: Path, options: FigureOptions, progress: Progress, in_gui: InGui) -> None:
        if not at_rest:
            raise FileError(f"{path}: there is no surface to draw; configure one first")
        panels = [
            Panel(
                picture, size, partial(_draw, partial(_surface, viewport, _part_of(progress, k, len(at_rest)), in_gui))
            )
            for k, (viewport, size, picture) in enumerate(at_rest)
        ]
        save_figure(path, panels, options, refit=refit)

    return write


def _part_of(progress: Progress, k: int, count: int) -> Progress:
    """Return the progress of one of several drawings, after which all of it is still to be packed."""
    return lambda part: progress((k + part) / count * _DRAWN)


def _surface(viewport: Viewport, progress: Progress, in_gui: InGui, panel: Panel, scale: float) -> QImage:
    """Return the surface of a panel, with so many pixels a logical one."""
    pixels = round(panel.size[0] * scale), round(panel.size[1] * scale)
    laid_out = (pixels[0] / scale, pixels[1] / scale)
    image = viewport.surface_image(panel.picture, laid_out, pixels, progress, in_gui)
    progress(1.0)
    return image


def _draw(
    surface: Callable[[Panel, float], QImage], painter: QPainter, panel: Panel, scale: float, transparent: bool
) -> None:
    picture, size = panel.picture, panel.size
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    if not transparent:
        painter.fillRect(QRectF(0, 0, *size), QColor(*picture.theme.background))
    paint(painter, backdrop(picture, size, filled=not transparent))
    if picture.settings.surface:
        painter.drawImage(QRectF(0, 0, *size), surface(panel, scale))
    paint(painter, overlay(picture, size))
