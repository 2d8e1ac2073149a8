"""Images in one texture: each is brought there once, and drawn from there as long as it is."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Mapping
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
import numpy.typing as npt
from PySide6.QtGui import QImage

from qovr_app.view3d.gl import api

_LEAST_SIDE = 1024
_LOWEST = 0.7
"""Part of a shelf's height that an image has at least which is put on it."""

Pixel = tuple[int, int]


class Patch(NamedTuple):
    """An image in the atlas, without what is transparent around it.

    Parameters
    ----------
    corner : its upper left one in the texture
    inset : how far that lies from the image's own
    size : width and height
    """

    corner: Pixel
    inset: Pixel
    size: Pixel


@dataclass
class _Shelf:
    """A row of images beside one another."""

    top: int
    height: int
    used: int = 0


class Atlas:
    """A texture that holds images; when it is full, all but those of the frame at hand go, or it grows.

    Everything but the construction needs the context to be current.
    """

    def __init__(self) -> None:
        self.forget()

    def forget(self) -> None:
        """Start without any GL object, as a new context does."""
        self._texture, self._side = 0, 0
        self._empty()

    def release(self) -> None:
        """Destroy the texture."""
        if self._texture:
            api.delete_textures([self._texture])
        self.forget()

    @property
    def texture(self) -> int:
        """The texture's name."""
        if not self._texture:
            self._texture = api.make_texture(api.Filtering.NEAREST)
        return self._texture

    def places(self, images: Mapping[Hashable, Callable[[], QImage]]) -> dict[Hashable, Patch]:
        """Return where every image is in the texture; those that are not there are made.

        Parameters
        ----------
        images : what makes each image, in the format ARGB32 premultiplied, by what tells it from others
        """
        if not self._take(images):
            self._empty()
            while not self._take(images):
                self._grow()
        return {key: self._places[key] for key in images}

    def _empty(self) -> None:
        self._shelves: list[_Shelf] = []
        self._places: dict[Hashable, Patch] = {}

    def _grow(self) -> None:
        self._side = max(_LEAST_SIDE, 2 * self._side)
        api.load_image(self.texture, None, (self._side, self._side))
        self._empty()

    def _take(self, images: Mapping[Hashable, Callable[[], QImage]]) -> bool:
        """Bring in what is missing; return whether there was room for it."""
        for key in images.keys() - self._places.keys():
            inset, pixels = _inked(images[key]())
            size = pixels.shape[1], pixels.shape[0]
            corner = self._room(*size)
            if corner is None:
                return False
            api.load_part(self.texture, pixels, corner, size)
            self._places[key] = Patch(corner, inset, size)
        return True

    def _room(self, width: int, height: int) -> Pixel | None:
        """Return the corner of a place for an image, which then is taken; None where there is none."""
        for shelf in self._shelves:
            if _LOWEST * shelf.height <= height <= shelf.height and shelf.used + width <= self._side:
                break
        else:
            top = self._shelves[-1].top + self._shelves[-1].height if self._shelves else 0
            if width > self._side or top + height > self._side:
                return None
            shelf = _Shelf(top, height)
            self._shelves.append(shelf)
        shelf.used += width
        return shelf.used - width, shelf.top


def _inked(image: QImage) -> tuple[Pixel, npt.NDArray[np.uint8]]:
    """Return where the ink of an image begins, and its pixels (n, m, 4) from there to where it ends."""
    pixels = np.frombuffer(image.constBits(), dtype=np.uint8).reshape(image.height(), image.width(), 4)
    rows, columns = (np.flatnonzero(pixels[..., 3].any(axis=axis)) for axis in (1, 0))
    if not len(rows):
        return (0, 0), np.zeros((1, 1, 4), dtype=np.uint8)
    left, top = int(columns[0]), int(rows[0])
    return (left, top), np.ascontiguousarray(pixels[top : rows[-1] + 1, left : columns[-1] + 1])
