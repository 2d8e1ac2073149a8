"""Equal discs with a rim: few as shapes, very many as pixels that are set by arrays."""

from __future__ import annotations

import math
from functools import lru_cache
from typing import NamedTuple

import numpy as np
import numpy.typing as npt
from PySide6.QtCore import QPointF
from PySide6.QtGui import QImage, QPainter

from qovr_app.style.theme import Rgb
from qovr_app.view3d.scene.marks import MANY, Discs
from qovr_core.arrays import Array


def paint_discs(painter: QPainter, discs: Discs) -> None:
    """Paint discs with the pen and the brush that are chosen; as shapes where the drawing is kept as shapes."""
    device = painter.device()
    if len(discs.places) > MANY and isinstance(device, QImage) and discs.fill and discs.pen:
        look = _Look(discs.radius, discs.fill.colour, discs.pen.ink.colour, discs.pen.width)
        painter.drawImage(QPointF(0, 0), _stamped(discs.places, look, device))
        return
    for x, y in discs.places.tolist():
        painter.drawEllipse(QPointF(x, y), discs.radius, discs.radius)


class _Look(NamedTuple):
    """How a disc looks; the radius and the width of the rim in logical pixels."""

    radius: float
    fill: Rgb
    rim: Rgb
    rim_width: float


def _stamped(places: Array, disc: _Look, device: QImage) -> QImage:
    """Return a transparent image like the device with the discs in it, each at the nearest pixel."""
    width, height, ratio = device.width(), device.height(), device.devicePixelRatioF()
    stamp = _stamp(disc, ratio)
    reach = len(stamp) // 2
    # A border as wide as a disc reaches takes what lies half beyond the edge.
    pixels = np.zeros((height + 4 * reach, width + 4 * reach), dtype=np.uint32)
    column, row = np.floor(places * ratio).astype(np.int64).T + 2 * reach
    inside = (column >= reach) & (column < width + 3 * reach) & (row >= reach) & (row < height + 3 * reach)
    at, flat = (row * pixels.shape[1] + column)[inside], pixels.ravel()
    for (y, x), colour in np.ndenumerate(stamp):
        if colour:  # the more opaque pixel wins, for alpha is the highest byte
            to = at + ((y - reach) * pixels.shape[1] + x - reach)
            flat[to] = np.maximum(flat[to], colour)
    inner = np.ascontiguousarray(pixels[2 * reach : 2 * reach + height, 2 * reach : 2 * reach + width])
    image = QImage(inner.data, width, height, 4 * width, QImage.Format.Format_ARGB32_Premultiplied).copy()
    image.setDevicePixelRatio(ratio)
    return image


@lru_cache(maxsize=16)
def _stamp(disc: _Look, ratio: float) -> npt.NDArray[np.uint32]:
    """Return the pixels of one disc as premultiplied ARGB, (2 k + 1, 2 k + 1)."""
    outer, inner = ((disc.radius + side * disc.rim_width / 2) * ratio for side in (1, -1))
    reach = math.ceil(outer)
    x, y = np.meshgrid(*(np.arange(-reach, reach + 1),) * 2)
    away = np.hypot(x, y)
    covered, filled = (np.clip(edge - away + 0.5, 0, 1) for edge in (outer, inner))
    colour = filled[..., None] * np.array(disc.fill) + (1 - filled[..., None]) * np.array(disc.rim)
    red, green, blue = np.rint(colour * covered[..., None]).astype(np.uint32).transpose(2, 0, 1)
    alpha = np.rint(255 * covered).astype(np.uint32)
    stamp: npt.NDArray[np.uint32] = alpha << 24 | red << 16 | green << 8 | blue
    return stamp
