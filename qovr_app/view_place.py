"""The place of the 3D view in the window: there from the first frame, filled when the libraries have come."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QTimer, Signal
from PySide6.QtGui import QPaintEvent, QPalette
from PySide6.QtWidgets import QVBoxLayout, QWidget

from qovr_app.view3d.probe import gl_support

if TYPE_CHECKING:
    from qovr_app.view3d.view import View3D


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

    def fill(self) -> View3D:
        """Bring the view now; a second call returns the same."""
        if self.view is None:
            from qovr_app.view3d.view import View3D

            self.view = View3D(self)
            self.layout().addWidget(self.view)
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
