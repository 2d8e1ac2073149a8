"""Mouse, trackpad and keys of a viewport, as intents: a camera, a hover, a selection, a drag."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import QEvent, QObject, QPointF, Qt, Signal
from PySide6.QtGui import QKeyEvent, QMouseEvent, QNativeGestureEvent, QWheelEvent
from PySide6.QtWidgets import QWidget

from qovr_app.state.gestures import next_gesture
from qovr_app.view3d.interaction.keys import arrow_step, next_point, orbit_step, zoom_step
from qovr_app.view3d.interaction.picking import Grip, pick
from qovr_app.view3d.scene.camera import Camera
from qovr_app.view3d.scene.picture import Picture

_DEGREES_PER_PIXEL = 0.4
_ZOOM_PER_NOTCH = 1.15
_NOTCH = 120.0
_PAN_STEP = 30.0
_DRAG_START = 3.0
"""Pixels the mouse moves before a press becomes a drag: a click selects and must not edit."""

_AXIS_KEYS = {Qt.Key.Key_X: 0, Qt.Key.Key_Y: 1, Qt.Key.Key_Z: 2}


class Navigator(QObject):
    """Watches the events of one viewport. It reports; the view decides.

    ``camera_requested(Camera)``; ``pointed`` with the mouse's x and y, or None when it has left; ``hovered`` and
    ``selected`` with a net index or None; ``dragged(i, j, xyz, gesture)``, then ``drag_finished(gesture)`` or
    ``drag_cancelled(gesture)``.
    """

    camera_requested = Signal(object)
    pointed = Signal(object)
    hovered = Signal(object)
    selected = Signal(object)
    drag_started = Signal(int)
    dragged = Signal(int, int, object, int)
    drag_finished = Signal(int)
    drag_cancelled = Signal(int)

    def __init__(self, viewport: QWidget, picture: Callable[[], Picture]) -> None:
        super().__init__(viewport)
        self._viewport, self._picture = viewport, picture
        self._last = QPointF()
        self._grip: Grip | None = None
        self._gesture = 0
        self._axes_held: list[int] = []
        viewport.setMouseTracking(True)
        viewport.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        viewport.installEventFilter(self)
        self._handlers: dict[QEvent.Type, Callable[..., bool]] = {
            QEvent.Type.MouseButtonPress: self._on_press,
            QEvent.Type.MouseButtonDblClick: self._on_press,
            QEvent.Type.MouseMove: self._on_move,
            QEvent.Type.MouseButtonRelease: self._on_release,
            QEvent.Type.Wheel: self._on_wheel,
            QEvent.Type.NativeGesture: self._on_native_gesture,
            QEvent.Type.KeyPress: self._on_key_press,
            QEvent.Type.KeyRelease: self._on_key_release,
            QEvent.Type.ShortcutOverride: self._on_shortcut_override,
            QEvent.Type.Leave: self._on_leave,
            QEvent.Type.FocusOut: self._on_focus_out,
        }

    @property
    def is_dragging(self) -> bool:
        """Whether a control point is being dragged."""
        return self._gesture != 0

    def finish(self) -> None:
        """End a drag where the point is now, because the viewport goes."""
        self._let_go(self.drag_finished)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:  # noqa: ARG002
        handler = self._handlers.get(event.type())
        return handler is not None and handler(event)

    def _camera(self) -> Camera:
        return self._picture().camera

    def _pick(self, at: QPointF) -> tuple[int, int] | None:
        picture = self._picture()
        if picture.scene is None or not picture.settings.control_points:
            return None
        return pick(picture.scene, picture.camera, self._viewport.logical_size, at.x(), at.y())

    def _on_press(self, event: QMouseEvent) -> bool:
        self._last = event.position()
        self._viewport.setFocus(Qt.FocusReason.MouseFocusReason)
        if event.button() == Qt.MouseButton.LeftButton and not event.modifiers():
            index = self._pick(event.position())
            if index is not None:
                picture = self._picture()
                size, at = self._viewport.logical_size, event.position()
                self._grip = Grip(picture.scene, picture.camera, size, index, at.x(), at.y())
            self.selected.emit(index)
        return True

    def _on_move(self, event: QMouseEvent) -> bool:
        at, moved = event.position(), event.position() - self._last
        buttons = event.buttons()
        self.pointed.emit((at.x(), at.y()))
        if not buttons:
            self._hover(at)
        elif self._grip is not None:
            self._drag_to(at)
        elif buttons & (Qt.MouseButton.RightButton | Qt.MouseButton.MiddleButton) or (
            event.modifiers() & Qt.KeyboardModifier.ShiftModifier
        ):
            size = self._viewport.logical_size
            self.camera_requested.emit(self._camera().panned(moved.x(), moved.y(), size))
        elif buttons & Qt.MouseButton.LeftButton:
            turn = -_DEGREES_PER_PIXEL * moved.x(), _DEGREES_PER_PIXEL * moved.y()
            self.camera_requested.emit(self._camera().orbited(*turn))
        self._last = at
        return True

    def _hover(self, at: QPointF) -> None:
        index = self._pick(at)
        shape = Qt.CursorShape.ArrowCursor if index is None else Qt.CursorShape.PointingHandCursor
        self._viewport.setCursor(shape)
        self.hovered.emit(index)

    def _drag_to(self, at: QPointF) -> None:
        grip = self._grip
        if not self.is_dragging:
            if (at - QPointF(grip.x, grip.y)).manhattanLength() < _DRAG_START:
                return
            self._gesture = next_gesture()
            self.drag_started.emit(self._gesture)
        axis = self._axes_held[-1] if self._axes_held else None
        target = grip.target(at.x(), at.y(), axis)
        if target is None:
            self._viewport.setCursor(Qt.CursorShape.ForbiddenCursor)
            return
        self._viewport.setCursor(Qt.CursorShape.ClosedHandCursor)
        self.dragged.emit(*grip.index, target, self._gesture)

    def _on_release(self, event: QMouseEvent) -> bool:
        if event.button() == Qt.MouseButton.LeftButton:
            self._let_go(self.drag_finished)
            self._hover(event.position())
        return True

    def _let_go(self, report: Signal) -> None:
        """End a drag, if there is one, with this report."""
        gesture, self._gesture, self._grip = self._gesture, 0, None
        if gesture:
            report.emit(gesture)

    def _on_wheel(self, event: QWheelEvent) -> bool:
        camera, size = self._camera(), self._viewport.logical_size
        at = event.position().x(), event.position().y()
        touched = event.phase() != Qt.ScrollPhase.NoScrollPhase and not event.pixelDelta().isNull()
        zooms = not touched or bool(event.modifiers() & Qt.KeyboardModifier.ControlModifier)
        if self.is_dragging:
            return True
        if zooms:
            # Some systems turn the wheel sideways while Alt or Shift is held.
            turned = event.angleDelta().y() or event.angleDelta().x()
            self.camera_requested.emit(camera.zoomed(_ZOOM_PER_NOTCH ** (turned / _NOTCH), at, size))
        elif event.modifiers() & Qt.KeyboardModifier.ShiftModifier:
            self.camera_requested.emit(camera.panned(event.pixelDelta().x(), event.pixelDelta().y(), size))
        else:
            dx, dy = event.pixelDelta().x(), event.pixelDelta().y()
            self.camera_requested.emit(camera.orbited(-_DEGREES_PER_PIXEL * dx, _DEGREES_PER_PIXEL * dy))
        return True

    def _on_native_gesture(self, event: QNativeGestureEvent) -> bool:
        camera, size = self._camera(), self._viewport.logical_size
        if event.gestureType() == Qt.NativeGestureType.ZoomNativeGesture:
            at = event.position().x(), event.position().y()
            self.camera_requested.emit(camera.zoomed(1 + event.value(), at, size))
        elif event.gestureType() == Qt.NativeGestureType.RotateNativeGesture:
            self.camera_requested.emit(camera.orbited(event.value(), 0.0))
        else:
            return False
        return True

    def _on_key_press(self, event: QKeyEvent) -> bool:
        key = event.key()
        if key in _AXIS_KEYS and self._grip is not None:
            if not event.isAutoRepeat():
                self._axes_held.append(_AXIS_KEYS[key])
                self._follow_keys()
            return True
        if key == Qt.Key.Key_Escape:
            return self._escape()
        if key in (Qt.Key.Key_Tab, Qt.Key.Key_Backtab):
            return self._step_selection(next_point(self._picture().selected, forward=key == Qt.Key.Key_Tab))
        if self._picture().selected is not None and not event.modifiers():
            step = arrow_step(self._picture().selected, key, self._camera())
            if step is not None:
                return self._step_selection(step)
        return self._navigate(event)

    def _on_key_release(self, event: QKeyEvent) -> bool:
        axis = _AXIS_KEYS.get(event.key())
        if axis is None or axis not in self._axes_held:
            return False
        if not event.isAutoRepeat():
            self._axes_held.remove(axis)
            self._follow_keys()
        return True

    def _on_shortcut_override(self, event: QKeyEvent) -> bool:
        """Claim the axis keys and Escape during a drag, whatever shortcuts the window has."""
        if self._grip is not None and (event.key() in _AXIS_KEYS or event.key() == Qt.Key.Key_Escape):
            event.accept()
            return True
        return False

    def _follow_keys(self) -> None:
        """Move a dragged point to where it belongs under the axis keys that are held now."""
        if self.is_dragging:
            self._drag_to(self._last)

    def _escape(self) -> bool:
        if self._grip is not None:
            self._let_go(self.drag_cancelled)
        elif self._picture().selected is not None:
            self.selected.emit(None)
        else:
            return False
        return True

    def _step_selection(self, index: tuple[int, int] | None) -> bool:
        if index is None or self._grip is not None or not self._picture().settings.control_points:
            return False
        self.selected.emit(index)
        return True

    def _navigate(self, event: QKeyEvent) -> bool:
        camera, size = self._camera(), self._viewport.logical_size
        turn, zoom = orbit_step(event.key()), zoom_step(event.key())
        if self.is_dragging or (turn is None and zoom is None):
            return False
        if zoom is not None:
            self.camera_requested.emit(camera.zoomed(zoom, (size[0] / 2, size[1] / 2), size))
        elif event.modifiers() & Qt.KeyboardModifier.ShiftModifier:
            self.camera_requested.emit(camera.panned(_PAN_STEP * turn[0], -_PAN_STEP * turn[1], size))
        else:
            self.camera_requested.emit(camera.orbited(5.0 * turn[0], 5.0 * turn[1]))
        return True

    def _on_leave(self, event: QEvent) -> bool:  # noqa: ARG002
        self.hovered.emit(None)
        self.pointed.emit(None)
        return False

    def _on_focus_out(self, event: QEvent) -> bool:  # noqa: ARG002
        self._axes_held.clear()
        return False
