"""The place of the 3D view in the window: there from the first frame, filled when the libraries have come."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QPoint, Qt, QTimer, Signal
from PySide6.QtGui import QImage, QPaintEvent, QPalette, QResizeEvent
from PySide6.QtWidgets import QVBoxLayout, QWidget

from qovr_app.state import intents, looking_intents
from qovr_app.state.editor_state import EditorState
from qovr_app.state.requests import CameraAsked, CameraStep, FocusAsked, ViewRestartAsked
from qovr_app.store import Store
from qovr_app.view3d.gl.support import gl_support
from qovr_app.window.shown_state import shown_of
from qovr_app.window.stale_mark import StaleMark
from qovr_app.work.gui_calls import GuiCalls
from qovr_core.document import NetIndex
from qovr_core.edits import CoordinatePlace, Zone
from qovr_core.files.progress import Progress
from qovr_core.presets import figure_cases

if TYPE_CHECKING:
    from qovr_app.state.figure_options import FigureOptions
    from qovr_app.view3d.view import View3D

_MARK_MARGIN = 12
_LEAST_RADIUS = 1.0
"""Steps along the net."""


class ViewFrame(QWidget):
    """An empty frame that becomes the view after it has been painted once; a view that comes late is right at once.

    ``menu_asked`` tells a MenuWish and the place of the screen where the menu is wanted.
    """

    menu_asked = Signal(object, QPoint)

    def __init__(self, store: Store, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("view_frame")
        self._store = store
        self._view: View3D | None = None
        self._gui_calls = GuiCalls(self)
        self.setAutoFillBackground(True)
        self.setBackgroundRole(QPalette.ColorRole.Base)
        self._layout = QVBoxLayout(self)
        self._layout.setContentsMargins(0, 0, 0, 0)
        self._herald = self._make_herald()
        self.stale_mark = StaleMark(self)

    @property
    def view(self) -> View3D:
        """The 3D view; asking for it brings it, if it has not come by itself yet."""
        if self._view is None:
            self._view = self._make_view()
        return self._view

    def show_state(self, before: EditorState | None, after: EditorState) -> None:
        """Show a state in the view, and whether its surface is that of the document."""
        self.stale_mark.setVisible(after.is_stale)
        self._place_mark()
        if self._view is not None:
            self._view.display(shown_of(after))
            if before is not None and before.file.opening != after.file.opening:
                look_at_opened(self._view, after.file.preset)

    def look(self, request: CameraAsked) -> None:
        """Look from a named direction, or fit the surface from where the camera is."""
        if request.name:
            self.view.set_camera(request.name)
        else:
            self.view.fit()

    def move_camera(self, step: CameraStep) -> None:
        """Look from where one looked before or after, or at the selected points from near."""
        if step is CameraStep.SELECTION:
            self.view.fit(selection=True)
        else:
            self.view.camera_motion.recall(forward=step is CameraStep.FORWARD)

    def restart(self, _request: ViewRestartAsked) -> None:
        """Begin again with the drawing, and with OpenGL if it can be used by now."""
        self.view.restart()
        if self.view.uses_opengl:
            self._store.dispatch(looking_intents.MessageShown("The view has begun again, with OpenGL"))

    def image(self) -> QImage:
        """Return what is seen, at the device's resolution."""
        return self.view.image()

    def figure_writer(self) -> Callable[[Path, FigureOptions, Progress], None]:
        """Return what writes as a figure what is seen now; for a job in a thread of this process."""
        write = self.view.figure_writer()
        return lambda path, options, progress: write(path, options, progress, self._gui_calls)

    def probe_text(self) -> str:
        """Return what the probe says, for the clipboard; empty where it says nothing."""
        return self.view.probe_text()

    def focus_view(self) -> None:
        """Bring the keyboard to the view."""
        self.view.viewports[0].widget.setFocus(Qt.FocusReason.ShortcutFocusReason)

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._place_mark()

    def _place_mark(self) -> None:
        self.stale_mark.adjustSize()
        self.stale_mark.move((self.width() - self.stale_mark.width()) // 2, _MARK_MARGIN)
        self.stale_mark.raise_()

    def paintEvent(self, event: QPaintEvent) -> None:
        super().paintEvent(event)
        if self._view is None:
            QTimer.singleShot(0, self, lambda: self.view)

    def _make_view(self) -> View3D:
        from qovr_app.view3d.view import View3D

        view = View3D(self)
        self._layout.addWidget(view)
        if self.hasFocus():
            view.viewports[0].widget.setFocus()
        self.stale_mark.raise_()
        view.display(shown_of(self._store.state))
        self._listen(view)
        view.set_camera("paper", animated=False)
        return view

    def _listen(self, view: View3D) -> None:
        dispatch = self._store.dispatch
        view.points_dragged.connect(
            lambda indices, moved, gesture: dispatch(
                intents.PointsMoved(indices, tuple(map(tuple, moved.tolist())), gesture)
            )
        )
        view.drag_finished.connect(lambda gesture: dispatch(intents.GestureEnded(gesture)))
        view.drag_cancelled.connect(lambda gesture: dispatch(intents.GestureCancelled(gesture)))
        view.points_picked.connect(lambda picked, picking: dispatch(selected_of(picked, picking)))
        view.radius_turned.connect(self._turn_radius)
        view.point_opened.connect(self._open_fields)
        view.menu_asked.connect(self.menu_asked)
        view.wanted.connect(dispatch)
        view.faulted.connect(lambda reason: dispatch(looking_intents.MessageShown(reason, is_refusal=True)))
        view.fell_back.connect(lambda reason: dispatch(looking_intents.MessageShown(_without_opengl(reason))))

    def _open_fields(self, index: NetIndex) -> None:
        """Bring the keyboard to the height of a control point."""
        self._store.dispatch(looking_intents.ZonesShown(are_shown=True))
        self._store.dispatch(looking_intents.FieldFocused(CoordinatePlace(*index, axis=2)))
        self._store.flush()
        self._store.dispatch(FocusAsked(Zone.CONTROL_POINTS))

    def _turn_radius(self, notches: float) -> None:
        """Let a soft move reach further, or less far; never less than to the next point."""
        radius = max(_LEAST_RADIUS, self._store.state.tools.soft_radius + notches)
        self._store.dispatch(looking_intents.ToolChosen("soft_radius", radius))
        self._store.dispatch(looking_intents.MessageShown(f"Soft moves reach {radius:g} steps along the net."))

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


def _without_opengl(reason: str) -> str:
    return f"{reason.rstrip('.')}. The surface is drawn by the 2D painter instead; everything else works."


def selected_of(picked: tuple[NetIndex, ...], picking: looking_intents.Picking) -> looking_intents.Selected:
    """Return what selects control points, the one picked last at the end."""
    return looking_intents.Selected(picked[-1] if picked else None, picked[:-1], picking)


def look_at_opened(view: View3D, preset: str) -> None:
    """Look at a document that was just opened: as the paper's figures of that preset do, else all of it."""
    cameras = {case.camera for case in figure_cases().values() if case.preset.name == preset}
    if len(cameras) == 1:
        view.set_camera(cameras.pop(), animated=False)
    else:
        view.fit(animated=False)
