"""Colours along a bar: low at the left, or below where the bar stands; for the picture and for plots."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import numpy.typing as npt
from PySide6.QtCore import QLineF, QRectF, Qt
from PySide6.QtGui import QColor, QImage, QPainter, QPen

from qovr_app.style.theme import Theme

BAR_FRAME = 1.0
"""Logical pixels that the frame takes around the colours; ticks begin beyond it."""


def draw_bar(
    painter: QPainter,
    rect: QRectF,
    colours: npt.NDArray[np.uint8],
    theme: Theme,
    marks: Sequence[tuple[float, QPen]] = (),
) -> None:
    """Draw a bar in its frame; the painter's units are logical pixels.

    Parameters
    ----------
    rect : where the colours lie
    colours : (k, 3) red, green and blue from low to high
    marks : lines across the colours, each at a part of the bar from 0 to 1 with its pen
    """
    painter.drawImage(rect, _gradient(colours, stands=_stands(rect)))
    for part, pen in marks:
        painter.setPen(pen)
        painter.drawLine(_across(rect, part))
    painter.setPen(QPen(QColor(*theme.axis), 1.0))
    painter.setBrush(Qt.BrushStyle.NoBrush)
    painter.drawRect(rect.adjusted(-0.5, -0.5, 0.5, 0.5))


def tick_line(rect: QRectF, part: float, length: float) -> QLineF:
    """Return the tick at a part of a bar, on its right, or below where it lies; it ends where its number begins."""
    end = _across(rect, part).p2()
    if _stands(rect):
        return QLineF(end.x() + BAR_FRAME, end.y(), end.x() + BAR_FRAME + length, end.y())
    return QLineF(end.x(), end.y() + BAR_FRAME, end.x(), end.y() + BAR_FRAME + length)


def _stands(rect: QRectF) -> bool:
    return rect.height() > rect.width()


def _across(rect: QRectF, part: float) -> QLineF:
    if _stands(rect):
        y = rect.bottom() - part * rect.height()
        return QLineF(rect.left(), y, rect.right(), y)
    x = rect.left() + part * rect.width()
    return QLineF(x, rect.top(), x, rect.bottom())


def _gradient(colours: npt.NDArray[np.uint8], *, stands: bool) -> QImage:
    """Return the colours as an image one pixel wide with the low ones below, or one pixel high."""
    data = np.ascontiguousarray(colours[::-1] if stands else colours)
    count = len(data)
    width, height = (1, count) if stands else (count, 1)
    return QImage(data.tobytes(), width, height, 3 * width, QImage.Format.Format_RGB888).copy()
