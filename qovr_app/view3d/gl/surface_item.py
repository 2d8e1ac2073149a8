"""The surface as OpenGL draws it: a fixed triangulation whose vertices are rewritten at every edit.

Everything is created in ``paint``, where the context is current, and destroyed by ``release``, which the
viewport calls when it goes.
"""

from __future__ import annotations

import math

import numpy as np
from PySide6.QtGui import QMatrix3x3, QMatrix4x4, QVector4D
from PySide6.QtOpenGL import QOpenGLShaderProgram

from qovr_app.state.display import Style
from qovr_app.view3d.gl import api
from qovr_app.view3d.gl.program import link_program
from qovr_app.view3d.gl.surface_buffers import ATTRIBUTES, SurfaceBuffers
from qovr_app.view3d.scene.colouring import UNDEFINED
from qovr_app.view3d.scene.grid import Grid, windows_of
from qovr_app.view3d.scene.mesh import CORNERS
from qovr_app.view3d.scene.patterns import BAND, BELOW, BELOW_PART, DARK_STRIPE, LARGEST_ANGLE, LIGHT_STRIPE, STRIPE
from qovr_app.view3d.scene.picture import Picture
from qovr_app.view3d.scene.surface_style import POINT_SIZE, line_opacity, line_periods, line_width, relief
from qovr_core.arrays import Array

_STYLE_DEFINES: dict[Style, tuple[str, ...]] = {
    Style.FACETS: (),
    Style.SMOOTH: ("LIGHT", "NORMALS"),
    Style.CLAY: ("LIGHT", "NORMALS"),
    Style.WIREFRAME: ("WIREFRAME",),
    Style.POINTS: ("POINTS",),
}


class SurfaceItem:
    """The surface of pictures, drawn with the current context."""

    def __init__(self) -> None:
        self.forget()

    def forget(self) -> None:
        """Start without any GL object, as a new context does."""
        self._programs: dict[frozenset[str], QOpenGLShaderProgram] = {}
        self._buffers: SurfaceBuffers | None = None

    def release(self) -> None:
        """Destroy every GL object; a context that shares them is current."""
        if self._buffers is not None:
            self._buffers.release()
        self.forget()

    def load(self, picture: Picture) -> None:
        """Bring what is new of a picture into the buffers."""
        if picture.settings.surface:
            self._bind(picture)
            api.bind_vertex_array(0)

    def paint(self, picture: Picture, matrix: Array, pixel_ratio: float) -> None:
        """Draw the surface of a picture.

        Parameters
        ----------
        matrix : (4, 4), from the unit space to clip coordinates
        pixel_ratio : device pixels a logical pixel has
        """
        if not picture.settings.surface:
            return
        self._bind(picture)
        program = self._program(picture)
        program.bind()
        set_uniforms(program, picture, matrix, pixel_ratio)
        _draw(picture.settings.style, picture.grid)
        program.release()
        api.bind_vertex_array(0)

    def _bind(self, picture: Picture) -> None:
        if self._buffers is None:
            self._buffers = SurfaceBuffers()
        self._buffers.bind(picture)

    def _program(self, picture: Picture) -> QOpenGLShaderProgram:
        defines = defines_of(picture)
        if defines not in self._programs:
            self._programs[defines] = link_program("surface", defines=sorted(defines), attributes=ATTRIBUTES)
        return self._programs[defines]


def defines_of(picture: Picture) -> frozenset[str]:
    """Return the macros of the shaders that draw a picture's surface."""
    settings = picture.settings
    defines = set(_STYLE_DEFINES[settings.style])
    if picture.colouring.pattern is not None:
        defines |= {picture.colouring.pattern.define, "NORMALS"}
    if settings.document_samples:
        defines |= {"SAMPLES"} if picture.colouring.ramp is None else {"SAMPLES", "RAMP"}
    elif picture.has_facets:
        defines |= {"FACETS", "CELLS"}
    if line_opacity(settings) > 0:
        defines |= {"LINES", "CELLS"}
    if windows_of(picture.scene.patch) != (1, 1):
        defines.add("NET")
    return frozenset(defines)


def set_uniforms(program: QOpenGLShaderProgram, picture: Picture, matrix: Array, pixel_ratio: float) -> None:
    """Tell the program that is bound how a picture's surface looks, and from where; parameters as of ``paint``."""
    _set_view(program, picture, matrix)
    _set_samples(program, picture)
    _set_style(program, picture, pixel_ratio)


def _set_view(program: QOpenGLShaderProgram, picture: Picture, matrix: Array) -> None:
    """Say from where the surface is seen."""
    at = program.uniformLocation
    program.setUniformValue(at("u_matrix"), QMatrix4x4(matrix.ravel().tolist()))
    program.setUniformValue(at("u_view"), QMatrix3x3(picture.camera.axes.ravel().tolist()))
    api.set_floats(at("u_eye"), *picture.camera.eye.tolist())


def _set_samples(program: QOpenGLShaderProgram, picture: Picture) -> None:
    """Say how the vertices lie among the samples, and which samples have a line."""
    at, cells = program.uniformLocation, picture.lined_grid.cells
    api.set_floats(at("u_counts"), *picture.grid.shape)
    api.set_floats(at("u_cells"), *cells)
    for name, period in zip(("u_fine", "u_coarse"), line_periods(cells), strict=True):
        api.set_floats(at(name), *period, *(1 / cells_apart for cells_apart in period))
    if picture.colouring.ramp is not None:
        api.set_floats(at("u_ramp"), *picture.colouring.ramp)
    if picture.has_facets:
        api.set_integer(at("u_samples"), 1)
        facets = np.array(picture.facets.cells)
        api.set_floats(at("u_facets"), *(facets - 1).tolist(), *(facets / cells).tolist())


def _set_style(program: QOpenGLShaderProgram, picture: Picture, pixel_ratio: float) -> None:
    """Say how lines, points, light and colours look."""
    at, settings, theme = program.uniformLocation, picture.settings, picture.theme
    red, green, blue = (channel / 255 for channel in theme.surface_line)
    program.setUniformValue(at("u_line"), QVector4D(red, green, blue, line_opacity(settings)))
    for name, colour in (
        ("u_undefined", theme.undefined),
        ("u_light_stripe", LIGHT_STRIPE),
        ("u_dark_stripe", DARK_STRIPE),
    ):
        api.set_floats(at(name), *(channel / 255 for channel in colour))
    turned = -1 if picture.scene.is_turned else 1
    api.set_floats(at("u_below"), *(channel / 255 for channel in BELOW), turned * BELOW_PART)
    api.set_floats(at("u_no_value"), UNDEFINED / 2)
    api.set_floats(at("u_relief"), relief(settings))
    api.set_floats(at("u_degrees"), STRIPE, BAND, LARGEST_ANGLE)
    api.set_floats(at("u_line_width"), line_width(settings.style) * pixel_ratio)
    api.set_floats(at("u_logical"), 1 / pixel_ratio)
    api.set_floats(at("u_point_size"), POINT_SIZE * pixel_ratio)
    api.set_integer(at("u_colours"), 0)


def _draw(style: Style, grid: Grid) -> None:
    api.show_both_sides()
    if style is Style.WIREFRAME:
        # Lines behind lines stay visible, so that nothing may write depth; the shader's colours are premultiplied.
        api.draw_over(blended=True)
    else:
        api.draw_in_depth()
    if style is Style.POINTS:
        api.draw_points(range(math.prod(grid.shape)))
    else:
        api.draw_triangles(CORNERS * math.prod(grid.cells))
