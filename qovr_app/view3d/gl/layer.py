"""Painted images as layers of a GL picture: what lies behind the surface, and what lies over it."""

from __future__ import annotations

import numpy as np
from OpenGL import GL
from PySide6.QtGui import QImage
from PySide6.QtOpenGL import QOpenGLShaderProgram

from qovr_app.view3d.gl.program import link_program
from qovr_app.view3d.gl.texture import make_texture


class ImageLayer:
    """A texture the size of the viewport. Everything but the construction needs the context to be current."""

    def __init__(self) -> None:
        self.forget()

    def forget(self) -> None:
        """Start without any GL object, as a new context does."""
        self._program: QOpenGLShaderProgram | None = None
        self._array = 0
        self._texture = 0
        self._size = (0, 0)

    def release(self) -> None:
        """Destroy every GL object."""
        if self._array:
            GL.glDeleteVertexArrays(1, [self._array])
            GL.glDeleteTextures([self._texture])
        self.forget()

    def upload(self, image: QImage) -> None:
        """Take over an image in the format ARGB32 premultiplied."""
        if not self._array:
            self._create()
        GL.glBindTexture(GL.GL_TEXTURE_2D, self._texture)
        GL.glPixelStorei(GL.GL_UNPACK_ALIGNMENT, 4)
        pixels = np.frombuffer(image.constBits(), dtype=np.uint8)
        size = image.width(), image.height()
        if size == self._size:
            GL.glTexSubImage2D(GL.GL_TEXTURE_2D, 0, 0, 0, *size, GL.GL_RGBA, GL.GL_UNSIGNED_BYTE, pixels)
        else:
            self._size = size
            GL.glTexImage2D(GL.GL_TEXTURE_2D, 0, GL.GL_RGBA8, *size, 0, GL.GL_RGBA, GL.GL_UNSIGNED_BYTE, pixels)

    def draw(self, *, blended: bool) -> None:
        """Cover the viewport with the image, opaque or over what is there."""
        GL.glDisable(GL.GL_DEPTH_TEST)
        if blended:
            GL.glEnable(GL.GL_BLEND)
            GL.glBlendFunc(GL.GL_ONE, GL.GL_ONE_MINUS_SRC_ALPHA)
        else:
            GL.glDisable(GL.GL_BLEND)
        self._program.bind()
        GL.glBindVertexArray(self._array)
        GL.glActiveTexture(GL.GL_TEXTURE0)
        GL.glBindTexture(GL.GL_TEXTURE_2D, self._texture)
        GL.glUniform1i(self._program.uniformLocation("u_image"), 0)
        GL.glDrawArrays(GL.GL_TRIANGLES, 0, 3)
        GL.glBindVertexArray(0)
        self._program.release()

    def _create(self) -> None:
        self._program = link_program("layer")
        self._array = int(GL.glGenVertexArrays(1))
        self._texture = make_texture(GL.GL_NEAREST)
