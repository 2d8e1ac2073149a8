"""The surface alone on a transparent image of any size, drawn in tiles with smooth edges."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import QPoint
from PySide6.QtGui import QImage

from qovr_app.style.canvas import blank_image, painting
from qovr_app.view3d.gl import api
from qovr_app.view3d.gl.buffer import sampled_buffer
from qovr_app.view3d.gl.surface_item import SurfaceItem
from qovr_app.view3d.scene.camera import Size
from qovr_app.view3d.scene.picture import Picture
from qovr_core.arrays import Array

_TILE = 2048
"""Pixels a side of a tile: every driver has such framebuffers, also with several samples a pixel."""


def surface_image(picture: Picture, size: Size, pixels: tuple[int, int]) -> QImage:
    """Return the surface of a picture, with the current context.

    Parameters
    ----------
    size : the viewport for which the picture is laid out, in logical pixels
    pixels : width and height of the image
    """
    result = blank_image(pixels, 1.0)
    item = SurfaceItem()
    try:
        with painting(result) as painter:
            for left in range(0, pixels[0], _TILE):
                for top in range(0, pixels[1], _TILE):
                    tile = (left, top, min(_TILE, pixels[0] - left), min(_TILE, pixels[1] - top))
                    painter.drawImage(QPoint(left, top), _tile_image(item, picture, size, pixels, tile))
    finally:
        item.release()
    return result


def _tile_image(
    item: SurfaceItem, picture: Picture, size: Size, pixels: tuple[int, int], tile: tuple[int, int, int, int]
) -> QImage:
    width, height = tile[2:]
    buffer = sampled_buffer((width, height))
    if not buffer.isValid() or not buffer.bind():
        raise api.DriverError("the driver gives no framebuffer for a figure")
    api.use_viewport(width, height)
    api.clear()
    matrix = _crop(pixels, tile) @ picture.camera.matrix(size)
    item.paint(picture, matrix, pixels[0] / size[0])
    image = buffer.toImage()
    buffer.release()
    return image


def _crop(pixels: tuple[int, int], tile: tuple[int, int, int, int]) -> Array:
    """Return the (4, 4) matrix that spreads a tile of the image over the whole of clip space."""
    left, top, width, height = tile
    crop = np.eye(4)
    crop[0, 0], crop[1, 1] = pixels[0] / width, pixels[1] / height
    crop[0, 3] = (pixels[0] - 2 * left) / width - 1
    crop[1, 3] = 1 - (pixels[1] - 2 * top) / height
    return crop
