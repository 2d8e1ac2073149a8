"""Shader programs: read from the resources, given the right version line, and checked."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache

from PySide6.QtGui import QOpenGLContext
from PySide6.QtOpenGL import QOpenGLShader, QOpenGLShaderProgram

from qovr_app.view3d.gl.calls import DriverError
from qovr_core.resources import resource

_DESKTOP_HEAD = "#version 140\n"
_ES_HEAD = "#version 300 es\nprecision highp float;\nprecision highp int;\n"


class ShaderError(DriverError):
    """A shader that this driver does not compile or link; the text is the driver's."""


@cache
def shader_source(name: str) -> str:
    """Return the text of a shader by its file's name."""
    return resource("shaders", name).read_text(encoding="utf-8")


def link_program(name: str, *, defines: Sequence[str] = (), attributes: Sequence[str] = ()) -> QOpenGLShaderProgram:
    """Return the program of ``NAME.vert`` and ``NAME.frag`` for the current context.

    Parameters
    ----------
    defines : macros set in both shaders
    attributes : vertex attributes in the order of their locations

    Raises
    ------
    ShaderError : the driver refuses it
    """
    head = _ES_HEAD if QOpenGLContext.currentContext().isOpenGLES() else _DESKTOP_HEAD
    head += "".join(f"#define {key}\n" for key in defines)
    program = QOpenGLShaderProgram()
    for kind, suffix in (
        (QOpenGLShader.ShaderTypeBit.Vertex, "vert"),
        (QOpenGLShader.ShaderTypeBit.Fragment, "frag"),
    ):
        if not program.addShaderFromSourceCode(kind, head + shader_source(f"{name}.{suffix}")):
            raise ShaderError(f"{name}.{suffix}: {program.log().strip()}")
    for location, attribute in enumerate(attributes):
        program.bindAttributeLocation(attribute, location)
    if not program.link():
        raise ShaderError(f"{name}: {program.log().strip()}")
    return program
