"""Images to paint on, and painters that end whatever happens."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

from PySide6.QtCore import Qt
from PySide6.QtGui import QImage, QPagedPaintDevice, QPaintDevice, QPainter


@contextmanager
def painting(device: QPaintDevice | QPagedPaintDevice) -> Iterator[QPainter]:
    """Give a painter and end it, also after an error: Qt crashes when its device goes before it."""
    painter = QPainter(device)
    try:
        yield painter
    finally:
        painter.end()


@contextmanager
def dimmed(painter: QPainter, opacity: float) -> Iterator[None]:
    """Draw with an opacity, and then as before.

    The state is saved and restored for it: a PDF writer takes no notice of an opacity that changes alone, and would
    give it to all that comes after in the same colour.
    """
    painter.save()
    painter.setOpacity(opacity)
    yield
    painter.restore()


def blank_image(size: tuple[float, float], ratio: float, reused: QImage | None = None) -> QImage:
    """Return a transparent image for logical pixels at a device pixel ratio; the reused one where it fits."""
    width, height = (max(1, round(side * ratio)) for side in size)
    image = reused
    if image is None or (image.width(), image.height()) != (width, height):
        image = QImage(width, height, QImage.Format.Format_ARGB32_Premultiplied)
    image.setDevicePixelRatio(ratio)
    image.fill(Qt.GlobalColor.transparent)
    return image
