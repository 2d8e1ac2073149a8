"""Drawings that change more rarely than the picture around them: kept as images where pixels are drawn."""

from __future__ import annotations

from functools import lru_cache

from PySide6.QtCore import QPointF, QRectF
from PySide6.QtGui import QImage, QPainter

from qovr_app.style.canvas import blank_image, painting
from qovr_app.view3d.scene.marks import Box, Drawing, Strip


def paint_strip(painter: QPainter, strip: Strip) -> None:
    """Paint a strip: on pixels by its image."""
    device, larger = painter.device(), strip.larger
    if isinstance(device, QImage):
        ratio = device.devicePixelRatioF()
        image = strip_image(strip, ratio)
        corner = QPointF(strip.box.left * larger, strip.box.top * larger)
        painter.drawImage(QRectF(corner, image.size().toSizeF() / ratio), image)
    else:
        painter.save()
        painter.scale(larger, larger)
        strip.drawing.paint(painter)
        painter.restore()


def strip_corner(strip: Strip, ratio: float) -> tuple[int, int]:
    """Return the device's pixel at the upper left of a strip's image."""
    return round(strip.box.left * strip.larger * ratio), round(strip.box.top * strip.larger * ratio)


def strip_image(strip: Strip, ratio: float) -> QImage:
    """Return the image of a strip at a device pixel ratio."""
    return _drawn(strip.drawing, strip.box, ratio * strip.larger)


@lru_cache(maxsize=4)
def _drawn(drawing: Drawing, box: Box, ratio: float) -> QImage:
    left, top, width, height = box
    image = blank_image((width, height), ratio)
    with painting(image) as painter:
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.translate(-left, -top)
        drawing.paint(painter)
    return image
