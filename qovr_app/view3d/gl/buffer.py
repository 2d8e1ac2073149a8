"""Framebuffers with several samples a pixel, for smooth edges where the window itself has one."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

from PySide6.QtCore import QSize
from PySide6.QtGui import QOpenGLContext
from PySide6.QtOpenGL import QOpenGLFramebufferObject, QOpenGLFramebufferObjectFormat

from qovr_app.view3d.gl import api

_SAMPLES = 4


def sampled_buffer(pixels: tuple[int, int]) -> QOpenGLFramebufferObject:
    """Return a framebuffer with depth for the current context; it may not be valid."""
    form = QOpenGLFramebufferObjectFormat()
    form.setSamples(_SAMPLES)
    form.setAttachment(QOpenGLFramebufferObject.Attachment.Depth)
    return QOpenGLFramebufferObject(QSize(*pixels), form)


@contextmanager
def smooth_edges(pixels: tuple[int, int], *, wanted: bool) -> Iterator[None]:
    """Draw what is inside with several samples a pixel, then into the viewport; directly where that fails."""
    buffer = sampled_buffer(pixels) if wanted else None
    if buffer is None or not buffer.isValid() or not buffer.bind():
        yield
        return
    try:
        yield
    finally:
        buffer.release()
    api.copy_colours(buffer.handle(), QOpenGLContext.currentContext().defaultFramebufferObject(), pixels)
