"""The viewports of a view, one for every layer that is shown: made when needed, by OpenGL or, where that fails, not."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import QObject, QTimer, Signal
from PySide6.QtWidgets import QHBoxLayout, QWidget

from qovr_app.view3d.gl.support import gl_support
from qovr_app.view3d.interaction.navigator import Navigator
from qovr_app.view3d.painter.viewport import PainterViewport
from qovr_app.view3d.scene.picture import Picture

_GAP = 1
"""Pixels between two viewports."""


class Panes(QObject):
    """Keeps as many viewports side by side in a widget as are asked for, and reports what happens in any of them.

    Signals
    -------
    navigator_made : the Navigator of a new viewport, whose intents somebody has to take, and the viewport's number
    painted : a frame has reached the window
    fell_back : once, why OpenGL is not used; the panes are those of the painter by then
    """

    navigator_made = Signal(object, int)
    painted = Signal()
    fell_back = Signal(str)

    def __init__(self, parent: QWidget, picture: Callable[[int], Picture]) -> None:
        super().__init__(parent)
        self._widget, self._picture = parent, picture
        self._viewports: dict[int, QWidget] = {}
        self._navigators: list[Navigator] = []
        self.uses_gl = gl_support().usable
        if not self.uses_gl:
            QTimer.singleShot(0, self, lambda: self.fell_back.emit(gl_support().reason))
        self._layout = QHBoxLayout(parent)
        self._layout.setContentsMargins(0, 0, 0, 0)
        self._layout.setSpacing(_GAP)

    def __getitem__(self, number: int) -> QWidget:
        return self._viewports[number]

    def arrange(self, count: int) -> None:
        """Have this many viewports in view."""
        for k in range(count):
            if k not in self._viewports:
                self._viewports[k] = self._make_viewport(k)
                self._layout.addWidget(self._viewports[k], 1)
        for k, viewport in self._viewports.items():
            viewport.setVisible(k < count)
        self._layout.activate()

    def lay_out(self) -> None:
        """Give the viewports their places in the widget now."""
        self._layout.setGeometry(self._widget.rect())

    def _make_viewport(self, number: int) -> QWidget:
        make = self._gl_viewport if self.uses_gl else PainterViewport
        viewport = make(self._picture(number), self._widget)
        viewport.setAccessibleName("Surface")
        viewport.painted.connect(self.painted)
        navigator = Navigator(viewport, lambda: self._picture(number))
        self._navigators.append(navigator)
        self.navigator_made.emit(navigator, number)
        return viewport

    def _gl_viewport(self, picture: Picture, parent: QWidget) -> QWidget:
        from qovr_app.view3d.gl.viewport import GlViewport

        viewport = GlViewport(picture, parent)
        viewport.failed.connect(self._on_gl_failed)
        return viewport

    def _on_gl_failed(self, reason: str) -> None:
        """Go on with the painter, after the frame that failed."""
        if self.uses_gl:
            self.uses_gl = False
            QTimer.singleShot(0, self, lambda: self._fall_back(reason))

    def _fall_back(self, reason: str) -> None:
        for navigator in self._navigators:
            navigator.finish()
        count = sum(not viewport.isHidden() for viewport in self._viewports.values())
        self._navigators = []
        for viewport in self._viewports.values():
            self._layout.removeWidget(viewport)
            viewport.hide()
            viewport.deleteLater()
        self._viewports = {}
        self.arrange(count)
        self.fell_back.emit(reason)
