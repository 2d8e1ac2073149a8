"""The one door to PyOpenGL, which has no types: what the view needs of it, for the context that is current."""

from __future__ import annotations

from collections.abc import Sequence
from ctypes import c_void_p
from enum import Enum

import numpy as np
import numpy.typing as npt
from OpenGL import GL, error


class DriverError(RuntimeError):
    """Something that this driver should give and does not; the text says what."""


FAILURES: tuple[type[Exception], ...] = (error.Error, DriverError)
"""What an OpenGL call that fails raises; every other exception is an error of the program."""

_FLOAT_BYTES = 4


class Filtering(Enum):
    """What lies between the pixels of a texture."""

    NEAREST = GL.GL_NEAREST
    LINEAR = GL.GL_LINEAR


def make_texture(filtering: Filtering) -> int:
    """Return the name of a new texture that ends at its edges."""
    texture = int(GL.glGenTextures(1))
    GL.glBindTexture(GL.GL_TEXTURE_2D, texture)
    for name in (GL.GL_TEXTURE_MIN_FILTER, GL.GL_TEXTURE_MAG_FILTER):
        GL.glTexParameteri(GL.GL_TEXTURE_2D, name, filtering.value)
    for name in (GL.GL_TEXTURE_WRAP_S, GL.GL_TEXTURE_WRAP_T):
        GL.glTexParameteri(GL.GL_TEXTURE_2D, name, GL.GL_CLAMP_TO_EDGE)
    return texture


def delete_textures(textures: Sequence[int]) -> None:
    """Destroy textures."""
    GL.glDeleteTextures(list(textures))


def bind_textures(textures: Sequence[int]) -> None:
    """Give the first texture units these textures."""
    for unit, texture in enumerate(textures):
        GL.glActiveTexture(GL.GL_TEXTURE0 + unit)
        GL.glBindTexture(GL.GL_TEXTURE_2D, texture)
    GL.glActiveTexture(GL.GL_TEXTURE0)


def load_image(texture: int, pixels: npt.NDArray[np.uint8], size: tuple[int, int], *, is_resized: bool) -> None:
    """Fill a texture with an image's pixels, four bytes each; faster where the size is the one it has."""
    GL.glBindTexture(GL.GL_TEXTURE_2D, texture)
    GL.glPixelStorei(GL.GL_UNPACK_ALIGNMENT, 4)
    if is_resized:
        GL.glTexImage2D(GL.GL_TEXTURE_2D, 0, GL.GL_RGBA8, *size, 0, GL.GL_RGBA, GL.GL_UNSIGNED_BYTE, pixels)
    else:
        GL.glTexSubImage2D(GL.GL_TEXTURE_2D, 0, 0, 0, *size, GL.GL_RGBA, GL.GL_UNSIGNED_BYTE, pixels)


def load_colours(texture: int, table: npt.NDArray[np.uint8]) -> None:
    """Fill a texture of one row with red, green and blue, (k, 3)."""
    GL.glBindTexture(GL.GL_TEXTURE_2D, texture)
    GL.glPixelStorei(GL.GL_UNPACK_ALIGNMENT, 1)
    GL.glTexImage2D(GL.GL_TEXTURE_2D, 0, GL.GL_RGB8, len(table), 1, 0, GL.GL_RGB, GL.GL_UNSIGNED_BYTE, table)


def load_values(texture: int, values: npt.NDArray[np.float32]) -> None:
    """Fill a texture with numbers, (n, m), of which m are a row."""
    rows, columns = values.shape
    GL.glBindTexture(GL.GL_TEXTURE_2D, texture)
    GL.glPixelStorei(GL.GL_UNPACK_ALIGNMENT, 4)
    GL.glTexImage2D(GL.GL_TEXTURE_2D, 0, GL.GL_R32F, columns, rows, 0, GL.GL_RED, GL.GL_FLOAT, values)


def make_vertex_array() -> int:
    """Return the name of a new vertex array object."""
    return int(GL.glGenVertexArrays(1))


def delete_vertex_array(array: int) -> None:
    """Destroy a vertex array object."""
    GL.glDeleteVertexArrays(1, [array])


def bind_vertex_array(array: int) -> None:
    """Take vertices from an array object, or from none for 0."""
    GL.glBindVertexArray(array)


def make_buffer() -> int:
    """Return the name of a new buffer."""
    return int(GL.glGenBuffers(1))


def delete_buffers(buffers: Sequence[int]) -> None:
    """Destroy buffers."""
    GL.glDeleteBuffers(len(buffers), list(buffers))


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
    GL.glBindBuffer(GL.GL_ARRAY_BUFFER, buffer)
    if is_resized:
        GL.glBufferData(GL.GL_ARRAY_BUFFER, values.nbytes, values, GL.GL_DYNAMIC_DRAW)
        stride, offset = _FLOAT_BYTES * sum(widths), 0
        for at, width in enumerate(widths, start=location):
            GL.glVertexAttribPointer(at, width, GL.GL_FLOAT, False, stride, c_void_p(offset))
            GL.glEnableVertexAttribArray(at)
            offset += _FLOAT_BYTES * width
    else:
        GL.glBufferSubData(GL.GL_ARRAY_BUFFER, 0, values.nbytes, values)
    GL.glBindBuffer(GL.GL_ARRAY_BUFFER, 0)


def rewrite(buffer: int, values: npt.NDArray[np.float32], rows: slice) -> None:
    """Bring some rows of the values that a buffer holds, contiguous, to the driver again."""
    some = values[rows]
    if some.size:
        GL.glBindBuffer(GL.GL_ARRAY_BUFFER, buffer)
        GL.glBufferSubData(GL.GL_ARRAY_BUFFER, rows.start * values.strides[0], some.nbytes, some)
        GL.glBindBuffer(GL.GL_ARRAY_BUFFER, 0)


def load_indices(buffer: int, indices: npt.NDArray[np.uint32]) -> None:
    """Fill a buffer with the indices of triangles; it stays bound, which the bound vertex array remembers."""
    GL.glBindBuffer(GL.GL_ELEMENT_ARRAY_BUFFER, buffer)
    GL.glBufferData(GL.GL_ELEMENT_ARRAY_BUFFER, indices.nbytes, indices, GL.GL_STATIC_DRAW)


def set_floats(location: int, *values: float) -> None:
    """Set a uniform of one to four floats of the program that is bound."""
    (GL.glUniform1f, GL.glUniform2f, GL.glUniform3f, GL.glUniform4f)[len(values) - 1](location, *values)


def set_integer(location: int, value: int) -> None:
    """Set a uniform of one integer, such as a texture unit, of the program that is bound."""
    GL.glUniform1i(location, value)


def clear(red: float = 0.0, green: float = 0.0, blue: float = 0.0, opacity: float = 0.0) -> None:
    """Fill everything with a colour, each part of it from 0 to 1, as if infinitely far away."""
    GL.glClearColor(red, green, blue, opacity)
    GL.glClear(GL.GL_DEPTH_BUFFER_BIT | GL.GL_COLOR_BUFFER_BIT)


def use_viewport(width: int, height: int) -> None:
    """Draw on so many pixels."""
    GL.glViewport(0, 0, width, height)


def copy_colours(source: int, target: int, pixels: tuple[int, int]) -> None:
    """Bring one framebuffer's colours into another of the same size, several samples a pixel into one; go on there."""
    whole = (0, 0, *pixels)
    GL.glBindFramebuffer(GL.GL_READ_FRAMEBUFFER, source)
    GL.glBindFramebuffer(GL.GL_DRAW_FRAMEBUFFER, target)
    GL.glBlitFramebuffer(*whole, *whole, GL.GL_COLOR_BUFFER_BIT, GL.GL_NEAREST)
    GL.glBindFramebuffer(GL.GL_FRAMEBUFFER, target)


def draw_over(*, blended: bool) -> None:
    """Draw the next things over whatever is there, whatever its depth: opaque, or in premultiplied colours."""
    GL.glDisable(GL.GL_DEPTH_TEST)
    if blended:
        GL.glEnable(GL.GL_BLEND)
        GL.glBlendFunc(GL.GL_ONE, GL.GL_ONE_MINUS_SRC_ALPHA)
    else:
        GL.glDisable(GL.GL_BLEND)


def draw_in_depth() -> None:
    """Draw the next things opaque, each where nothing lies nearer."""
    GL.glEnable(GL.GL_DEPTH_TEST)
    GL.glDepthMask(True)
    GL.glDisable(GL.GL_BLEND)


def show_both_sides() -> None:
    """Draw triangles from whichever side they are seen."""
    GL.glDisable(GL.GL_CULL_FACE)


def let_points_have_sizes() -> None:
    """Let the vertex shader say how large a point is; under OpenGL ES it always does, and this is an error."""
    GL.glEnable(GL.GL_PROGRAM_POINT_SIZE)


def draw_points(count: int) -> None:
    """Draw the first vertices as points."""
    GL.glDrawArrays(GL.GL_POINTS, 0, count)


def draw_triangle() -> None:
    """Draw the first three vertices as a triangle."""
    GL.glDrawArrays(GL.GL_TRIANGLES, 0, 3)


def draw_triangles(count: int) -> None:
    """Draw triangles by the first so many of the bound indices."""
    GL.glDrawElements(GL.GL_TRIANGLES, count, GL.GL_UNSIGNED_INT, None)
