"""A sentence over the picture: why it shows nothing, and what to do about it."""

from __future__ import annotations

from PySide6.QtCore import QRectF
from PySide6.QtGui import QColor, QPainter, QPen

from qovr_app.style.theme import Theme
from qovr_app.view3d.painter.text import NORMAL, draw_text, plain, text_size, wrapped
from qovr_app.view3d.scene.camera import Size

_TOP = 46.0
"""Below the mark of a stale surface."""

_PAD_X, _PAD_Y, _LEADING = 10.0, 6.0, 18.0
_SIDE = 48.0
_OPACITY = 0.92
_HINT_BOTTOM = 8.0


def draw_note(painter: QPainter, text: str, theme: Theme, size: Size) -> None:
    """Draw a text on a plate in the upper middle of the viewport; the letters after ``_`` are a subscript."""
    lines = wrapped(text, NORMAL, size[0] - 2 * _SIDE)
    width = max(text_size(line, NORMAL)[0] for line in lines)
    plate = QRectF(0, 0, width + 2 * _PAD_X, _LEADING * len(lines) + 2 * _PAD_Y)
    plate.moveTo(round((size[0] - plate.width()) / 2), _TOP)
    draw_plate(painter, plate, theme)
    for k, line in enumerate(lines):
        middle = plate.center().x(), plate.top() + _PAD_Y + _LEADING * (k + 0.5)
        draw_text(painter, line, middle, (0.5, 0.5), theme.ink, pixels=NORMAL)


def draw_hint(painter: QPainter, text: str, theme: Theme, size: Size) -> None:
    """Draw a quiet line at the bottom of the viewport."""
    place = size[0] / 2, size[1] - _HINT_BOTTOM
    draw_text(painter, plain(text), place, (0.5, 1), theme.quiet_ink, pixels=NORMAL, halo=theme.background)


def draw_plate(painter: QPainter, plate: QRectF, theme: Theme) -> None:
    """Draw the ground on which words can be read whatever lies behind."""
    ground = QColor(*theme.pane)
    ground.setAlphaF(_OPACITY)
    painter.setPen(QPen(QColor(*theme.grid), 1.0))
    painter.setBrush(ground)
    painter.drawRoundedRect(plate.adjusted(0.5, 0.5, -0.5, -0.5), 4, 4)
