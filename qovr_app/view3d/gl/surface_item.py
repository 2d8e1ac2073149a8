"""The surface as OpenGL draws it: a fixed triangulation whose vertices are rewritten at every edit.

Everything is created in ``paint``, where the context is current, and destroyed by ``release``, which the
viewport calls when it goes.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
from OpenGL import GL
from PySide6.QtGui import QMatrix3x3, QMatrix4x4, QOpenGLContext, QVector4D
from PySide6.QtOpenGL import QOpenGLBuffer, QOpenGLShaderProgram

from qovr_app.state.display import Style
from qovr_app.style.colour_maps import ENTRIES
from qovr_app.view3d.gl.program import link_program
from qovr_app.view3d.gl.texture import make_texture
from qovr_app.view3d.scene.camera import Camera
from qovr_app.view3d.scene.colouring import UNDEFINED, Colouring
from qovr_app.view3d.scene.mesh import Counts, FloatArray, facet_counts, surface_vertices, triangle_indices
from qovr_app.view3d.scene.patterns import BAND, DARK_STRIPE, LARGEST_ANGLE, LIGHT_STRIPE, STRIPE
from qovr_app.view3d.scene.picture import Picture
from qovr_app.view3d.scene.surface_style import POINT_SIZE, line_opacity, line_periods, line_width, relief
from qovr_core.arrays import Array
from qovr_core.geometry.patch import Patch

_ATTRIBUTES = ("a_position", "a_normal", "a_part")
_PART = _ATTRIBUTES.index("a_part")
_FLOAT_BYTES = 4
_VERTEX_BYTES = 6 * _FLOAT_BYTES

_STYLE_DEFINES = {
    Style.FACETS: (),
    Style.SMOOTH: ("LIGHT", "NORMALS"),
    Style.WIREFRAME: ("WIREFRAME",),
    Style.POINTS: ("POINTS",),
}


@dataclass(frozen=True, eq=False)
class Shot:
    """How one painting looks at the scene: ``matrix`` (4, 4) to clip coordinates, the camera it belongs to, and the
    device pixels a logical pixel has."""

    matrix: Array
    camera: Camera
    pixel_ratio: float


class SurfaceItem:
    """The surface of a picture, drawn with the current context."""

    def __init__(self) -> None:
        self._picture: Picture | None = None
        self._shot: Shot | None = None
        self.forget()

    def forget(self) -> None:
        """Start without any GL object, as a new context does."""
        self._programs: dict[frozenset[str], QOpenGLShaderProgram] = {}
        self._array = 0
        self._vertices: QOpenGLBuffer | None = None
        self._parts: QOpenGLBuffer | None = None
        self._indices: QOpenGLBuffer | None = None
        self._textures: list[int] = []
        self._faceted: tuple[Colouring, Counts] | None = None
        self._parted: tuple[Colouring, Counts] | None = None
        self._drawn: tuple[Patch, Counts] | None = None
        self._indexed: Counts | None = None
        self._table: npt.NDArray[np.uint8] | None = None

    def show_picture(self, picture: Picture, shot: Shot) -> None:
        """Set what the next ``paint`` draws and from where."""
        self._picture, self._shot = picture, shot

    def release(self) -> None:
        """Destroy every GL object; a context that shares them is current."""
        if self._array:
            GL.glDeleteVertexArrays(1, [self._array])
            self._vertices.destroy()
            self._parts.destroy()
            self._indices.destroy()
            GL.glDeleteTextures(self._textures)
        self.forget()

    def paint(self) -> None:
        picture = self._picture
        if picture is None or picture.scene is None or not picture.settings.surface:
            return
        if not self._array:
            self._create()
        GL.glBindVertexArray(self._array)
        self._upload(picture)
        style = picture.settings.style
        program = self._program(picture)
        program.bind()
        self._set_uniforms(program, picture)
        for unit, texture in enumerate(self._textures):
            GL.glActiveTexture(GL.GL_TEXTURE0 + unit)
            GL.glBindTexture(GL.GL_TEXTURE_2D, texture)
        GL.glActiveTexture(GL.GL_TEXTURE0)
        self._draw(style, picture.counts)
        program.release()
        GL.glBindVertexArray(0)

    def _create(self) -> None:
        self._array = int(GL.glGenVertexArrays(1))
        self._vertices = QOpenGLBuffer(QOpenGLBuffer.Type.VertexBuffer)
        self._indices = QOpenGLBuffer(QOpenGLBuffer.Type.IndexBuffer)
        self._parts = QOpenGLBuffer(QOpenGLBuffer.Type.VertexBuffer)
        if not (self._vertices.create() and self._parts.create() and self._indices.create()):
            raise RuntimeError("the driver creates no vertex buffers")
        for buffer in (self._vertices, self._parts):
            buffer.setUsagePattern(QOpenGLBuffer.UsagePattern.DynamicDraw)
        self._textures = [make_texture(GL.GL_LINEAR), make_texture(GL.GL_NEAREST)]

    def _program(self, picture: Picture) -> QOpenGLShaderProgram:
        settings = picture.settings
        defines = set(_STYLE_DEFINES[settings.style])
        if picture.colouring.pattern is not None:
            defines |= {picture.colouring.pattern.define, "NORMALS"}
        if picture.has_facets:
            defines |= {"FACETS", "CELLS"}
        if line_opacity(settings) > 0:
            defines |= {"LINES", "CELLS"}
        key = frozenset(defines)
        if key not in self._programs:
            self._programs[key] = link_program("surface", defines=sorted(defines), attributes=_ATTRIBUTES)
        return self._programs[key]

    def _upload(self, picture: Picture) -> None:
        """Bring to the driver what has changed since the last painting."""
        counts, patch = picture.counts, picture.scene.patch
        if self._drawn is None or self._drawn[0] is not patch or self._drawn[1] != counts:
            self._upload_vertices(patch, counts)
        if self._indexed != counts:
            indices = triangle_indices(counts)
            self._indices.bind()  # stays bound: the vertex array object remembers it
            self._indices.allocate(indices, indices.nbytes)
            self._indexed = counts
        self._upload_colours(picture.colouring, picture.coloured_counts, has_facets=picture.has_facets)

    def _upload_colours(self, colouring: Colouring, counts: Counts, *, has_facets: bool) -> None:
        if self._table is not colouring.table:
            self._table = colouring.table
            GL.glBindTexture(GL.GL_TEXTURE_2D, self._textures[0])
            GL.glPixelStorei(GL.GL_UNPACK_ALIGNMENT, 1)
            GL.glTexImage2D(GL.GL_TEXTURE_2D, 0, GL.GL_RGB8, ENTRIES, 1, 0, GL.GL_RGB, GL.GL_UNSIGNED_BYTE, self._table)
        if has_facets:
            if self._faceted != (colouring, counts):
                self._faceted = colouring, counts
                self._upload_facets(colouring.parts(counts))
        elif self._parted != (colouring, counts):
            self._parted = colouring, counts
            self._upload_parts(colouring.parts(counts))

    def _upload_facets(self, parts: FloatArray) -> None:
        n, m = parts.shape
        GL.glBindTexture(GL.GL_TEXTURE_2D, self._textures[1])
        GL.glPixelStorei(GL.GL_UNPACK_ALIGNMENT, 4)
        GL.glTexImage2D(GL.GL_TEXTURE_2D, 0, GL.GL_R32F, m, n, 0, GL.GL_RED, GL.GL_FLOAT, parts)

    def _upload_parts(self, parts: FloatArray) -> None:
        self._parts.bind()
        self._parts.allocate(parts, parts.nbytes)
        GL.glVertexAttribPointer(_PART, 1, GL.GL_FLOAT, False, _FLOAT_BYTES, GL.ctypes.c_void_p(0))
        GL.glEnableVertexAttribArray(_PART)
        self._parts.release()

    def _upload_vertices(self, patch: Patch, counts: Counts) -> None:
        vertices = surface_vertices(patch, counts)
        self._vertices.bind()
        if self._drawn is not None and self._drawn[1] == counts:
            self._vertices.write(0, vertices, vertices.nbytes)
        else:
            self._vertices.allocate(vertices, vertices.nbytes)
            for location in range(_PART):
                offset = GL.ctypes.c_void_p(3 * _FLOAT_BYTES * location)
                GL.glVertexAttribPointer(location, 3, GL.GL_FLOAT, False, _VERTEX_BYTES, offset)
                GL.glEnableVertexAttribArray(location)
        self._vertices.release()
        self._drawn = (patch, counts)

    def _set_uniforms(self, program: QOpenGLShaderProgram, picture: Picture) -> None:
        settings, scene, shot = picture.settings, picture.scene, self._shot
        cells = np.subtract(scene.document.samples, 1)
        fine, coarse = line_periods(scene.document.samples)
        line = (*(channel / 255 for channel in picture.theme.surface_line), line_opacity(settings))
        at = program.uniformLocation
        program.setUniformValue(at("u_matrix"), QMatrix4x4(shot.matrix.ravel().tolist()))
        program.setUniformValue(at("u_view"), QMatrix3x3(shot.camera.axes.ravel().tolist()))
        GL.glUniform2f(at("u_counts"), *picture.counts)
        GL.glUniform2f(at("u_cells"), *cells.tolist())
        for name, period in (("u_fine", fine), ("u_coarse", coarse)):
            GL.glUniform4f(at(name), *period, *(1 / cells for cells in period))
        program.setUniformValue(at("u_line"), QVector4D(*line))
        GL.glUniform4f(at("u_eye"), *shot.camera.eye.tolist())
        for name, colour in (
            ("u_undefined", picture.theme.undefined), ("u_light_stripe", LIGHT_STRIPE), ("u_dark_stripe", DARK_STRIPE)
        ):  # fmt: skip
            GL.glUniform3f(at(name), *(channel / 255 for channel in colour))
        GL.glUniform1f(at("u_no_value"), UNDEFINED / 2)
        GL.glUniform1f(at("u_relief"), relief(settings))
        GL.glUniform3f(at("u_degrees"), STRIPE, BAND, LARGEST_ANGLE)
        GL.glUniform1f(at("u_line_width"), line_width(settings.style) * shot.pixel_ratio)
        GL.glUniform1f(at("u_logical"), 1 / shot.pixel_ratio)
        GL.glUniform1f(at("u_point_size"), POINT_SIZE * shot.pixel_ratio)
        GL.glUniform1i(at("u_colours"), 0)
        if picture.has_facets:
            GL.glUniform1i(at("u_samples"), 1)
            facets = np.subtract(facet_counts(scene.document.samples), 1)
            GL.glUniform4f(at("u_facets"), *(facets - 1).tolist(), *(facets / cells).tolist())

    def _draw(self, style: Style, counts: Counts) -> None:
        see_through = style is Style.WIREFRAME
        GL.glDisable(GL.GL_CULL_FACE)
        if see_through:
            # Lines behind lines stay visible, so that nothing may write depth; the shader's colours are
            # premultiplied.
            GL.glDisable(GL.GL_DEPTH_TEST)
            GL.glEnable(GL.GL_BLEND)
            GL.glBlendFunc(GL.GL_ONE, GL.GL_ONE_MINUS_SRC_ALPHA)
        else:
            GL.glEnable(GL.GL_DEPTH_TEST)
            GL.glDepthMask(True)
            GL.glDisable(GL.GL_BLEND)
        if style is Style.POINTS:
            if not QOpenGLContext.currentContext().isOpenGLES():  # there it is always so
                GL.glEnable(GL.GL_PROGRAM_POINT_SIZE)
            GL.glDrawArrays(GL.GL_POINTS, 0, counts[0] * counts[1])
        else:
            GL.glDrawElements(GL.GL_TRIANGLES, triangle_indices(counts).size, GL.GL_UNSIGNED_INT, None)
