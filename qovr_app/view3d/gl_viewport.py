"""A viewport drawn by OpenGL: what lies behind the surface, the surface, what lies over it."""

from __future__ import annotations

from collections.abc import Callable, Generator
from functools import partial
from typing import Any

from PySide6.QtCore import Signal
from PySide6.QtGui import QImage, QOffscreenSurface, QOpenGLContext
from PySide6.QtOpenGLWidgets import QOpenGLWidget
from PySide6.QtWidgets import QWidget

from qovr_app.style.canvas import blank_image, painting
from qovr_app.style.palette import theme_in_force
from qovr_app.style.theme import Rgb
from qovr_app.view3d import failures
from qovr_app.view3d.gl import api
from qovr_app.view3d.gl import figure as gl_figure
from qovr_app.view3d.gl.buffer import smooth_edges
from qovr_app.view3d.gl.calls import DriverError
from qovr_app.view3d.gl.figure import Tile
from qovr_app.view3d.gl.mark_layer import MarkLayer
from qovr_app.view3d.gl.support import gl_support, viewport_format
from qovr_app.view3d.gl.surface_item import SurfaceItem
from qovr_app.view3d.painter import surface as painter_surface
from qovr_app.view3d.painter.backdrop import backdrop
from qovr_app.view3d.painter.overlay import overlay
from qovr_app.view3d.painter.sprites import Sprites
from qovr_app.view3d.scene.camera import Size
from qovr_app.view3d.scene.picture import Picture
from qovr_app.work.gui_calls import InGui
from qovr_core.files.progress import Progress

_BEHIND, _OVER = range(2)
"""Which list of marks lies where."""


class GlViewport(QOpenGLWidget):
    """Shows a picture with OpenGL.

    ``painted`` tells that a frame has reached the window; ``faulted`` that an error of the program kept one from it,
    and ``failed`` that OpenGL does not work here, each with the reason; ``lost`` that the context has gone with all
    that was in it, as after a reset of the graphics card.
    """

    painted = Signal()
    faulted = Signal(str)
    failed = Signal(str)
    lost = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setFormat(viewport_format(gl_support()))
        self._picture: Picture | None = None
        self._surface = SurfaceItem()
        self._marks = MarkLayer(Sprites())
        self._broken = False
        self._faulty: Picture | None = None
        self._gl_things = (self._surface, self._marks)
        self.frameSwapped.connect(self.painted)
        self.destroyed.connect(partial(_release, self._gl_things))

    @property
    def widget(self) -> QWidget:
        """The viewport itself, as a widget."""
        return self

    def set_picture(self, picture: Picture) -> None:
        """Show another picture in the next frame."""
        self._picture = picture
        self.update()

    @property
    def logical_size(self) -> Size:
        """Width and height in logical pixels, at least 1."""
        return max(1.0, float(self.width())), max(1.0, float(self.height()))

    def image(self) -> QImage:
        """Return what is seen, freshly drawn."""
        return self.grabFramebuffer()

    def surface_image(
        self, picture: Picture, size: Size, pixels: tuple[int, int], progress: Progress, in_gui: InGui
    ) -> QImage:
        """Return the surface alone on a transparent image; the picture laid out for ``size`` logical pixels."""
        if self.isValid() and not self._broken:
            try:
                return self._tiled(gl_figure.surface_tiles(picture, size, pixels), pixels, progress, in_gui)
            except DriverError as error:  # the figure is still made, by the painter
                failure = error
                in_gui(lambda: self._fail(failure, "drawing a figure"))
        return painter_surface.surface_image(picture, size, pixels)

    def _tiled(
        self, tiles: Generator[Tile, None, None], pixels: tuple[int, int], progress: Progress, in_gui: InGui
    ) -> QImage:
        """Return the image that tiles make: between two of them the GUI thread does other things."""
        result, count = blank_image(pixels, 1.0), gl_figure.tile_count(pixels)
        try:
            with painting(result) as painter:
                for k in range(count):
                    painter.drawImage(*in_gui(lambda: self._with_context(lambda: next(tiles))))
                    progress((k + 1) / count)
        finally:
            in_gui(lambda: self._with_context(tiles.close))
        return result

    def _with_context(self, call: Callable[[], Any]) -> Any:
        self.makeCurrent()
        try:
            return call()
        finally:
            self.doneCurrent()

    def initializeGL(self) -> None:
        """Begin with a new context, which knows nothing of what an earlier one was given."""
        self._forget()
        self.context().aboutToBeDestroyed.connect(self._release)

    def paintGL(self) -> None:
        if self._broken:
            return
        try:
            if self._picture is None or self._picture is self._faulty:
                self._clear()
            else:
                self._paint_frame(self._picture)
        except DriverError as error:  # whatever a driver does, the view goes on without it
            self._fail(error, "drawing")
        except Exception as error:  # an exception must not escape into Qt's event loop
            self._faulty = self._picture
            self.faulted.emit(failures.report_fault(error))
            self._clear()

    def _clear(self) -> None:
        _fill(theme_in_force().background)

    def _release(self) -> None:
        """Destroy what was made in the context that is about to go."""
        self.makeCurrent()
        for thing in self._gl_things:
            thing.release()
        self.doneCurrent()
        self._forget()

    def _forget(self) -> None:
        for thing in self._gl_things:
            thing.forget()

    def _fail(self, error: Exception, doing: str) -> None:
        self._broken = True
        if self.context() is None or not self.context().isValid():
            self.lost.emit()
        else:
            self.failed.emit(failures.report(error, f"OpenGL failed while {doing}"))

    def _paint_frame(self, picture: Picture) -> None:
        size, ratio = self.logical_size, self.devicePixelRatioF()
        self._surface.load(picture)
        # Before the surface: a driver that draws on the same processor would be disturbed by the work.
        pixels = round(size[0] * ratio), round(size[1] * ratio)
        self._marks.load([backdrop(picture, size), overlay(picture, size)], pixels, ratio)
        # Without a graphics card several samples cost too much for motion: the picture at rest has them.
        with smooth_edges(pixels, wanted=not picture.moving and self.format().samples() < 2):
            _fill(picture.theme.background)
            self._marks.draw(_BEHIND)
            self._surface.paint(picture, picture.camera.matrix(size), ratio)
        self._marks.draw(_OVER)


def _fill(colour: Rgb) -> None:
    """Fill the viewport with a colour."""
    red, green, blue = (channel / 255 for channel in colour)
    api.clear(red, green, blue, 1.0)


def _release(things: tuple[SurfaceItem | MarkLayer, ...]) -> None:
    """Destroy the GL objects of a viewport that is gone, its context with it: they live on in the shared
    one."""
    context = QOpenGLContext.globalShareContext()
    if context is None:
        return
    surface = QOffscreenSurface()
    surface.setFormat(context.format())
    surface.create()
    if context.makeCurrent(surface):
        for thing in things:
            thing.release()
        context.doneCurrent()
    surface.destroy()
