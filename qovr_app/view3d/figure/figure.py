"""Figures: what is seen, laid out again at the size of a page, as pixels or as vectors."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path

from PySide6.QtCore import QBuffer, QByteArray, QIODevice, QMarginsF, QRectF, QSize, QSizeF, Qt
from PySide6.QtGui import QColor, QImage, QPageSize, QPainter, QPdfWriter

from qovr_app.view3d.painter.backdrop import draw_backdrop
from qovr_app.style.canvas import painting
from qovr_app.view3d.painter.overlay import draw_overlay
from qovr_app.view3d.scene.camera import Size, fitted
from qovr_app.view3d.scene.picture import Picture, margins
from qovr_core import FileError
from qovr_core.files.atomic import replacing

SUFFIXES = (".png", ".svg", ".pdf")

_INCH = 25.4
_LARGEST_SIDE = 20_000
"""Pixels; Qt's painter itself ends at 32767."""

_PRINT_DPI = 300
_SVG_UNITS = 2540
"""Units per inch inside an SVG, a hundred a millimetre: its size on paper is a whole number of them."""

_POINTS_PER_INCH = 72

SurfaceImage = Callable[[Picture, Size, tuple[int, int]], QImage]
Panel = tuple[Picture, Size, SurfaceImage]
"""A viewport's picture, its logical size, and what draws its surface."""


@dataclass(frozen=True)
class FigureOptions:
    """Size and ground of a figure.

    Parameters
    ----------
    width, height : in millimetres, or in pixels where ``dpi`` is None
    dpi : pixels per inch of the image, and of the surface inside SVG and PDF; None counts sizes in pixels
    transparent : leave the background out, in PNG and SVG
    """

    width: float = 160.0
    height: float = 120.0
    dpi: float | None = _PRINT_DPI
    transparent: bool = False

    @property
    def pixels(self) -> tuple[int, int]:
        """Width and height in pixels."""
        scale = 1.0 if self.dpi is None else self.dpi / _INCH
        return max(1, round(self.width * scale)), max(1, round(self.height * scale))

    @property
    def millimetres(self) -> tuple[float, float]:
        """Width and height on paper; pixels count as those of a 96 dpi screen."""
        if self.dpi is not None:
            return self.width, self.height
        return self.width * _INCH / 96, self.height * _INCH / 96

    def check(self, path: Path) -> None:
        """Refuse what no figure is written as.

        Raises
        ------
        FileError : the path ends in another suffix, or the figure is of an absurd size
        """
        if path.suffix.lower() not in SUFFIXES:
            raise FileError(f"{path}: a figure is written as {', '.join(SUFFIXES)}, by the file name's end")
        if max(self.pixels) > _LARGEST_SIDE:
            width, height = self.pixels
            raise FileError(f"{path}: {width} x {height} pixels; expected at most {_LARGEST_SIDE} a side")


def save_figure(path: Path, panels: list[Panel], options: FigureOptions, *, refit: bool) -> None:
    """Write viewports side by side as one figure.

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


def _laid_out(panels: list[Panel], options: FigureOptions, *, refit: bool) -> _Page:
    """Give the page as many logical pixels as keep lettering and lines as large, in the picture, as on the
    screen."""
    count = len(panels)
    seen = panels[0][1]
    width, height = options.pixels
    scale = min(width / (seen[0] * count), height / seen[1])
    size = width / count / scale, height / scale
    placed = []
    for picture, _, surface_image in panels:
        camera = picture.camera
        if refit and picture.scene is not None:
            half = picture.scene.frame.half_extents
            camera = fitted(camera, half, size, margins(picture.settings, size))
        placed.append((replace(picture, camera=camera), size, surface_image))
    return _Page(placed, (width / scale, height / scale), scale)


def _draw_page(painter: QPainter, page: _Page, *, transparent: bool) -> None:
    """Draw all panels; the painter's units are the page's logical pixels."""
    for k, (picture, size, surface_image) in enumerate(page.panels):
        painter.save()
        painter.translate(k * size[0], 0)
        painter.setClipRect(QRectF(0, 0, *size))
        draw_backdrop(painter, picture, size, transparent=transparent)
        pixels = round(size[0] * page.scale), round(size[1] * page.scale)
        if picture.scene is not None and picture.settings.surface:
            image = surface_image(picture, (pixels[0] / page.scale, pixels[1] / page.scale), pixels)
            painter.drawImage(QRectF(0, 0, *size), image)
        draw_overlay(painter, picture, size)
        painter.restore()


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
    image.save(buffer, "PNG")
    return data


def _svg(page: _Page, options: FigureOptions) -> QByteArray:
    from PySide6.QtSvg import QSvgGenerator

    data, buffer = _buffer()
    generator = QSvgGenerator()
    generator.setOutputDevice(buffer)
    units = [round(side / _INCH * _SVG_UNITS) for side in options.millimetres]
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
    points = QSizeF(*options.millimetres) * (_POINTS_PER_INCH / _INCH)
    writer.setPageSize(QPageSize(points, QPageSize.Unit.Point, "", QPageSize.SizeMatchPolicy.ExactMatch))
    writer.setPageMargins(QMarginsF(0, 0, 0, 0))
    with painting(writer) as painter:
        painter.scale(writer.width() / page.size[0], writer.height() / page.size[1])
        painter.fillRect(QRectF(0, 0, *page.size), QColor(*page.panels[0][0].theme.background))
        _draw_page(painter, page, transparent=False)
    return data


def _buffer() -> tuple[QByteArray, QBuffer]:
    data = QByteArray()
    buffer = QBuffer(data)
    buffer.open(QIODevice.OpenModeFlag.WriteOnly)
    return data, buffer
