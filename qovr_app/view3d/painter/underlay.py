"""A picture in the plane under the net, behind the surface."""

from __future__ import annotations

from collections.abc import Iterator
from functools import lru_cache
from pathlib import Path

import numpy as np
from PySide6.QtCore import QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QImage, QImageReader, QPainter, QPolygonF, QTransform

from qovr_app.state.display import Underlay
from qovr_app.style.canvas import dimmed
from qovr_app.view3d.scene.camera import Size
from qovr_app.view3d.scene.marks import Mark, Photo
from qovr_app.view3d.scene.picture import Picture

_LARGEST_SIDE = 4096
"""Pixels: larger pictures are read smaller, more than any window shows of them."""


def underlay(picture: Picture, size: Size) -> Iterator[Mark]:
    """Yield the reference picture, if there is one and all its corners lie before the eye."""
    chosen = picture.settings.underlay
    if chosen is None or underlay_image(chosen.path) is None:
        return
    seen = picture.camera.project(_corners(picture, chosen), size)[:, :2]
    if np.isfinite(seen).all():
        yield Photo(chosen.path, seen, chosen.opacity)


def paint_photo(painter: QPainter, photo: Photo) -> None:
    """Paint a picture onto its corners; nothing where it is seen edge on."""
    image = underlay_image(photo.path)
    if image is None:
        return
    corners, onto = QPolygonF(QRectF(image.rect())), QTransform()
    corners.removeLast()  # of a rectangle, a polygon repeats the first one
    target = QPolygonF([QPointF(x, y) for x, y in photo.corners.tolist()])
    if not QTransform.quadToQuad(corners, target, onto):
        return
    with dimmed(painter, photo.opacity):
        painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform)
        painter.setTransform(onto, combine=True)
        painter.drawImage(QPointF(0, 0), image)


def _corners(picture: Picture, underlay: Underlay) -> np.ndarray:
    """Return the upper left corner and those after it, clockwise, (4, 3) in the unit space."""
    frame = picture.scene.frame
    right, top = underlay.left + underlay.width, underlay.bottom + underlay.height
    low = float(frame.limits[2, 0])
    corners = [(underlay.left, top), (right, top), (right, underlay.bottom), (underlay.left, underlay.bottom)]
    return frame.to_unit(np.array([(x, y, low) for x, y in corners]))


def underlay_image(path: str) -> QImage | None:
    """Return a picture as it is in its file now; None where the file holds none, or is no more."""
    try:
        return _read(path, Path(path).stat().st_mtime_ns)
    except OSError:
        return None


@lru_cache(maxsize=2)
def _read(path: str, _written: int) -> QImage | None:
    reader = QImageReader(path)
    reader.setAutoTransform(True)
    size = reader.size()
    if max(size.width(), size.height()) > _LARGEST_SIDE:
        reader.setScaledSize(size.scaled(QSize(_LARGEST_SIDE, _LARGEST_SIDE), Qt.AspectRatioMode.KeepAspectRatio))
    image = reader.read()
    return None if image.isNull() else image
