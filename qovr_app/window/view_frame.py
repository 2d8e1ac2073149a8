"""The place of the 3D view in the window: there from the first frame, filled when the libraries have come."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QTimer, Signal
from PySide6.QtGui import QColor, QPainter, QPaintEvent, QPalette, QResizeEvent
from PySide6.QtWidgets import QLabel, QVBoxLayout, QWidget

from qovr_app.style.palette import theme_in_force
from qovr_app.view3d.gl.support import gl_support

if TYPE_CHECKING:
    from qovr_app.view3d.view import View3D

_MARK_MARGIN = 12


class StaleMark(QLabel):
    """Says over the view that the surface in it is not that of the document."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__("Stale: configure the surface to see what was set (F5)", parent)
        self.setObjectName("view.stale")
        self.setContentsMargins(10, 4, 10, 4)
        self.setVisible(False)

    def paintEvent(self, event: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(QColor(*theme_in_force().warn))
        painter.setBrush(QColor(*theme_in_force().warn_cell))
        painter.drawRoundedRect(self.rect().adjusted(0, 0, -1, -1), 4, 4)
        painter.end()
        super().paintEvent(event)


class ViewPlace(QWidget):
    """An empty place that becomes the view after it has been painted once.

    Signals
    -------
    filled : the View3D that has come
    """

    filled = Signal(object)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.view: View3D | None = None
        self.setAutoFillBackground(True)
        self.setBackgroundRole(QPalette.ColorRole.Base)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        self._herald = self._make_herald()
        self.stale_mark = StaleMark(self)

    def set_stale(self, is_stale: bool) -> None:
        """Mark the view as showing a surface that is not the document's."""
        self.stale_mark.setVisible(is_stale)
        self._place_mark()

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._place_mark()

    def _place_mark(self) -> None:
        self.stale_mark.adjustSize()
        self.stale_mark.move((self.width() - self.stale_mark.width()) // 2, _MARK_MARGIN)
        self.stale_mark.raise_()

    def fill(self) -> View3D:
        """Bring the view now; a second call returns the same."""
        if self.view is None:
            from qovr_app.view3d.view import View3D

            self.view = View3D(self)
            self.layout().addWidget(self.view)
            self.stale_mark.raise_()
            self.filled.emit(self.view)
        return self.view

    def paintEvent(self, event: QPaintEvent) -> None:
        super().paintEvent(event)
        if self.view is None:
            QTimer.singleShot(0, self, self.fill)

    def _make_herald(self) -> QWidget | None:
        """Return a widget of one pixel that needs OpenGL.

        A window to which the first such widget comes late is taken down and built again before the user's eyes.
        """
        if not gl_support().usable:
            return None
        from PySide6.QtOpenGLWidgets import QOpenGLWidget

        herald = QOpenGLWidget(self)
        herald.setFixedSize(1, 1)
        return herald
