"""Lettering: short texts with subscripts and a halo, drawn once and reused on pixels, as outlines in vector
figures."""

from __future__ import annotations

import re
from dataclasses import dataclass
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

SMALL, NORMAL = 11, 12
"""Pixel sizes: tick labels and point labels, titles."""

_SUBSCRIPT_SIZE = 0.74
_SUBSCRIPT_DROP = 0.24
_HALO_WIDTH = 3.0
_PAD = 3

Runs = tuple[tuple[str, bool], ...]
"""Pieces of a text, each with whether it is a subscript."""

Alignment = tuple[float, float]
"""Where the anchor lies in the text's box: (0, 0) upper left, (0.5, 0.5) in the middle, (1, 1) lower
right."""


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


def draw_text(
    painter: QPainter,
    runs: Runs,
    anchor: tuple[float, float],
    alignment: Alignment,
    colour: Rgb,
    *,
    pixels: int = SMALL,
    halo: Rgb | None = None,
    opacity: float = 1.0,
    upright: bool = False,
) -> None:
    """Draw a text with its anchor at a point in logical pixels; ``upright`` runs from below to above."""
    width, height = text_size(runs, pixels)
    if upright:
        width, height = height, width
    x, y = anchor[0] - alignment[0] * width, anchor[1] - alignment[1] * height
    if isinstance(painter.device(), QImage):
        painter.setOpacity(opacity)
        ratio = painter.device().devicePixelRatioF()
        image = _sprite(_Lettering(runs, colour, pixels, halo, upright), ratio)
        # A sprite between two pixels would be blurred.
        x, y = (round((value - _PAD) * ratio) / ratio for value in (x, y))
        painter.drawImage(QPointF(x, y), image)
        painter.setOpacity(1.0)
    else:
        placed = QTransform.fromTranslate(x, y + height).rotate(-90) if upright else QTransform.fromTranslate(x, y)
        with dimmed(painter, opacity):
            painter.setTransform(placed, combine=True)
            _draw_pieces(painter, _pieces(runs, pixels, QPointF(0, 0)), colour, halo)


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


@dataclass(frozen=True)
class _Lettering:
    """A text with everything that decides its pixels, but for the device's ratio."""

    runs: Runs
    colour: Rgb
    pixels: int
    halo: Rgb | None
    upright: bool


@lru_cache(maxsize=1024)
def _sprite(text: _Lettering, ratio: float) -> QImage:
    width, height = text_size(text.runs, text.pixels)
    image = blank_image((width + 2 * _PAD + 1, height + 2 * _PAD + 1), ratio)
    pieces = _pieces(text.runs, text.pixels, QPointF(_PAD, _PAD))
    with painting(image) as painter:
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        _draw_pieces(painter, pieces, text.colour, text.halo)
    return image.transformed(QTransform().rotate(-90)) if text.upright else image
