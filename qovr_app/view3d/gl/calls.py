"""OpenGL itself: its functions as Qt finds them for the context that is current, and its constants.

No binding is used: PyOpenGL takes a tenth of a second to import and gives Python's lock up at each of a frame's calls,
which comes back late beside a busy thread; of PySide6's the functions that fill buffers are missing.
"""

from __future__ import annotations

import ctypes
from collections.abc import Sequence
from functools import cache
from typing import Any

from PySide6.QtGui import QOpenGLContext


class GL:
    """Constants of OpenGL, by their names without ``GL_``."""

    NO_ERROR = 0
    POINTS, TRIANGLES = 0x0000, 0x0004
    DEPTH_BUFFER_BIT, COLOR_BUFFER_BIT = 0x0100, 0x4000
    ONE, ONE_MINUS_SRC_ALPHA = 0x0001, 0x0303
    CULL_FACE, DEPTH_TEST, BLEND, PROGRAM_POINT_SIZE = 0x0B44, 0x0B71, 0x0BE2, 0x8642
    UNSIGNED_BYTE, UNSIGNED_INT, FLOAT = 0x1401, 0x1405, 0x1406
    RED, RGB, RGBA, RGB8, RGBA8, R32F = 0x1903, 0x1907, 0x1908, 0x8051, 0x8058, 0x822E
    TEXTURE_2D, TEXTURE0, UNPACK_ALIGNMENT = 0x0DE1, 0x84C0, 0x0CF5
    TEXTURE_MAG_FILTER, TEXTURE_MIN_FILTER, TEXTURE_WRAP_S, TEXTURE_WRAP_T = 0x2800, 0x2801, 0x2802, 0x2803
    NEAREST, LINEAR, CLAMP_TO_EDGE = 0x2600, 0x2601, 0x812F
    ARRAY_BUFFER, ELEMENT_ARRAY_BUFFER, STATIC_DRAW, DYNAMIC_DRAW = 0x8892, 0x8893, 0x88E4, 0x88E8
    READ_FRAMEBUFFER, DRAW_FRAMEBUFFER, FRAMEBUFFER = 0x8CA8, 0x8CA9, 0x8D40


_ERRORS = {
    0x0500: "invalid enum",
    0x0501: "invalid value",
    0x0502: "invalid operation",
    0x0505: "out of memory",
    0x0506: "invalid framebuffer operation",
    0x0507: "context lost",
}

_INTEGER, _FLOAT, _BOOLEAN, _SIZE, _POINTER = (
    ctypes.c_uint,
    ctypes.c_float,
    ctypes.c_ubyte,
    ctypes.c_ssize_t,
    ctypes.c_void_p,
)
"""Enumerations, names and counts are all of 32 bits, in which a negative one is the same as an unsigned one."""

_PARAMETERS: dict[str, tuple[Any, ...]] = {
    "glActiveTexture": (_INTEGER,),
    "glBindBuffer": (_INTEGER,) * 2,
    "glBindFramebuffer": (_INTEGER,) * 2,
    "glBindTexture": (_INTEGER,) * 2,
    "glBindVertexArray": (_INTEGER,),
    "glBlendFunc": (_INTEGER,) * 2,
    "glBlitFramebuffer": (_INTEGER,) * 10,
    "glBufferData": (_INTEGER, _SIZE, _POINTER, _INTEGER),
    "glBufferSubData": (_INTEGER, _SIZE, _SIZE, _POINTER),
    "glClear": (_INTEGER,),
    "glClearColor": (_FLOAT,) * 4,
    "glDeleteBuffers": (_INTEGER, _POINTER),
    "glDeleteTextures": (_INTEGER, _POINTER),
    "glDeleteVertexArrays": (_INTEGER, _POINTER),
    "glDepthMask": (_BOOLEAN,),
    "glDisable": (_INTEGER,),
    "glDrawArrays": (_INTEGER,) * 3,
    "glDrawElements": (_INTEGER,) * 3 + (_POINTER,),
    "glEnable": (_INTEGER,),
    "glEnableVertexAttribArray": (_INTEGER,),
    "glGenBuffers": (_INTEGER, _POINTER),
    "glGenTextures": (_INTEGER, _POINTER),
    "glGenVertexArrays": (_INTEGER, _POINTER),
    "glGetError": (),
    "glPixelStorei": (_INTEGER,) * 2,
    "glTexImage2D": (_INTEGER,) * 8 + (_POINTER,),
    "glTexParameteri": (_INTEGER,) * 3,
    "glTexSubImage2D": (_INTEGER,) * 8 + (_POINTER,),
    "glUniform1f": (_INTEGER, _FLOAT),
    "glUniform2f": (_INTEGER,) + (_FLOAT,) * 2,
    "glUniform3f": (_INTEGER,) + (_FLOAT,) * 3,
    "glUniform4f": (_INTEGER,) + (_FLOAT,) * 4,
    "glUniform1i": (_INTEGER,) * 2,
    "glVertexAttribPointer": (_INTEGER,) * 3 + (_BOOLEAN, _INTEGER, _POINTER),
    "glViewport": (_INTEGER,) * 4,
}
"""The functions in use, with what each is given; only glGetError gives something back, of 32 bits."""


class DriverError(RuntimeError):
    """Something that this driver should give or do and does not; the text says what."""


def gl(name: str, *arguments: int | float | None) -> None:
    """Call a function of OpenGL by its name; arrays are given by their addresses.

    Raises
    ------
    DriverError : the driver has no such function, or reports an error
    """
    _function(name)(*arguments)
    error = _function("glGetError")()
    if error != GL.NO_ERROR:
        raise DriverError(f"{name}: {_ERRORS.get(error, 'error')} ({error})")


def made_names(name: str, count: int = 1) -> list[int]:
    """Return names of new objects, as ``glGenBuffers`` gives them.

    Raises
    ------
    DriverError : the driver gives none
    """
    names = (ctypes.c_uint * count)()
    gl(name, count, ctypes.addressof(names))
    return list(names)


def delete_names(name: str, names: Sequence[int]) -> None:
    """Destroy objects, as ``glDeleteBuffers`` does."""
    array = (ctypes.c_uint * len(names))(*names)
    gl(name, len(names), ctypes.addressof(array))


@cache
def _function(name: str) -> Any:
    """Return a function of the driver; all contexts share their objects, and so they have one driver."""
    context = QOpenGLContext.currentContext()
    address = None if context is None else context.getProcAddress(name.encode())
    if not address:
        raise DriverError(f"the driver has no {name}")
    return ctypes.PYFUNCTYPE(ctypes.c_uint, *_PARAMETERS[name])(address)
