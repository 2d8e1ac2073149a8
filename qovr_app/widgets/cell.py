"""The cell behind a number: its background, frame and bar say what the number's state is."""

from __future__ import annotations

from dataclasses import dataclass

from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QPainter, QPen

from qovr_app.style.palette import theme_in_force
from qovr_app.style.theme import Rgb

_RADIUS = 3.0
_BAR = 3.0
_CORNER = 7.0


@dataclass(frozen=True)
class Marks:
    """What there is to say of a number.

    ``is_pending`` it is not set, ``is_bad`` it was refused, ``is_warned`` it will surprise, ``is_marked`` it belongs to
    what is selected.
    """

    is_pending: bool
    is_bad: bool
    is_warned: bool
    is_marked: bool
    has_focus: bool
    is_hovered: bool


def paint_cell(painter: QPainter, rect: QRectF, marks: Marks) -> None:
    """Paint a cell. State has a colour and, for eyes that do not see it, a place: a bar, a frame, a corner."""
    colours = theme_in_force()
    fill, edge, bar = _colours(marks)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    frame = rect.adjusted(0.5, 0.5, -0.5, -0.5)
    painter.setPen(QPen(QColor(*edge), 1.0))
    painter.setBrush(QColor(*fill))
    painter.drawRoundedRect(frame, _RADIUS, _RADIUS)
    if marks.has_focus or marks.is_bad:
        painter.setBrush(Qt.BrushStyle.NoBrush)
        painter.drawRoundedRect(frame.adjusted(1, 1, -1, -1), _RADIUS - 1, _RADIUS - 1)
    painter.setPen(Qt.PenStyle.NoPen)
    if bar is not None:
        painter.setBrush(QColor(*bar))
        painter.drawRoundedRect(QRectF(1, 1, _BAR, rect.height() - 2), _BAR / 2, _BAR / 2)
    if marks.is_warned:
        painter.setBrush(QColor(*colours.ink))
        painter.drawPolygon([QPointF(1, 1), QPointF(1 + _CORNER, 1), QPointF(1, 1 + _CORNER)])


def _colours(marks: Marks) -> tuple[Rgb, Rgb, Rgb | None]:
    """Return background, frame and bar: blue for the keyboard, orange for selected, amber for pending, red for bad."""
    colours = theme_in_force()
    edge = colours.hover if marks.is_hovered else colours.edge
    if marks.is_marked:
        edge = colours.selected
    if marks.has_focus:
        edge = colours.accent
    if marks.is_bad:
        return colours.bad_cell, colours.bad, colours.bad
    if marks.is_pending:
        return colours.pending_cell, edge, colours.pending
    return colours.cell, edge, colours.selected if marks.is_marked else None
