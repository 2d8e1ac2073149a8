"""Marks drawn by Qt's painter: in figures, and in the view without OpenGL."""

from __future__ import annotations

from collections.abc import Iterable

from PySide6.QtCore import QLineF, QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QPainter, QPen, QPolygonF

from qovr_app.style.canvas import dimmed
from qovr_app.view3d.painter.discs import paint_discs
from qovr_app.view3d.painter.strip import paint_strip
from qovr_app.view3d.painter.text import paint_text
from qovr_app.view3d.painter.underlay import paint_photo
from qovr_app.view3d.scene.marks import (
    Cap,
    Discs,
    Ink,
    Lines,
    Mark,
    Pen,
    Photo,
    Polygon,
    Polyline,
    Rectangle,
    Strip,
    Text,
)
from qovr_core.arrays import Array

_CAPS = {
    Cap.FLAT: Qt.PenCapStyle.FlatCap,
    Cap.SQUARE: Qt.PenCapStyle.SquareCap,
    Cap.ROUND: Qt.PenCapStyle.RoundCap,
}


def paint(painter: QPainter, marks: Iterable[Mark]) -> None:
    """Paint marks over one another; the painter's units are logical pixels."""
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    for mark in marks:
        match mark:
            case Text():
                paint_text(painter, mark)
            case Lines():
                painter.setPen(_qt_pen(mark.pen))
                painter.drawLines([QLineF(*line) for line in mark.ends.reshape(-1, 4).tolist()])
            case Polyline():
                painter.setPen(_qt_pen(mark.pen))
                painter.drawPolyline(_qt_polygon(mark.points))
            case Discs():
                with dimmed(painter, mark.opacity):
                    _choose(painter, mark.pen, mark.fill)
                    paint_discs(painter, mark)
            case Polygon():
                _choose(painter, mark.pen, mark.fill)
                painter.drawPolygon(_qt_polygon(mark.corners))
            case Rectangle():
                _choose(painter, mark.pen, mark.fill)
                painter.drawRoundedRect(QRectF(*mark.box), mark.radius, mark.radius)
            case Photo():
                paint_photo(painter, mark)
            case Strip():
                paint_strip(painter, mark)


def _choose(painter: QPainter, pen: Pen | None, fill: Ink | None) -> None:
    painter.setPen(Qt.PenStyle.NoPen if pen is None else _qt_pen(pen))
    painter.setBrush(Qt.BrushStyle.NoBrush if fill is None else _qt_colour(fill))


def _qt_pen(pen: Pen) -> QPen:
    style = Qt.PenStyle.DashLine if pen.is_dashed else Qt.PenStyle.SolidLine
    join = Qt.PenJoinStyle.RoundJoin if pen.cap is Cap.ROUND else Qt.PenJoinStyle.BevelJoin
    return QPen(_qt_colour(pen.ink), pen.width, style, _CAPS[pen.cap], join)


def _qt_colour(ink: Ink) -> QColor:
    colour = QColor(*ink.colour)
    colour.setAlphaF(ink.opacity)
    return colour


def _qt_polygon(points: Array) -> QPolygonF:
    return QPolygonF([QPointF(x, y) for x, y in points.tolist()])
