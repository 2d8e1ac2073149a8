"""Texts and strips as images, for whoever draws them without the painter."""

from __future__ import annotations

from collections.abc import Hashable

from PySide6.QtGui import QImage

from qovr_app.view3d.painter.strip import strip_corner, strip_image
from qovr_app.view3d.painter.text import text_corner, text_image
from qovr_app.view3d.painter.underlay import underlay_image
from qovr_app.view3d.scene.marks import Strip, Text


class Sprites:
    """The images of marks, at so many pixels of the device a logical one."""

    def key(self, sprite: Text | Strip, ratio: float) -> Hashable:
        """Return what decides the pixels of a mark."""
        if isinstance(sprite, Text):
            return sprite.lettering, ratio
        return sprite.drawing, sprite.box, sprite.larger * ratio

    def image(self, sprite: Text | Strip, ratio: float) -> QImage:
        """Return the pixels of a mark."""
        return text_image(sprite.lettering, ratio) if isinstance(sprite, Text) else strip_image(sprite, ratio)

    def corner(self, sprite: Text | Strip, ratio: float) -> tuple[int, int]:
        """Return the device's pixel that is the upper left one of a mark."""
        return text_corner(sprite, ratio) if isinstance(sprite, Text) else strip_corner(sprite, ratio)

    def photo(self, path: str) -> QImage | None:
        """Return the reference picture in a file."""
        return underlay_image(path)
