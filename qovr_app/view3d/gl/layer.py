"""Painted images as layers of a GL picture: what lies behind the surface, and what lies over it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from PySide6.QtGui import QImage
from PySide6.QtOpenGL import QOpenGLShaderProgram

from qovr_app.view3d.gl import api
from qovr_app.view3d.gl.program import link_program


@dataclass
class _Objects:
    """What a layer has made in a context, and the size of the image that was loaded last."""

    program: QOpenGLShaderProgram
    array: int
    texture: int
    size: tuple[int, int] = (0, 0)


class ImageLayer:
    """A texture the size of the viewport. Everything but the construction needs the context to be current."""

    def __init__(self) -> None:
        self._objects: _Objects | None = None

    def forget(self) -> None:
        """Start without any GL object, as a new context does."""
        self._objects = None

    def release(self) -> None:
        """Destroy every GL object."""
        if self._objects is not None:
            api.delete_vertex_array(self._objects.array)
            api.delete_textures([self._objects.texture])
        self.forget()

    def draw(self, image: QImage | None, *, blended: bool) -> None:
        """Cover the viewport with an image, opaque or over what is there.

        Parameters
        ----------
        image : in the format ARGB32 premultiplied; None for the one that was drawn last
        """
        if self._objects is None:
            self._objects = _Objects(
                link_program("layer"), api.make_vertex_array(), api.make_texture(api.Filtering.NEAREST)
            )
        objects = self._objects
        if image is not None:
            _load(objects, image)
        api.draw_over(blended=blended)
        objects.program.bind()
        api.bind_vertex_array(objects.array)
        api.bind_textures([objects.texture])
        api.set_integer(objects.program.uniformLocation("u_image"), 0)
        api.draw_triangle()
        api.bind_vertex_array(0)
        objects.program.release()


def _load(objects: _Objects, image: QImage) -> None:
    size = image.width(), image.height()
    pixels = np.frombuffer(image.constBits(), dtype=np.uint8)
    api.load_image(objects.texture, pixels, size, is_resized=size != objects.size)
    objects.size = size
