"""Lettering: short texts with subscripts and a halo, drawn once and reused on pixels, as outlines in vector
figures."""

from __future__ import annotations

import re
from functools import lru_cache

from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import (
    QColor,
    QFont,
    QFontMetricsF,
    QGuiApplication,
    QImage,
    QPainter,
    QPainterPath,
    QPen,
    QTransform,
)

from qovr_app.style.canvas import blank_image, dimmed, painting
from qovr_app.style.theme import Rgb
from qovr_app.view3d.scene.marks import Alignment, Lettering, Place, Runs, Text

SMALL, NORMAL = 11, 12
"""Pixel sizes: tick labels and point labels, titles."""

_SUBSCRIPT_SIZE = 0.74
_SUBSCRIPT_DROP = 0.24
_HALO_WIDTH = 3.0
_PAD = 3


def plain(text: str) -> Runs:
    """Return a text without subscripts as runs."""
    return ((text, False),)


def with_subscripts(text: str) -> Runs:
    """Return a text as runs, in which the letters and digits after each ``_`` are a subscript."""
    pieces = re.split(r"_([A-Za-z0-9]+)", text)
    return tuple((piece, k % 2 == 1) for k, piece in enumerate(pieces) if piece)


def wrapped(text: str, pixels: int, width: float) -> list[Runs]:
    """Return a text in lines no wider than logical pixels, unless a single word is."""
    lines: list[str] = []
    for word in text.split():
        longer = f"{lines[-1]} {word}" if lines else word
        if lines and text_size(with_subscripts(longer), pixels)[0] <= width:
            lines[-1] = longer
        else:
            lines.append(word)
    return [with_subscripts(line) for line in lines]


@lru_cache(maxsize=8)
def _font(pixels: int, *, subscript: bool) -> QFont:
    font = QFont(QGuiApplication.font())
    font.setPixelSize(max(1, round(pixels * _SUBSCRIPT_SIZE)) if subscript else pixels)
    return font


@lru_cache(maxsize=1024)
def text_size(runs: Runs, pixels: int) -> tuple[float, float]:
    """Return width and height of a text in logical pixels."""
    width = sum(QFontMetricsF(_font(pixels, subscript=sub)).horizontalAdvance(text) for text, sub in runs)
    return width, QFontMetricsF(_font(pixels, subscript=False)).height()


def lettered(
    runs: Runs,
    anchor: Place,
    alignment: Alignment,
    colour: Rgb,
    *,
    pixels: int = SMALL,
    halo: Rgb | None = None,
    opacity: float = 1.0,
    upright: bool = False,
) -> Text:
    """Return a text with its anchor at a point; ``upright`` runs from below to above."""
    return Text(Lettering(runs, colour, pixels, halo, upright), anchor, alignment, opacity)


def _corner(mark: Text) -> Place:
    """Return the upper left corner of a text's box."""
    width, height = text_size(mark.lettering.runs, mark.lettering.pixels)
    if mark.lettering.upright:
        width, height = height, width
    return mark.anchor[0] - mark.alignment[0] * width, mark.anchor[1] - mark.alignment[1] * height


def text_corner(mark: Text, ratio: float) -> tuple[int, int]:
    """Return the device's pixel at the upper left of a text's image: between two pixels it would be blurred."""
    x, y = _corner(mark)
    return round((x - _PAD) * ratio), round((y - _PAD) * ratio)


def paint_text(painter: QPainter, mark: Text) -> None:
    """Paint a text: on pixels by its image, else as text."""
    device, lettering = painter.device(), mark.lettering
    if isinstance(device, QImage):
        ratio = device.devicePixelRatioF()
        x, y = text_corner(mark, ratio)
        painter.setOpacity(mark.opacity)
        painter.drawImage(QPointF(x / ratio, y / ratio), text_image(lettering, ratio))
        painter.setOpacity(1.0)
        return
    placed = QTransform.fromTranslate(*_corner(mark))
    if lettering.upright:
        placed = placed.translate(0, text_size(lettering.runs, lettering.pixels)[0]).rotate(-90)
    with dimmed(painter, mark.opacity):
        painter.setTransform(placed, combine=True)
        _draw_pieces(
            painter, _pieces(lettering.runs, lettering.pixels, QPointF(0, 0)), lettering.colour, lettering.halo
        )


def _pieces(runs: Runs, pixels: int, corner: QPointF) -> list[tuple[QPointF, QFont, str]]:
    """Return each run's baseline point, font and text for a box with this upper left corner."""
    metrics = QFontMetricsF(_font(pixels, subscript=False))
    x, baseline = corner.x(), corner.y() + metrics.ascent()
    pieces = []
    for text, subscript in runs:
        font = _font(pixels, subscript=subscript)
        drop = pixels * _SUBSCRIPT_DROP if subscript else 0.0
        pieces.append((QPointF(x, baseline + drop), font, text))
        x += QFontMetricsF(font).horizontalAdvance(text)
    return pieces


def _outline(pieces: list[tuple[QPointF, QFont, str]]) -> QPainterPath:
    path = QPainterPath()
    for point, font, text in pieces:
        path.addText(point, font, text)
    return path


def _halo_pen(halo: Rgb) -> QPen:
    return QPen(
        QColor(*halo, 225),
        _HALO_WIDTH,
        Qt.PenStyle.SolidLine,
        Qt.PenCapStyle.RoundCap,
        Qt.PenJoinStyle.RoundJoin,
    )


def _draw_pieces(painter: QPainter, pieces: list[tuple[QPointF, QFont, str]], colour: Rgb, halo: Rgb | None) -> None:
    """Draw a halo as shapes, and the text as text, which SVG and PDF keep: to be searched, and edited."""
    if halo is not None:
        painter.strokePath(_outline(pieces), _halo_pen(halo))
    painter.setPen(QColor(*colour))
    for point, font, piece in pieces:
        painter.setFont(font)
        painter.drawText(point, piece)


@lru_cache(maxsize=1024)
def text_image(lettering: Lettering, ratio: float) -> QImage:
    """Return the image of a text, with some room around it, at a device pixel ratio."""
    width, height = text_size(lettering.runs, lettering.pixels)
    image = blank_image((width + 2 * _PAD + 1, height + 2 * _PAD + 1), ratio)
    pieces = _pieces(lettering.runs, lettering.pixels, QPointF(_PAD, _PAD))
    with painting(image) as painter:
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        _draw_pieces(painter, pieces, lettering.colour, lettering.halo)
    return image.transformed(QTransform().rotate(-90)) if lettering.upright else image
