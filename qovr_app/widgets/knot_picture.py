"""What a plot of the transformations r(u), s(u), t(u) shows, and where: painted with no other library than Qt."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from PySide6.QtCore import QLineF, QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QFontMetricsF, QPainter, QPen, QPolygonF

from qovr_app.style.canvas import dimmed
from qovr_app.style.theme import KNOT_SERIES, Rgb, Theme
from qovr_core.arrays import Array, read_only
from qovr_core.geometry import bernstein
from qovr_core.geometry.folding import folding_parts
from qovr_core.geometry.knots import KNOT_NAMES, Direction, Knots
from qovr_core.geometry.weights import transformations
from qovr_core.laboratory.labels import label_places
from qovr_core.laboratory.one_curve import PARABOLA_LETTERS
from qovr_core.number_texts import number_text, signed_text, true_minus

_SAMPLES = read_only(np.linspace(0.0, 1.0, 61))
"""So many that a line through them is seen as the parabola that s is."""

_LEAST_RANGE = (-0.5, 1.5)
"""What r, s and t reach where every knot is 0.5."""

_HEADROOM = 0.1
_LEFT, _RIGHT, _TOP, _BOTTOM = 20.0, 12.0, 4.0, 18.0
"""Kept free around the plot for numbers and handles."""

_LINE, _FOLD_OPACITY, _FOLD_ROOM = 1.8, 0.22, 4.0
_RADIUS, _USED_RADIUS = 5.0, 6.5
_HANDLE_ROOM = 0.08
"""Of the plot's width, to either side of the handles at u, that is free of names."""

_PLATE_PAD, _PLATE_GAP = 5.0, 10.0


@dataclass(frozen=True)
class Frame:
    """How u from 0 to 1 and values between two limits lie on the screen."""

    box: QRectF
    low: float
    high: float

    def at(self, u: float, value: float) -> QPointF:
        """Return the pixel of a place."""
        part = (value - self.low) / (self.high - self.low)
        return QPointF(self.box.left() + u * self.box.width(), self.box.bottom() - part * self.box.height())

    def u_at(self, x: float) -> float:
        """Return the parameter under a pixel; the nearest there is."""
        return min(max((x - self.box.left()) / self.box.width(), 0.0), 1.0)

    def pixel(self, name: str) -> float:
        """Return how far a knot goes while its handle goes a pixel."""
        return 1 / self.box.width() if name == "u" else (self.high - self.low) / self.box.height()


def values_of(knots: Knots) -> Array:
    """Return r, s and t at ``_SAMPLES``, (n, 3)."""
    return read_only(bernstein.basis(2, _SAMPLES) @ transformations(tuple(knots)).T)


def limits_of(knots: Knots) -> tuple[float, float]:
    """Return between which values a plot of a curve's transformations reaches: all of s is in it."""
    s = values_of(knots)[:, 1]
    return min(_LEAST_RANGE[0], float(s.min())) - _HEADROOM, max(_LEAST_RANGE[1], float(s.max())) + _HEADROOM


def frame_in(rect: QRectF, limits: tuple[float, float]) -> Frame:
    """Return the frame of a plot in a rectangle."""
    return Frame(rect.adjusted(_LEFT, _TOP, -_RIGHT, -_BOTTOM), *limits)


def handle_places(knots: Knots) -> dict[str, tuple[float, float]]:
    """Return where the handles are: r, s and t on their lines, u where the line of t passes 0."""
    return {"r": (0.0, knots.r), "s": (knots.u, knots.s), "t": (1.0, knots.t), "u": (knots.u, 0.0)}


@dataclass(frozen=True)
class KnotPicture:
    """A plot of one curve's transformations.

    Parameters
    ----------
    knots, direction : of the curve
    frame : where all lies
    theme : its colours
    used : the knot whose handle is under the mouse or in the hand; empty for none
    begun : what that was when the drag began; None without one
    typed, is_possible : the number that is being typed, and whether it can be a knot
    hover : the parameter that is read off; None for none
    """

    knots: Knots
    direction: Direction
    frame: Frame
    theme: Theme
    used: str = ""
    begun: float | None = None
    typed: str = ""
    is_possible: bool = True
    hover: float | None = None

    def paint(self, painter: QPainter) -> None:
        """Paint the plot with the painter's font."""
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        self._paint_ground(painter)
        values, frame = values_of(self.knots), self.frame
        painter.save()
        painter.setClipRect(frame.box.adjusted(-1, 0, 1, 0))
        for k, letter in enumerate(PARABOLA_LETTERS):
            points = [frame.at(u, value) for u, value in zip(_SAMPLES.tolist(), values[:, k].tolist(), strict=True)]
            painter.setPen(QPen(QColor(*self.colour(letter)), _LINE))
            painter.drawPolyline(QPolygonF(points))
        painter.restore()
        self._paint_labels(painter, values)
        self._paint_handles(painter)
        if self.used:
            self._paint_words(painter)

    def colour(self, name: str) -> Rgb:
        """Return the colour of a knot."""
        return self.theme.series[KNOT_SERIES[name]]

    def _paint_ground(self, painter: QPainter) -> None:
        """Paint where the curve folds, 0 and 1, the numbers and what is read off."""
        frame, theme = self.frame, self.theme
        painter.setPen(QPen(QColor(*theme.edge), 1.0))
        painter.setBrush(QColor(*theme.background))
        painter.drawRect(frame.box)
        self._paint_folds(painter)
        painter.setPen(QPen(QColor(*theme.edge), 1.0))
        for value in (0, 1):
            painter.drawLine(QLineF(frame.at(0, value), frame.at(1, value)))
        self._upright(painter, self.knots.u, theme.axis, Qt.PenStyle.DashLine)
        if self.hover is not None:
            self._upright(painter, self.hover, theme.ink, Qt.PenStyle.SolidLine)
        painter.setPen(QColor(*theme.quiet_ink))
        metrics = QFontMetricsF(painter.font())
        for value in (0, 1):
            at = frame.at(0, value)
            self._write(painter, str(value), at.x() - 9 - metrics.horizontalAdvance(str(value)), at.y())
            end = frame.at(value, frame.low)
            self._write(painter, str(value), end.x() - metrics.horizontalAdvance(str(value)) / 2, end.y() + _BOTTOM / 2)
        name = self.direction.parameter
        self._write(painter, name, frame.at(0.5, 0).x() - metrics.horizontalAdvance(name) / 2, frame.box.bottom() + 9)

    def _paint_folds(self, painter: QPainter) -> None:
        frame, theme, metrics = self.frame, self.theme, QFontMetricsF(painter.font())
        for low, high in folding_parts(self.knots):
            band = QRectF(
                QPointF(frame.at(low, 0).x(), frame.box.top()), QPointF(frame.at(high, 0).x(), frame.box.bottom())
            )
            with dimmed(painter, _FOLD_OPACITY):
                painter.fillRect(band, QColor(*theme.warn))
            painter.setPen(QPen(QColor(*theme.warn), 1.0))
            for x in (band.left(), band.right()):
                painter.drawLine(QLineF(x, band.top(), x, band.bottom()))
            for text in ("folds back", "folds"):
                if metrics.horizontalAdvance(text) + _FOLD_ROOM <= band.width():
                    x = band.center().x() - metrics.horizontalAdvance(text) / 2
                    self._write(painter, text, x, band.top() + metrics.height() / 2)
                    break

    def _upright(self, painter: QPainter, u: float, colour: Rgb, style: Qt.PenStyle) -> None:
        x = self.frame.at(u, 0).x()
        painter.setPen(QPen(QColor(*colour), 1.0, style))
        painter.drawLine(QLineF(x, self.frame.box.top(), x, self.frame.box.bottom()))

    def _paint_labels(self, painter: QPainter, values: Array) -> None:
        """Name every line on itself, where it is farthest from the others."""
        frame, metrics = self.frame, QFontMetricsF(painter.font())
        room = metrics.height() / 2 * frame.pixel("s")  # so that no name is cut
        inside = (frame.low + room < values) & (values < frame.high - room)
        inside[:, 1:] &= np.abs(_SAMPLES - self.knots.u)[:, None] > _HANDLE_ROOM
        for k, place in enumerate(label_places(np.where(inside, values, np.nan))):
            letter = PARABOLA_LETTERS[k]
            at, width = frame.at(float(_SAMPLES[place]), float(values[place, k])), metrics.horizontalAdvance(letter)
            ground = QRectF(at.x() - width / 2 - 2, at.y() - metrics.height() / 2, width + 4, metrics.height())
            painter.fillRect(ground, QColor(*self.theme.background))
            painter.setPen(QColor(*self.colour(letter)))
            self._write(painter, letter, at.x() - width / 2, at.y())

    def _paint_handles(self, painter: QPainter) -> None:
        for name, place in handle_places(self.knots).items():
            colour, is_used = QColor(*self.colour(name)), name == self.used
            at, radius = self.frame.at(*place), _USED_RADIUS if is_used else _RADIUS
            if is_used and self.begun is not None:
                with dimmed(painter, 0.5):
                    ghost = self.frame.at(*handle_places(_with(self.knots, name, self.begun))[name])
                    _draw_handle(painter, ghost, _RADIUS, (colour, QColor(*self.theme.background)), is_u=name == "u")
            ground = colour if is_used else QColor(*self.theme.background)
            _draw_handle(painter, at, radius, (colour, ground), is_u=name == "u")

    @property
    def words(self) -> str:
        """What stands beside the handle in use: the knot, and how far it is from what it was."""
        values = dict(zip(KNOT_NAMES, self.knots, strict=True))
        letter = self.direction.parameter if self.used == "u" else self.used
        symbol = f"{letter} = s" if self.used == "u" and self.knots.is_quartic else letter
        if self.typed:
            return f"{symbol} = {true_minus(self.typed)}|"
        value = values[self.used]
        moved = "" if self.begun is None else f" ({signed_text(value - self.begun)})"
        return f"{symbol} {number_text(value)}{moved}"

    def _paint_words(self, painter: QPainter) -> None:
        """Write beside the handle in use, inside the plot."""
        metrics, text, box = QFontMetricsF(painter.font()), self.words, self.frame.box
        at = self.frame.at(*handle_places(self.knots)[self.used])
        width, height = metrics.horizontalAdvance(text) + 2 * _PLATE_PAD, metrics.height() + 2
        left = at.x() + _PLATE_GAP if at.x() + _PLATE_GAP + width <= box.right() else at.x() - _PLATE_GAP - width
        top = min(max(at.y() - _PLATE_GAP - height, box.top()), box.bottom() - height)
        plate = QRectF(max(left, 0.0), top, width, height)
        painter.setPen(QPen(QColor(*self.theme.edge), 1.0))
        painter.setBrush(QColor(*self.theme.tool_tip))
        painter.drawRoundedRect(plate, 3, 3)
        painter.setPen(QColor(*(self.theme.ink if self.is_possible else self.theme.bad)))
        self._write(painter, text, plate.left() + _PLATE_PAD, plate.center().y())

    def _write(self, painter: QPainter, text: str, left: float, middle: float) -> None:
        metrics = QFontMetricsF(painter.font())
        painter.drawText(QPointF(left, middle + (metrics.ascent() - metrics.descent()) / 2), text)


def _with(knots: Knots, name: str, value: float) -> Knots:
    values = dict(zip(KNOT_NAMES, knots, strict=True))
    return Knots(**{**values, name: value})


def _draw_handle(painter: QPainter, at: QPointF, radius: float, colours: Sequence[QColor], *, is_u: bool) -> None:
    """Draw a disc, or for u a diamond, in the colours of its line and its ground."""
    line, ground = colours
    painter.setPen(QPen(line, 2.0))
    painter.setBrush(ground)
    if is_u:
        corners = ((0, -1), (1, 0), (0, 1), (-1, 0))
        painter.drawPolygon(
            QPolygonF([QPointF(at.x() + 1.15 * radius * x, at.y() + 1.15 * radius * y) for x, y in corners])
        )
    else:
        painter.drawEllipse(at, radius, radius)
