"""What every viewport can do, whoever draws it."""

from __future__ import annotations

import math
from typing import Protocol

from PySide6.QtCore import QPoint, QPointF, SignalInstance
from PySide6.QtGui import QImage
from PySide6.QtWidgets import QWidget

from qovr_app.view3d.scene.camera import Size
from qovr_app.view3d.scene.picture import Picture
from qovr_app.work.gui_calls import InGui
from qovr_core import QovrError
from qovr_core.files.progress import Progress


class Viewport(Protocol):
    """A widget that shows a picture; ``painted()`` is emitted when a frame has reached the window, ``faulted(reason)``
    when an error of the program kept one from it."""

    @property
    def painted(self) -> SignalInstance: ...

    @property
    def faulted(self) -> SignalInstance: ...

    @property
    def widget(self) -> QWidget:
        """The viewport itself, as a widget."""

    @property
    def logical_size(self) -> Size:
        """Width and height in logical pixels, at least 1."""

    def set_picture(self, picture: Picture) -> None:
        """Show another picture in the next frame."""

    def image(self) -> QImage:
        """Return what is seen, freshly drawn."""

    def surface_image(
        self, picture: Picture, size: Size, pixels: tuple[int, int], progress: Progress, in_gui: InGui
    ) -> QImage:
        """Return the surface alone on a transparent image; the picture laid out for ``size`` logical pixels.

        Any thread may ask, with ``in_gui`` for what only the GUI thread can do.
        """


def screen_position(viewport: Viewport, picture: Picture | None, i: int, j: int) -> QPoint:
    """Return where control point (i, j) of a picture stands, in global logical pixels.

    Raises
    ------
    IndexError : there is no such point
    QovrError : there is no picture, or the point lies behind the eye
    """
    if picture is None:
        raise QovrError("no point stands in the view: there is no surface; expected a document that has one")
    x, y, _ = picture.camera.project(picture.scene.points[i, j], viewport.logical_size)
    if not math.isfinite(x):
        raise QovrError(f"P {i},{j} lies behind the eye; expected a camera that sees it")
    return viewport.widget.mapToGlobal(QPointF(float(x), float(y))).toPoint()
