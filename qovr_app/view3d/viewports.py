"""The viewports of a view, one for every scene that is shown: made when needed, by OpenGL or, where that fails, not."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from PySide6.QtCore import QObject, QTimer, Signal
from PySide6.QtWidgets import QBoxLayout, QWidget

from qovr_app.view3d.gl.support import forget_support, gl_support
from qovr_app.view3d.interaction.interactor import Interactor
from qovr_app.view3d.painter_viewport import PainterViewport
from qovr_app.view3d.scene.hand import Hand
from qovr_app.view3d.scene.picture import Picture, is_stacked
from qovr_app.view3d.viewport import Viewport

_GAP = 1
"""Pixels between two viewports."""


class Viewports(QObject):
    """Keeps as many viewports in a widget as are asked for, in a row or a stack, and reports what happens in any.

    Parameters
    ----------
    picture : gives what a viewport, counted from the left, shows; None before there is anything

    Signals
    -------
    interactor_made : the Interactor of a new viewport, whose intents somebody has to take, and the viewport's number
    painted : a frame has reached the window
    faulted : an error of the program kept a frame from being drawn, with the reason; the next picture tries again
    fell_back : once, why OpenGL is not used; the viewports are those of the painter by then
    """

    interactor_made = Signal(object, int)
    painted = Signal()
    faulted = Signal(str)
    fell_back = Signal(str)

    def __init__(self, parent: QWidget, picture: Callable[[int], Picture | None]) -> None:
        super().__init__(parent)
        self._parent, self._picture = parent, picture
        self._made: list[Viewport] = []
        self._interactors: list[Interactor] = []
        self._count = 0
        self._uses_gl = False
        self._ask_for_opengl()
        self._layout = QBoxLayout(QBoxLayout.Direction.LeftToRight, parent)
        self._layout.setContentsMargins(0, 0, 0, 0)
        self._layout.setSpacing(_GAP)

    @property
    def uses_opengl(self) -> bool:
        """Whether OpenGL draws, not the painter."""
        return self._uses_gl

    @property
    def in_use(self) -> Sequence[Viewport]:
        """Those that are asked for, from left to right, or from above down."""
        return self._made[: self._count]

    def hand(self, number: int) -> Hand | None:
        """Return what is seen of the mouse in a viewport; None where there is no such viewport yet."""
        return self._interactors[number].hand if number < len(self._interactors) else None

    def arrange(self, count: int) -> None:
        """Have this many viewports in view."""
        self._count = count
        while len(self._made) < count:
            viewport = self._make()
            self._made.append(viewport)
            self._layout.addWidget(viewport.widget, 1)
        for k, viewport in enumerate(self._made):
            viewport.widget.setVisible(k < count)
        self._layout.activate()

    def restart(self) -> None:
        """Begin again with new viewports, and with OpenGL if it can be used by now."""
        forget_support()
        self._ask_for_opengl()
        self._make_anew()

    def lay_out(self) -> None:
        """Give the viewports their places in the widget now."""
        rect, directions = self._parent.rect(), QBoxLayout.Direction
        stacked = is_stacked((rect.width(), rect.height()), self._count)
        self._layout.setDirection(directions.TopToBottom if stacked else directions.LeftToRight)
        self._layout.setGeometry(rect)

    def drop_drags(self) -> None:
        """Let go of what is pressed or dragged, without a word: whoever the drag was for has ended it."""
        for interactor in self._interactors:
            interactor.mouse.drop()

    def show(self) -> None:
        """Bring the pictures of the moment into the viewports."""
        for k, viewport in enumerate(self.in_use):
            picture = self._picture(k)
            if picture is not None:
                viewport.set_picture(picture)

    def _make(self) -> Viewport:
        number = len(self._made)
        viewport = self._make_gl() if self._uses_gl else PainterViewport(self._parent)
        viewport.widget.setAccessibleName("Surface")
        viewport.painted.connect(self.painted)
        viewport.faulted.connect(self.faulted)
        interactor = Interactor(viewport, lambda: self._picture(number))
        self._interactors.append(interactor)
        self.interactor_made.emit(interactor, number)
        return viewport

    def _make_gl(self) -> Viewport:
        from qovr_app.view3d.gl_viewport import GlViewport

        viewport = GlViewport(self._parent)
        viewport.failed.connect(self._on_gl_failed)
        viewport.lost.connect(lambda: QTimer.singleShot(0, self, self.restart))
        return viewport

    def _on_gl_failed(self, reason: str) -> None:
        """Go on with the painter, after the frame that failed."""
        if self._uses_gl:
            self._uses_gl = False
            QTimer.singleShot(0, self, lambda: self._fall_back(reason))

    def _fall_back(self, reason: str) -> None:
        self._make_anew()
        self.fell_back.emit(reason)

    def _make_anew(self) -> None:
        """Put new viewports into the places of those there are."""
        for interactor in self._interactors:
            interactor.mouse.dragger.finish()
        self._interactors = []
        for viewport in self._made:
            self._layout.removeWidget(viewport.widget)
            viewport.widget.hide()
            viewport.widget.deleteLater()
        self._made = []
        self.arrange(self._count)
        self.show()

    def _ask_for_opengl(self) -> None:
        """Use OpenGL from now on, or say why not."""
        self._uses_gl = gl_support().usable
        if not self._uses_gl:
            QTimer.singleShot(0, self, lambda: self.fell_back.emit(gl_support().reason))
