"""The surface alone on a transparent image of any size, drawn in tiles with smooth edges."""

from __future__ import annotations

import math
from collections.abc import Generator

import numpy as np
from PySide6.QtCore import QPoint
from PySide6.QtGui import QImage

from qovr_app.view3d.gl import api
from qovr_app.view3d.gl.buffer import sampled_buffer
from qovr_app.view3d.gl.calls import DriverError
from qovr_app.view3d.gl.surface_item import SurfaceItem
from qovr_app.view3d.scene.camera import Size
from qovr_app.view3d.scene.picture import Picture
from qovr_core.arrays import Array

_TILE = 512
"""Pixels a side of a tile: every driver has such framebuffers, also with several samples a pixel, and without a
graphics card one is drawn in some hundredths of a second."""

Tile = tuple[QPoint, QImage]
"""A part of an image, and where its upper left corner goes."""


def tile_count(pixels: tuple[int, int]) -> int:
    """Return of how many tiles an image is made."""
    return math.prod(-(-side // _TILE) for side in pixels)


def surface_tiles(picture: Picture, size: Size, pixels: tuple[int, int]) -> Generator[Tile, None, None]:
    """Yield the surface of a picture in tiles, each drawn with the context that is current when it is asked for.

    Parameters
    ----------
    size : the viewport for which the picture is laid out, in logical pixels
    pixels : width and height of the image
    """
    item = SurfaceItem()
    try:
        for left in range(0, pixels[0], _TILE):
            for top in range(0, pixels[1], _TILE):
                tile = (left, top, min(_TILE, pixels[0] - left), min(_TILE, pixels[1] - top))
                yield QPoint(left, top), _tile_image(item, picture, size, pixels, tile)
    finally:
        item.release()


def _tile_image(
    item: SurfaceItem, picture: Picture, size: Size, pixels: tuple[int, int], tile: tuple[int, int, int, int]
) -> QImage:
    width, height = tile[2:]
    buffer = sampled_buffer((width, height))
    if not buffer.isValid() or not buffer.bind():
        raise DriverError("the driver gives no framebuffer for a figure")
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
