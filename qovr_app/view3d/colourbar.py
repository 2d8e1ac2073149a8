"""The colour bar: which height has which colour."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from PySide6.QtCore import QLineF, QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QImage, QPainter, QPen

from qovr_app.view3d.camera import Size
from qovr_app.view3d.canvas import blank_image, painting
from qovr_app.view3d.colourmaps import ENTRIES, colour_table
from qovr_app.view3d.picture import Picture
from qovr_app.view3d.settings import ColourMap
from qovr_app.view3d.text import NORMAL, SMALL, draw_text, plain, text_size
from qovr_app.view3d.theme import Theme
from qovr_app.view3d.ticks import tick_positions, tick_texts

TITLE = "Z-Axis Value"

_WIDTH = 14.0
_RIGHT = 78.0
"""From the bar's left side to the viewport's right: room for ticks and the upright title."""

_PART_OF_HEIGHT = 0.62
_TALLEST = 420.0
_TICK_ROOM = 34.0
_TICK_GAP = 6.0


@lru_cache(maxsize=8)
def _gradient(colour_map: ColourMap) -> QImage:
    """Return the colour table as an image one pixel wide, high values on top."""
    rows = np.ascontiguousarray(colour_table(colour_map)[::-1])
    return QImage(rows.tobytes(), 1, ENTRIES, 3, QImage.Format.Format_RGB888).copy()


def bar_rect(size: Size) -> QRectF:
    """Return where the bar itself lies, in logical pixels."""
    height = min(size[1] * _PART_OF_HEIGHT, _TALLEST)
    return QRectF(round(size[0] - _RIGHT), round((size[1] - height) / 2), _WIDTH, round(height))


@dataclass(frozen=True)
class _Bar:
    """Everything that decides how a colour bar looks."""

    heights: tuple[float, float]
    colour_map: ColourMap
    theme: Theme
    size: Size


def draw_colour_bar(painter: QPainter, picture: Picture, size: Size) -> None:
    """Draw the bar with its ticks and title; the picture has a scene."""
    bar = _Bar(picture.scene.heights, picture.settings.colour_map, picture.theme, size)
    if isinstance(painter.device(), QImage):
        left = bar_rect(size).left() - 1
        painter.drawImage(QPointF(left, 0), _drawn(bar, left, painter.device().devicePixelRatioF()))
    else:
        _draw(painter, bar)


@lru_cache(maxsize=4)
def _drawn(bar: _Bar, left: float, ratio: float) -> QImage:
    """Return the strip of the viewport from ``left`` on; bars change less often than pictures."""
    image = blank_image((bar.size[0] - left, bar.size[1]), ratio)
    with painting(image) as painter:
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.translate(-left, 0)
        _draw(painter, bar)
    return image


def _draw(painter: QPainter, bar: _Bar) -> None:
    theme, (low, high) = bar.theme, bar.heights
    rect = bar_rect(bar.size)
    painter.drawImage(rect, _gradient(bar.colour_map))
    painter.setPen(QPen(QColor(*theme.axis), 1.0))
    painter.setBrush(Qt.BrushStyle.NoBrush)
    painter.drawRect(rect.adjusted(-0.5, -0.5, 0.5, 0.5))
    if high > low:
        values = tick_positions(low, high, int(rect.height() / _TICK_ROOM))
        places = rect.bottom() - (values - low) / (high - low) * rect.height()
    else:
        values, places = np.array([low]), np.array([rect.center().y()])
    texts = tick_texts(values)
    for y, text in zip(places.tolist(), texts, strict=True):
        painter.setPen(QPen(QColor(*theme.axis), 1.0))
        painter.drawLine(QLineF(rect.right() + 1, y, rect.right() + 4, y))
        draw_text(painter, plain(text), (rect.right() + _TICK_GAP, y), (0, 0.5), theme.quiet_ink)
    widest = max((text_size(plain(text), SMALL)[0] for text in texts), default=0.0)
    place = rect.right() + _TICK_GAP + widest + 4, rect.center().y()
    draw_text(painter, plain(TITLE), place, (0, 0.5), theme.ink, pixels=NORMAL, upright=True)
