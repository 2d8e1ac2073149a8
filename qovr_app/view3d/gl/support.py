"""Decide once whether OpenGL can be used, before anything that needs it is imported.

A widget whose OpenGL fails can blank the whole window, so no such widget is built unless this says yes.
"""

from __future__ import annotations

import os
from dataclasses import dataclass
from functools import cache

from PySide6.QtCore import QCoreApplication, Qt
from PySide6.QtGui import QGuiApplication, QOffscreenSurface, QOpenGLContext, QSurfaceFormat

LEAST_DESKTOP, LEAST_ES = (3, 1), (3, 0)
"""What the shaders are written for: GLSL 1.40 and GLSL ES 3.00."""

_NO_OPENGL_PLATFORMS = ("offscreen", "minimal", "linuxfb", "vnc")
_SOFTWARE_RENDERERS = (
    "llvmpipe",
    "softpipe",
    "swrast",
    "swiftshader",
    "gdi generic",
    "basic render",
    "software",
)
_SAMPLES = 4
_GL_RENDERER = 0x1F01
_DISABLE = "QOVR_NO_OPENGL"
"""Environment variable that switches OpenGL off, for drivers that crash where no program can catch it."""


@dataclass(frozen=True)
class GlSupport:
    """What the probe found; ``reason`` says in words why OpenGL is not usable, and is empty where it is."""

    usable: bool
    renderer: str = ""
    is_hardware: bool = False
    is_es: bool = False
    reason: str = ""


def set_default_format() -> None:
    """Ask for a 3.3 core profile with shared contexts; to be called before the QApplication is made.

    Sharing lets what a viewport has made be destroyed after the viewport, and its context, have gone.
    """
    QCoreApplication.setAttribute(Qt.ApplicationAttribute.AA_ShareOpenGLContexts)
    wanted = QSurfaceFormat(QSurfaceFormat.defaultFormat())
    wanted.setDepthBufferSize(24)
    if wanted.renderableType() != QSurfaceFormat.RenderableType.OpenGLES:
        wanted.setVersion(3, 3)
        wanted.setProfile(QSurfaceFormat.OpenGLContextProfile.CoreProfile)
    QSurfaceFormat.setDefaultFormat(wanted)


@cache
def gl_support() -> GlSupport:
    """Return whether OpenGL is usable; a QApplication exists."""
    if os.environ.get(_DISABLE):
        return _not_usable(f"it is switched off by {_DISABLE}")
    platform = QGuiApplication.platformName()
    if platform in _NO_OPENGL_PLATFORMS:
        return _not_usable(f"the platform '{platform}' has none")
    context, surface = QOpenGLContext(), QOffscreenSurface()
    if not context.create():
        return _not_usable("no context could be created")
    surface.setFormat(context.format())
    surface.create()
    if not surface.isValid() or not context.makeCurrent(surface):
        return _not_usable("no context could be made current")
    try:
        return _described(context)
    finally:
        context.doneCurrent()
        surface.destroy()


def forget_support() -> None:
    """Let ``gl_support`` look again: a driver may have come back."""
    gl_support.cache_clear()


def _not_usable(reason: str) -> GlSupport:
    return GlSupport(usable=False, reason=f"OpenGL is not available: {reason}")


def _described(context: QOpenGLContext) -> GlSupport:
    version, is_es = context.format().version(), context.isOpenGLES()
    needed = LEAST_ES if is_es else LEAST_DESKTOP
    if version < needed:
        kind = "OpenGL ES" if is_es else "OpenGL"
        found, least = (".".join(map(str, v)) for v in (version, needed))
        return _not_usable(f"the driver offers {kind} {found}, {least} is needed")
    renderer = context.functions().glGetString(_GL_RENDERER) or ""
    hardware = not any(name in renderer.lower() for name in _SOFTWARE_RENDERERS)
    return GlSupport(usable=True, renderer=renderer, is_hardware=hardware, is_es=is_es)


def viewport_format(support: GlSupport) -> QSurfaceFormat:
    """Return the surface format of a viewport: smooth edges where a graphics card draws them for nothing."""
    wanted = QSurfaceFormat(QSurfaceFormat.defaultFormat())
    wanted.setSamples(_SAMPLES if support.is_hardware else 0)
    return wanted
