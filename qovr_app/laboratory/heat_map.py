"""The unit square of the parameters, coloured by how far the surface moves there, u to the right and v upward."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import QEvent, QLineF, QPointF, QRectF, QSize, Qt, Signal
from PySide6.QtGui import QColor, QFont, QImage, QMouseEvent, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QSizePolicy, QWidget

from qovr_app.laboratory.wording import motion_text
from qovr_app.state.display import ColourMap, ThemeName
from qovr_app.style.canvas import painting
from qovr_app.style.colour_bar import BAR_FRAME, draw_bar, tick_line
from qovr_app.style.colour_maps import colour_table, colours_of
from qovr_app.style.theme import Theme, theme_of
from qovr_app.style.ticks import tick_positions
from qovr_core import Edge
from qovr_core.arrays import Array
from qovr_core.laboratory.influence import Influence
from qovr_core.laboratory.levels import level_line
from qovr_core.number_texts import tick_texts

COLOURS = ColourMap.VIRIDIS
"""Nothing is dark and much is bright, evenly: a map for a magnitude that begins at 0."""

_FONT_PIXELS = 11
_LINE = 15.0
"""Height of a line of text around the square."""

_BAR_GAP, _BAR_HEIGHT = 6.0, 10.0
_TICK = 2.0
_TICK_ROOM = 36.0
_MARK = 4.5
_WHITE = QColor(255, 255, 255)
_LINE_WIDTHS = (1.6, 0.8)
"""Of the lines at the two parts of the largest displacement: the larger part is the thicker line."""


class HeatMap(QWidget):
    """Shows the displacement of an influence, its lines of 10 % and 1 %, and what each edge does.

    Signals
    -------
    hovered : (u, v) under the pointer; None when it has left the square
    """

    hovered = Signal(object)

    def __init__(self, name: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName(name)
        self.setAccessibleName("Displacement over the parameters")
        self.setMouseTracking(True)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self.setMinimumSize(150, 110)
        self._theme = theme_of(ThemeName.LIGHT)
        self._influence: Influence | None = None
        self._image = QImage()
        self._lines: list[Array] = []

    def sizeHint(self) -> QSize:
        return QSize(280, 240)

    def show_theme(self, theme: Theme) -> None:
        """Draw in other colours."""
        self._theme = theme
        self.update()

    def show_influence(self, influence: Influence) -> None:
        """Show an influence in which something moves."""
        self._influence = influence
        self._image = _image(influence)
        levels = [reach.part * influence.largest for reach in influence.reaches]
        self._lines = [level_line(influence.magnitude, level) for level in levels]
        self.update()

    def square(self) -> QRectF:
        """Return where the unit square lies in the widget."""
        below = 2 * _LINE + _BAR_GAP + _BAR_HEIGHT + BAR_FRAME + _TICK
        side = max(1.0, min(self.width() - 2 * _LINE, self.height() - _LINE - below))
        return QRectF(round((self.width() - side) / 2), _LINE, round(side), round(side))

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        square = self.square()
        u = (event.position().x() - square.left()) / square.width()
        v = (square.bottom() - event.position().y()) / square.height()
        self.hovered.emit((u, v) if 0 <= u <= 1 and 0 <= v <= 1 else None)

    def leaveEvent(self, event: QEvent) -> None:
        super().leaveEvent(event)
        self.hovered.emit(None)

    def paintEvent(self, _event: QPaintEvent) -> None:
        if self._influence is None:
            return
        with painting(self) as painter:
            self._paint(painter, self._influence)

    def _paint(self, painter: QPainter, influence: Influence) -> None:
        painter.setRenderHints(QPainter.RenderHint.Antialiasing | QPainter.RenderHint.SmoothPixmapTransform)
        font = QFont(self.font())
        font.setPixelSize(_FONT_PIXELS)
        painter.setFont(font)
        square = self.square()
        self._paint_map(painter, square, influence)
        self._paint_edges(painter, square, influence)
        self._paint_bar(painter, square, influence)

    def _paint_map(self, painter: QPainter, square: QRectF, influence: Influence) -> None:
        # The samples are the pixels' middles, and the outermost lie on the edges.
        painter.drawImage(square, self._image, QRectF(self._image.rect()).adjusted(0.5, 0.5, -0.5, -0.5))
        painter.save()
        painter.setClipRect(square)
        for segments, width in zip(self._lines, _LINE_WIDTHS, strict=True):
            painter.setPen(QPen(_WHITE, width, Qt.PenStyle.SolidLine, Qt.PenCapStyle.RoundCap))
            painter.drawLines(_lines_in(square, segments))
        painter.setPen(QPen(_WHITE, 1.0, Qt.PenStyle.DotLine))
        for u in influence.still_u:
            painter.drawLine(_lines_in(square, np.array([[[u, 0.0], [u, 1.0]]]))[0])
        for v in influence.still_v:
            painter.drawLine(_lines_in(square, np.array([[[0.0, v], [1.0, v]]]))[0])
        painter.restore()
        painter.setPen(QPen(QColor(*self._theme.axis), 1.0))
        painter.setBrush(Qt.BrushStyle.NoBrush)
        painter.drawRect(square.adjusted(-0.5, -0.5, 0.5, 0.5))
        _paint_mark(painter, square, influence.place)

    def _paint_edges(self, painter: QPainter, square: QRectF, influence: Influence) -> None:
        """Say beside each edge which it is, and how far it moves."""
        side = square.width()
        for edge, y in ((Edge.V1, 0.0), (Edge.V0, square.bottom() + 1)):
            self._write_edge(painter, QRectF(square.left(), y, side, _LINE), edge, influence.edges[edge])
        for edge, x in ((Edge.U0, square.left() - _LINE - 1), (Edge.U1, square.right() + 1)):
            painter.save()
            painter.translate(x, square.center().y())
            painter.rotate(-90)
            self._write_edge(painter, QRectF(-side / 2, 0, side, _LINE), edge, influence.edges[edge])
            painter.restore()

    def _write_edge(self, painter: QPainter, room: QRectF, edge: Edge, motion: float) -> None:
        parameter, end = edge.value.split("=")
        text = f"{parameter} = {end}:  {motion_text(motion)}"
        painter.setPen(QColor(*(self._theme.ink if motion else self._theme.quiet_ink)))
        painter.drawText(room.adjusted(-_LINE, 0, _LINE, 0), Qt.AlignmentFlag.AlignCenter, text)

    def _paint_bar(self, painter: QPainter, square: QRectF, influence: Influence) -> None:
        bar = QRectF(square.left(), square.bottom() + _LINE + _BAR_GAP, square.width(), _BAR_HEIGHT)
        pens = [QPen(_WHITE, width) for width in _LINE_WIDTHS]
        marks = [(reach.part, pen) for reach, pen in zip(influence.reaches, pens, strict=True)]
        draw_bar(painter, bar, colour_table(COLOURS), self._theme, marks)
        largest = influence.largest
        values = tick_positions(0.0, largest, max(1, int(bar.width() / _TICK_ROOM)))
        for value, text in zip(values.tolist(), tick_texts(values.tolist()), strict=True):
            tick = tick_line(bar, value / largest, _TICK)
            painter.setPen(QPen(QColor(*self._theme.axis), 1.0))
            painter.drawLine(tick)
            painter.setPen(QColor(*self._theme.quiet_ink))
            room = QRectF(tick.x2() - _TICK_ROOM / 2, tick.y2(), _TICK_ROOM, _LINE)
            painter.drawText(room, Qt.AlignmentFlag.AlignCenter, text)


def _paint_mark(painter: QPainter, square: QRectF, place: tuple[float, float]) -> None:
    """Mark the place of the largest displacement, with nothing outside the square."""
    u, v = place
    at = QPointF(square.left() + u * square.width(), square.bottom() - v * square.height())
    painter.save()
    painter.setClipRect(square)
    for colour, width in ((QColor(0, 0, 0), 3.5), (_WHITE, 1.5)):
        painter.setPen(QPen(colour, width))
        painter.drawLine(at - QPointF(_MARK, 0), at + QPointF(_MARK, 0))
        painter.drawLine(at - QPointF(0, _MARK), at + QPointF(0, _MARK))
    painter.restore()


def _lines_in(square: QRectF, segments: Array) -> list[QLineF]:
    """Return segments of the unit square, (k, 2, 2), as lines in the widget."""
    ends = segments * [square.width(), -square.height()] + [square.left(), square.bottom()]
    return [QLineF(*line) for line in ends.reshape(-1, 4).tolist()]


def _image(influence: Influence) -> QImage:
    """Return the displacement as an image of one pixel a sample, v upward."""
    colours = colours_of(influence.magnitude, 0.0, influence.largest, COLOURS)
    rows = np.ascontiguousarray(colours.transpose(1, 0, 2)[::-1])
    height, width = rows.shape[:2]
    return QImage(rows.tobytes(), width, height, 3 * width, QImage.Format.Format_RGB888).copy()
