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
from qovr_app.view3d.scene.camera import Size
from qovr_app.view3d.scene.picture import Picture
from qovr_app.view3d.scene.triad import REACH, end_radius, has_triad, triad_centre, triad_ends

_ROOM = 2.0
"""Around a disc in its image, in logical pixels: for its rim."""

_GROUND, _USED_GROUND = 0.35, 0.85
_LOW = 0.3
"""Opacity of the ground, also under the mouse, and of the low ends."""


def draw_triad(painter: QPainter, picture: Picture, size: Size) -> None:
    """Draw the triad for whoever has a mouse there: figures have none."""
    device, hand, theme = painter.device(), picture.hand, picture.theme
    if hand is None or not has_triad(picture.settings, size) or not isinstance(device, (QImage, QWidget)):
        return
    ratio, centre = device.devicePixelRatioF(), triad_centre(size)
    _place(painter, _ground(bool(hand.view), theme, ratio), centre, ratio)
    for end in triad_ends(picture.camera, centre):
        if end.is_high:
            colour = QColor(*axis_colours(theme)[end.axis])
            painter.setPen(QPen(colour, 2.0, Qt.PenStyle.SolidLine, Qt.PenCapStyle.RoundCap))
            painter.drawLine(QLineF(*centre, *end.at.tolist()))
        image = _disc(end.axis, end.is_high, hand.view == end.view, theme, ratio)
        _place(painter, image, (float(end.at[0]), float(end.at[1])), ratio)


def _place(painter: QPainter, image: QImage, middle: tuple[float, float], ratio: float) -> None:
    """Draw an image about a point, at whole pixels of the device, between which it would be blurred."""
    half = image.width() / ratio / 2
    x, y = (round((at - half) * ratio) / ratio for at in middle)
    painter.drawImage(QPointF(x, y), image)


@lru_cache(maxsize=8)
def _ground(is_used: bool, theme: Theme, ratio: float) -> QImage:
    """Return the disc under the triad: while the camera moves, every part of it is an image that is there already."""
    half = REACH + _ROOM
    image, colour = blank_image((2 * half, 2 * half), ratio), QColor(*theme.grid)
    colour.setAlphaF(_USED_GROUND if is_used else _GROUND)
    with painting(image) as painter:
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(colour)
        painter.drawEllipse(QPointF(half, half), REACH, REACH)
    return image


@lru_cache(maxsize=64)
def _disc(axis: int, is_high: bool, is_used: bool, theme: Theme, ratio: float) -> QImage:
    """Return one end with its letter."""
    radius = end_radius(is_high=is_high)
    half = radius + _ROOM
    image, colour = blank_image((2 * half, 2 * half), ratio), QColor(*axis_colours(theme)[axis])
    fill = QColor(colour)
    fill.setAlphaF(1.0 if is_high or is_used else _LOW)
    with painting(image) as painter:
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(QPen(QColor(*theme.ink), 2.0) if is_used else QPen(colour, 1.2))
        painter.setBrush(fill)
        painter.drawEllipse(QPointF(half, half), radius, radius)
        if is_high or is_used:
            text = AXES[axis].upper() if is_high else f"−{AXES[axis].upper()}"
            draw_text(painter, plain(text), (half, half), (0.5, 0.5), theme.rim)
    return image
