"""The axes in the corner of the view, whose ends are clicked to look from there."""

from __future__ import annotations

from functools import lru_cache

from PySide6.QtCore import QLineF, QPointF, Qt
from PySide6.QtGui import QColor, QImage, QPainter, QPen
from PySide6.QtWidgets import QWidget

from qovr_app.state.names import AXES
from qovr_app.style.canvas import blank_image, painting
from qovr_app.style.theme import Theme
from qovr_app.view3d.painter.hand import axis_colours
from qovr_app.view3d.painter.text import draw_text, plain
from qovr_app.view3d.scene.camera import Camera, Size
from qovr_app.view3d.scene.picture import Picture
from qovr_app.view3d.scene.triad import REACH, has_triad, triad_centre, triad_ends

_HALF = REACH + 2.0
"""Half the side of the image in which the triad is drawn, in logical pixels."""

_GROUND, _USED_GROUND = 0.35, 0.85
_LOW = 0.3
"""Opacity of the ground, also under the mouse, and of the low ends."""


def draw_triad(painter: QPainter, picture: Picture, size: Size) -> None:
    """Draw the triad for whoever has a mouse there: figures have none."""
    device, hand = painter.device(), picture.hand
    if hand is None or not has_triad(picture.settings, size) or not isinstance(device, (QImage, QWidget)):
        return
    x, y = triad_centre(size)
    image = _drawn(picture.camera, hand.view, picture.theme, device.devicePixelRatioF())
    painter.drawImage(QPointF(x - _HALF, y - _HALF), image)


@lru_cache(maxsize=4)
def _drawn(camera: Camera, used: str, theme: Theme, ratio: float) -> QImage:
    """Return the triad as an image: it changes with the camera alone, which stays during a drag."""
    image = blank_image((2 * _HALF, 2 * _HALF), ratio)
    with painting(image) as painter:
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        _draw(painter, camera, used, theme)
    return image


def _draw(painter: QPainter, camera: Camera, used: str, theme: Theme) -> None:
    centre, colours = QPointF(_HALF, _HALF), axis_colours(theme)
    ground = QColor(*theme.grid)
    ground.setAlphaF(_USED_GROUND if used else _GROUND)
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(ground)
    painter.drawEllipse(centre, REACH, REACH)
    for end in triad_ends(camera, (_HALF, _HALF)):
        colour, at = QColor(*colours[end.axis]), QPointF(*end.at.tolist())
        is_used = used == end.view
        fill = QColor(colour)
        fill.setAlphaF(1.0 if end.is_high or is_used else _LOW)
        if end.is_high:
            painter.setPen(QPen(colour, 2.0, Qt.PenStyle.SolidLine, Qt.PenCapStyle.RoundCap))
            painter.drawLine(QLineF(centre, at))
        painter.setPen(QPen(QColor(*theme.ink), 2.0) if is_used else QPen(colour, 1.2))
        painter.setBrush(fill)
        painter.drawEllipse(at, end.radius, end.radius)
        if end.is_high or is_used:
            text = AXES[end.axis].upper() if end.is_high else f"−{AXES[end.axis].upper()}"
            draw_text(painter, plain(text), (at.x(), at.y()), (0.5, 0.5), theme.rim)
