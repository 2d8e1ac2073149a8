"""The colour bar: which value has which colour, and whether values lie beyond its ends."""

from __future__ import annotations

import math
from collections.abc import Hashable, Iterator
from dataclasses import dataclass, field
from decimal import Decimal

import numpy as np
import numpy.typing as npt
from PySide6.QtCore import QPointF, QRectF
from PySide6.QtGui import QColor, QPainter, QPen, QPolygonF

from qovr_app.style.colour_bar import draw_bar, tick_line
from qovr_app.style.colour_maps import ENTRIES
from qovr_app.style.theme import Theme
from qovr_app.style.tick_labels import TickLabels, tick_labels
from qovr_app.style.ticks import is_flat, tick_positions
from qovr_app.view3d.painter.text import NORMAL, SMALL, lettered, paint_text, plain, text_size, with_subscripts
from qovr_app.view3d.scene.camera import Size
from qovr_app.view3d.scene.colouring import Colouring
from qovr_app.view3d.scene.marks import Box, Mark, Strip
from qovr_app.view3d.scene.picture import Picture, emphasis
from qovr_core.arrays import Array
from qovr_core.number_texts import power_text, significant_text

_WIDTH = 14.0
_RIGHT = 78.0
"""From the bar's left side to the viewport's right: room for ticks and the upright title."""

_PART_OF_HEIGHT = 0.62
_TALLEST = 420.0
_TICK_ROOM = 34.0
_TICK_LENGTH, _TICK_GAP = 3.0, 6.0
_ARROW = 9.0
_NOTE_ROOM, _BORDER = 100.0, 2.0
"""At the left of the bar, for what its numbers share; and between that and the viewport's border."""

_FACTOR_GAP = 9.0
_NOTE_GAP = 10.0
"""What is kept free around the bar: half a line, and over it a line for what its numbers share."""

_PLAIN_POWERS = range(-1, 4)
"""Powers of ten of numbers that are written in full; what is smaller or larger has its power over the bar."""

_DIGITS = 4
"""Of the one value where all are the same."""


def bar_rect(size: Size) -> QRectF:
    """Return where the bar itself lies, in logical pixels."""
    larger = emphasis(size)
    rect = _plain_rect(_in_units(size))
    return QRectF(rect.topLeft() * larger, rect.size() * larger)


def _in_units(size: Size) -> Size:
    """Return a viewport's size in the bar's own units, which are larger than pixels in a large one."""
    larger = emphasis(size)
    return size[0] / larger, size[1] / larger


def _plain_rect(units: Size) -> QRectF:
    height = min(units[1] * _PART_OF_HEIGHT, _TALLEST)
    return QRectF(round(units[0] - _RIGHT), round((units[1] - height) / 2), _WIDTH, round(height))


def bar_room(size: Size) -> tuple[float, float, float, float]:
    """Return left, top, right and bottom of the bar with what is written around it, in logical pixels."""
    rect = bar_rect(size)
    return rect.left() - _NOTE_GAP, rect.top() - 2 * _NOTE_GAP, size[0], rect.bottom() + _NOTE_GAP


@dataclass(frozen=True)
class _Bar:
    """Everything that decides how a colour bar looks; the size is in the bar's own units.

    Bars are alike whose colourings look alike: an edit makes a new colouring, of which mostly the values alone differ.
    """

    colouring: Colouring = field(compare=False)
    looks: Hashable
    theme: Theme
    size: Size

    def paint(self, painter: QPainter) -> None:
        """Paint the bar with its ticks and title."""
        rect, colouring = _plain_rect(self.size), self.colouring
        draw_bar(painter, rect, _colours(colouring), self.theme)
        _draw_arrows(painter, rect, self)
        widest = 0.0 if math.isnan(colouring.limits[0]) else draw_ticks(painter, rect, colouring, self.theme)
        place = rect.right() + _TICK_GAP + widest + 4, rect.center().y()
        title = with_subscripts(colouring.title)
        paint_text(painter, lettered(title, place, (0, 0.5), self.theme.ink, pixels=NORMAL, upright=True))


def colour_bar(picture: Picture, size: Size) -> Iterator[Mark]:
    """Yield the bar with its ticks and title. Where nothing has a value there is no bar."""
    colouring = picture.colouring
    if math.isnan(colouring.limits[0]) and colouring.pattern is None:
        return
    units = _in_units(size)
    left = max(0.0, _plain_rect(units).left() - _NOTE_ROOM)
    box = Box(left, 0.0, units[0] - left, units[1])
    looks = colouring.table.tobytes(), colouring.title, colouring.limits, colouring.beyond, colouring.pattern
    yield Strip(_Bar(colouring, looks, picture.theme, units), box, emphasis(size))


def _colours(colouring: Colouring) -> npt.NDArray[np.uint8]:
    """Return the colours from low to high, (k, 3)."""
    if colouring.pattern is None:
        return colouring.table
    from_above = np.rint((1 - np.array(colouring.pattern.bar)) * (ENTRIES - 1)).astype(np.intp)
    rows = colouring.table[::-1][from_above]
    return np.repeat(rows, ENTRIES // len(rows), axis=0)  # in steps, which no smoothing of the painter washes out


def _draw_arrows(painter: QPainter, rect: QRectF, bar: _Bar) -> None:
    """Draw a point in the end's colour where values lie beyond it."""
    table, (below, above) = bar.colouring.table, bar.colouring.beyond
    painter.setPen(QPen(QColor(*bar.theme.axis), 1.0))
    for is_beyond, y, away, colour in ((below, rect.bottom(), 1, table[0]), (above, rect.top(), -1, table[-1])):
        if is_beyond:
            painter.setBrush(QColor(*colour.tolist()))
            base = y + 0.5 * away
            tip = QPointF(rect.center().x(), base + _ARROW * away)
            ends = QPointF(rect.left() - 0.5, base), QPointF(rect.right() + 0.5, base)
            painter.drawPolygon(QPolygonF([ends[0], tip, ends[1]]))


def draw_ticks(painter: QPainter, rect: QRectF, colouring: Colouring, theme: Theme) -> float:
    """Draw ticks with their numbers, and over the bar what these share; return the widest number."""
    values, parts = _ticks(rect, colouring)
    labels = (
        tick_labels(values.tolist(), _PLAIN_POWERS)
        if colouring.limits[1] > colouring.limits[0]
        else _label_alone(colouring.limits[0])
    )
    for part, text in zip(parts.tolist(), labels.texts, strict=True):
        tick = tick_line(rect, part, _TICK_LENGTH)
        painter.setPen(QPen(QColor(*theme.axis), 1.0))
        painter.drawLine(tick)
        paint_text(painter, lettered(plain(text), (rect.right() + _TICK_GAP, tick.y1()), (0, 0.5), theme.quiet_ink))
    if labels.note:
        width = text_size(plain(labels.note), SMALL)[0]
        left = min(rect.left(), rect.left() + _RIGHT - _BORDER - width)
        over = left, rect.top() - _FACTOR_GAP - (_ARROW if colouring.beyond[1] else 0.0)
        paint_text(painter, lettered(plain(labels.note), over, (0, 0.5), theme.quiet_ink))
    return max((text_size(plain(text), SMALL)[0] for text in labels.texts), default=0.0)


def _label_alone(value: float) -> TickLabels:
    """Return the label of the one value that is everywhere."""
    power = _common_power(abs(value))
    factor = float(Decimal(value).scaleb(-power))
    return TickLabels([significant_text(factor, _DIGITS)], power_text(power) if power else "")


def _ticks(rect: QRectF, colouring: Colouring) -> tuple[Array, Array]:
    """Return the values that have a tick and which part of the bar each belongs to."""
    low, high = colouring.limits
    if is_flat(low, high):
        return np.array([low]), np.array([0.5])
    if colouring.pattern is None:
        values = tick_positions(low, high, int(rect.height() / _TICK_ROOM))
    else:
        values = np.array(colouring.pattern.ticks)
    return values, (values - low) / (high - low)


def _common_power(largest: float) -> int:
    """Return the power of ten to be set apart from numbers up to ``largest``; 0 where they are short by themselves."""
    power = math.floor(math.log10(largest)) if largest > 0 else 0
    return 0 if power in _PLAIN_POWERS else power
