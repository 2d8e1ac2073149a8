"""A viewport drawn by Qt's painter: the same scene through the same camera where OpenGL cannot be used."""

from __future__ import annotations

from PySide6.QtCore import Qt, QTimer, Signal
from PySide6.QtGui import QColor, QImage, QPaintEvent
from PySide6.QtWidgets import QWidget

from qovr_app.style.canvas import blank_image, painting
from qovr_app.style.palette import theme_in_force
from qovr_app.view3d import failures
from qovr_app.view3d.painter.backdrop import backdrop
from qovr_app.view3d.painter.overlay import overlay
from qovr_app.view3d.painter.paint import paint
from qovr_app.view3d.painter.surface import paint_surface, surface_image
from qovr_app.view3d.scene.camera import Size
from qovr_app.view3d.scene.picture import Picture
from qovr_app.work.gui_calls import InGui
from qovr_core.files.progress import Progress


class PainterViewport(QWidget):
    """Shows a picture with QPainter.

    ``painted`` tells that a frame has been drawn; ``faulted`` that an error of the program kept one from it, with the
    reason.
    """

    painted = Signal()
    faulted = Signal(str)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._picture: Picture | None = None
        self._faulty: Picture | None = None
        self.setAttribute(Qt.WidgetAttribute.WA_OpaquePaintEvent)

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
        size, picture = self.logical_size, self._picture
        image = blank_image(size, self.devicePixelRatioF())
        if picture is None:
            image.fill(QColor(*theme_in_force().background))
            return image
        image.fill(QColor(*picture.theme.background))
        with painting(image) as painter:
            paint(painter, backdrop(picture, size))
            paint_surface(painter, picture, size)
            paint(painter, overlay(picture, size))
        return image

    def surface_image(
        self, picture: Picture, size: Size, pixels: tuple[int, int], _progress: Progress, _in_gui: InGui
    ) -> QImage:
        """Return the surface alone on a transparent image; the picture laid out for ``size`` logical pixels."""
        return surface_image(picture, size, pixels)

    def paintEvent(self, _event: QPaintEvent) -> None:
        # Drawn on an image first: there the overlay's lettering is placed on whole pixels, as with OpenGL.
        with painting(self) as painter:
            try:
                if self._picture is not None and self._picture is self._faulty:
                    painter.fillRect(self.rect(), QColor(*theme_in_force().background))
                else:
                    painter.drawImage(0, 0, self.image())
            except Exception as error:  # an exception must not escape into Qt's event loop
                self._faulty = self._picture
                painter.fillRect(self.rect(), QColor(*theme_in_force().background))
                self.faulted.emit(failures.report_fault(error))
        QTimer.singleShot(0, self, self.painted.emit)
