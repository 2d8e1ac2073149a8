"""Figures: what is seen, laid out again at the size of a page, as pixels or as vectors."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path

from PySide6.QtCore import QBuffer, QByteArray, QIODevice, QMarginsF, QRectF, QSize, QSizeF, Qt
from PySide6.QtGui import QColor, QImage, QImageWriter, QPageSize, QPainter, QPdfWriter

from qovr_app.state.figure_options import INCH, FigureOptions
from qovr_app.style.canvas import painting
from qovr_app.view3d.figure.pdf_metadata import same_every_time
from qovr_app.view3d.scene.camera import Size, fitted
from qovr_app.view3d.scene.picture import Picture, is_stacked, margins
from qovr_core.files.atomic import replacing

_SVG_UNITS = 2540
"""Units per inch inside an SVG, a hundred a millimetre: its size on paper is a whole number of them."""

_POINTS_PERINCH = 72


@dataclass(frozen=True, eq=False)
class Panel:
    """A viewport as a part of a figure.

    Parameters
    ----------
    picture : what it shows
    size : in logical pixels
    draw : called with a painter, whose units are logical pixels, the panel to draw, the pixels of an image that a
        logical pixel has, and whether there is no ground; draws the picture, its surface as such an image
    """

    picture: Picture
    size: Size
    draw: Callable[[QPainter, Panel, float, bool], None]


def save_figure(path: Path, panels: list[Panel], options: FigureOptions, *, refit: bool) -> None:
    """Write viewports as one figure, in a row or a stack by its shape.

    Parameters
    ----------
    refit : fit each camera to the figure's shape, as the view fits it to the window's

    Raises
    ------
    FileError : another suffix, an absurd size, or a file that cannot be written; nothing is left behind
    """
    options.check(path)
    writer = {".png": _png, ".svg": _svg, ".pdf": _pdf}[path.suffix.lower()]
    data = writer(_laid_out(panels, options, refit=refit), options)
    with replacing(path) as (draft,):
        draft.write_bytes(data.data())


@dataclass(frozen=True, eq=False)
class _Page:
    """Panels laid out in logical pixels: the drawing's own units, whatever the device."""

    panels: list[Panel]
    size: Size
    scale: float
    is_stack: bool


def _laid_out(panels: list[Panel], options: FigureOptions, *, refit: bool) -> _Page:
    """Give the page as many logical pixels as keep lettering and lines as large, in the picture, as on the
    screen."""
    count, seen, (width, height) = len(panels), panels[0].size, options.pixels
    of_view = math.sqrt(width * height / (count * seen[0] * seen[1]))
    is_stack = is_stacked((width / of_view, height / of_view), count)
    cell = (width, height / count) if is_stack else (width / count, height)
    scale = min(cell[0] / seen[0], cell[1] / seen[1])
    size = cell[0] / scale, cell[1] / scale
    placed = []
    for panel in panels:
        picture = panel.picture
        if refit:
            half, room = picture.scene.frame.half_extents, margins(picture.settings, size)
            picture = replace(picture, camera=fitted(picture.camera, half, size, room))
        placed.append(replace(panel, picture=picture, size=size))
    return _Page(placed, (width / scale, height / scale), scale, is_stack)


def _draw_page(painter: QPainter, page: _Page, *, transparent: bool) -> None:
    """Draw all panels; the painter's units are the page's logical pixels."""
    for k, panel in enumerate(page.panels):
        width, height = panel.size
        painter.save()
        try:
            painter.translate(*((0, k * height) if page.is_stack else (k * width, 0)))
            painter.setClipRect(QRectF(0, 0, width, height))
            panel.draw(painter, panel, page.scale, transparent)
        finally:
            painter.restore()  # also when it is cancelled


def _png(page: _Page, options: FigureOptions) -> QByteArray:
    image = QImage(*options.pixels, QImage.Format.Format_ARGB32_Premultiplied)
    image.fill(Qt.GlobalColor.transparent)
    image.setDevicePixelRatio(page.scale)
    with painting(image) as painter:
        _draw_page(painter, page, transparent=options.transparent)
    dots_per_metre = round(options.pixels[0] / options.millimetres[0] * 1000)
    image.setDotsPerMeterX(dots_per_metre)
    image.setDotsPerMeterY(dots_per_metre)
    data, buffer = _buffer()
    QImageWriter(buffer, QByteArray(b"PNG")).write(image)
    return data


def _svg(page: _Page, options: FigureOptions) -> QByteArray:
    from PySide6.QtSvg import QSvgGenerator

    data, buffer = _buffer()
    generator = QSvgGenerator(QSvgGenerator.SvgVersion.Svg11)  # SVG Tiny clips nothing
    generator.setOutputDevice(buffer)
    units = [round(side / INCH * _SVG_UNITS) for side in options.millimetres]
    generator.setResolution(_SVG_UNITS)
    generator.setSize(QSize(*units))
    generator.setViewBox(QRectF(0, 0, *units))
    generator.setTitle("QOVR surface")
    with painting(generator) as painter:
        painter.scale(units[0] / page.size[0], units[1] / page.size[1])
        _draw_page(painter, page, transparent=options.transparent)
    return data


def _pdf(page: _Page, options: FigureOptions) -> QByteArray:
    data, buffer = _buffer()
    writer = QPdfWriter(buffer)
    writer.setTitle("QOVR surface")
    writer.setCreator("QOVR Studio")
    points = QSizeF(*options.millimetres) * (_POINTS_PERINCH / INCH)
    writer.setPageSize(QPageSize(points, QPageSize.Unit.Point, "", QPageSize.SizeMatchPolicy.ExactMatch))
    writer.setPageMargins(QMarginsF(0, 0, 0, 0))
    with painting(writer) as painter:
        painter.setRenderHint(QPainter.RenderHint.LosslessImageRendering)  # else images become JPEG
        painter.scale(writer.width() / page.size[0], writer.height() / page.size[1])
        painter.fillRect(QRectF(0, 0, *page.size), QColor(*page.panels[0].picture.theme.background))
        _draw_page(painter, page, transparent=False)
    return QByteArray(same_every_time(bytes(data.data())))


def _buffer() -> tuple[QByteArray, QBuffer]:
    data = QByteArray()
    buffer = QBuffer(data)
    buffer.open(QIODevice.OpenModeFlag.WriteOnly)
    return data, buffer
