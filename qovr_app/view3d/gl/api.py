"""What the view needs of OpenGL, for the context that is current."""

from __future__ import annotations

from collections.abc import Sequence
from enum import Enum
from typing import Any

import numpy as np
import numpy.typing as npt
from PySide6.QtGui import QOpenGLContext

from qovr_app.view3d.gl.calls import GL, delete_names, gl, made_names

_FLOAT_BYTES = 4


class Filtering(Enum):
    """What lies between the pixels of a texture."""

    NEAREST = GL.NEAREST
    LINEAR = GL.LINEAR


def make_texture(filtering: Filtering) -> int:
    """Return the name of a new texture that ends at its edges."""
    texture = made_names("glGenTextures")[0]
    gl("glBindTexture", GL.TEXTURE_2D, texture)
    for name in (GL.TEXTURE_MIN_FILTER, GL.TEXTURE_MAG_FILTER):
        gl("glTexParameteri", GL.TEXTURE_2D, name, filtering.value)
    for name in (GL.TEXTURE_WRAP_S, GL.TEXTURE_WRAP_T):
        gl("glTexParameteri", GL.TEXTURE_2D, name, GL.CLAMP_TO_EDGE)
    return texture


def delete_textures(textures: Sequence[int]) -> None:
    """Destroy textures."""
    delete_names("glDeleteTextures", textures)


def bind_textures(textures: Sequence[int]) -> None:
    """Give the first texture units these textures."""
    for unit, texture in enumerate(textures):
        gl("glActiveTexture", GL.TEXTURE0 + unit)
        gl("glBindTexture", GL.TEXTURE_2D, texture)
    gl("glActiveTexture", GL.TEXTURE0)


def load_image(texture: int, pixels: npt.NDArray[np.uint8] | None, size: tuple[int, int]) -> None:
    """Give a texture a size, and fill it with an image's pixels, four bytes each, or let it be filled later."""
    gl("glBindTexture", GL.TEXTURE_2D, texture)
    gl("glPixelStorei", GL.UNPACK_ALIGNMENT, 4)
    address = 0 if pixels is None else _address(pixels)
    gl("glTexImage2D", GL.TEXTURE_2D, 0, GL.RGBA8, *size, 0, GL.RGBA, GL.UNSIGNED_BYTE, address)


def load_part(texture: int, pixels: npt.NDArray[np.uint8], corner: tuple[int, int], size: tuple[int, int]) -> None:
    """Fill a part of a texture, from its corner on, with an image's pixels, four bytes each."""
    gl("glBindTexture", GL.TEXTURE_2D, texture)
    gl("glPixelStorei", GL.UNPACK_ALIGNMENT, 4)
    gl("glTexSubImage2D", GL.TEXTURE_2D, 0, *corner, *size, GL.RGBA, GL.UNSIGNED_BYTE, _address(pixels))


def load_colours(texture: int, table: npt.NDArray[np.uint8]) -> None:
    """Fill a texture of one row with red, green and blue, (k, 3)."""
    gl("glBindTexture", GL.TEXTURE_2D, texture)
    gl("glPixelStorei", GL.UNPACK_ALIGNMENT, 1)
    gl("glTexImage2D", GL.TEXTURE_2D, 0, GL.RGB8, len(table), 1, 0, GL.RGB, GL.UNSIGNED_BYTE, _address(table))


def load_values(texture: int, values: npt.NDArray[np.float32]) -> None:
    """Fill a texture with numbers, (n, m), of which m are a row."""
    rows, columns = values.shape
    gl("glBindTexture", GL.TEXTURE_2D, texture)
    gl("glPixelStorei", GL.UNPACK_ALIGNMENT, 4)
    gl("glTexImage2D", GL.TEXTURE_2D, 0, GL.R32F, columns, rows, 0, GL.RED, GL.FLOAT, _address(values))


def make_vertex_array() -> int:
    """Return the name of a new vertex array object."""
    return made_names("glGenVertexArrays")[0]


def delete_vertex_array(array: int) -> None:
    """Destroy a vertex array object."""
    delete_names("glDeleteVertexArrays", [array])


def bind_vertex_array(array: int) -> None:
    """Take vertices from an array object, or from none for 0."""
    gl("glBindVertexArray", array)


def make_buffer() -> int:
    """Return the name of a new buffer."""
    return made_names("glGenBuffers")[0]


def delete_buffers(buffers: Sequence[int]) -> None:
    """Destroy buffers."""
    delete_names("glDeleteBuffers", buffers)


def load_attributes(
    buffer: int, values: npt.NDArray[np.float32], widths: Sequence[int], *, location: int, is_resized: bool
) -> None:
    """Fill a buffer with the attributes of vertices, and give them to the bound vertex array.

    Parameters
    ----------
    values : contiguous, for every vertex all its attributes
    widths : floats of each attribute
    location : of the first attribute; the next ones follow
    is_resized : whether there are more or fewer values than the buffer has
    """
    gl("glBindBuffer", GL.ARRAY_BUFFER, buffer)
    if is_resized:
        gl("glBufferData", GL.ARRAY_BUFFER, values.nbytes, _address(values), GL.DYNAMIC_DRAW)
        stride, offset = _FLOAT_BYTES * sum(widths), 0
        for at, width in enumerate(widths, start=location):
            gl("glVertexAttribPointer", at, width, GL.FLOAT, 0, stride, offset)
            gl("glEnableVertexAttribArray", at)
            offset += _FLOAT_BYTES * width
    else:
        gl("glBufferSubData", GL.ARRAY_BUFFER, 0, values.nbytes, _address(values))
    gl("glBindBuffer", GL.ARRAY_BUFFER, 0)


def rewrite(buffer: int, values: npt.NDArray[np.float32], rows: slice) -> None:
    """Bring some rows of the values that a buffer holds, contiguous, to the driver again."""
    some = values[rows]
    if some.size:
        gl("glBindBuffer", GL.ARRAY_BUFFER, buffer)
        gl("glBufferSubData", GL.ARRAY_BUFFER, rows.start * values.strides[0], some.nbytes, _address(some))
        gl("glBindBuffer", GL.ARRAY_BUFFER, 0)


def load_indices(buffer: int, indices: npt.NDArray[np.uint32]) -> None:
    """Fill a buffer with the indices of triangles; it stays bound, which the bound vertex array remembers."""
    gl("glBindBuffer", GL.ELEMENT_ARRAY_BUFFER, buffer)
    gl("glBufferData", GL.ELEMENT_ARRAY_BUFFER, indices.nbytes, _address(indices), GL.STATIC_DRAW)


def set_floats(location: int, *values: float) -> None:
    """Set a uniform of one to four floats of the program that is bound."""
    gl(f"glUniform{len(values)}f", location, *values)


def set_integer(location: int, value: int) -> None:
    """Set a uniform of one integer, such as a texture unit, of the program that is bound."""
    gl("glUniform1i", location, value)


def clear(red: float = 0.0, green: float = 0.0, blue: float = 0.0, opacity: float = 0.0) -> None:
    """Fill everything with a colour, each part of it from 0 to 1, as if infinitely far away."""
    gl("glClearColor", red, green, blue, opacity)
    gl("glClear", GL.DEPTH_BUFFER_BIT | GL.COLOR_BUFFER_BIT)


def use_viewport(width: int, height: int) -> None:
    """Draw on so many pixels."""
    gl("glViewport", 0, 0, width, height)


def copy_colours(source: int, target: int, pixels: tuple[int, int]) -> None:
    """Bring one framebuffer's colours into another of the same size, several samples a pixel into one; go on there."""
    whole = (0, 0, *pixels)
    gl("glBindFramebuffer", GL.READ_FRAMEBUFFER, source)
    gl("glBindFramebuffer", GL.DRAW_FRAMEBUFFER, target)
    gl("glBlitFramebuffer", *whole, *whole, GL.COLOR_BUFFER_BIT, GL.NEAREST)
    gl("glBindFramebuffer", GL.FRAMEBUFFER, target)


def draw_over(*, blended: bool) -> None:
    """Draw the next things over whatever is there, whatever its depth: opaque, or in premultiplied colours."""
    gl("glDisable", GL.DEPTH_TEST)
    if blended:
        gl("glEnable", GL.BLEND)
        gl("glBlendFunc", GL.ONE, GL.ONE_MINUS_SRC_ALPHA)
    else:
        gl("glDisable", GL.BLEND)


def draw_in_depth() -> None:
    """Draw the next things opaque, each where nothing lies nearer."""
    gl("glEnable", GL.DEPTH_TEST)
    gl("glDepthMask", 1)
    gl("glDisable", GL.BLEND)


def show_both_sides() -> None:
    """Draw triangles from whichever side they are seen."""
    gl("glDisable", GL.CULL_FACE)


def draw_points(vertices: range) -> None:
    """Draw vertices as points, of the sizes that the vertex shader says."""
    if not QOpenGLContext.currentContext().isOpenGLES():  # which always does so, and has no such switch
        gl("glEnable", GL.PROGRAM_POINT_SIZE)
    gl("glDrawArrays", GL.POINTS, vertices.start, len(vertices))


def draw_corners(vertices: range) -> None:
    """Draw vertices as triangles, three after three."""
    gl("glDrawArrays", GL.TRIANGLES, vertices.start, len(vertices))


def draw_triangles(count: int) -> None:
    """Draw triangles by the first so many of the bound indices."""
    gl("glDrawElements", GL.TRIANGLES, count, GL.UNSIGNED_INT, None)


def _address(values: npt.NDArray[Any]) -> int:
    """Return where the numbers of an array stand, one after the other."""
    assert values.flags.c_contiguous
    return values.ctypes.data
