"""Mouse, trackpad and keys of a viewport, as intents: a camera, a hover, a selection, a drag."""

from __future__ import annotations

from collections.abc import Callable
from typing import Protocol

from PySide6.QtCore import QEvent, QObject, QPointF, Qt, Signal
from PySide6.QtGui import QKeyEvent, QMouseEvent, QNativeGestureEvent, QWheelEvent
from PySide6.QtWidgets import QWidget

from qovr_app.state.looking_intents import MessageShown, Picking, ToolChosen
from qovr_app.view3d.interaction.camera_input import moved_by_gesture, moved_by_key, moved_by_wheel
from qovr_app.view3d.interaction.dragging import PointDragger
from qovr_app.view3d.interaction.keys import arrow_step, axis_of
from qovr_app.view3d.interaction.knot_dragging import KnotDragger
from qovr_app.view3d.interaction.mouse import Mouse
from qovr_app.view3d.interaction.picking import gizmo_under, handle_under, points_under
from qovr_app.view3d.scene.camera import Camera, Size
from qovr_app.view3d.scene.grip import Freedom
from qovr_app.view3d.scene.hand import Hand, KnotMarks
from qovr_app.view3d.scene.picture import Picture
from qovr_app.view3d.scene.triad import view_under
from qovr_core.geometry.knots import KnotPlace

KEPT_POINTS = "A control net keeps all its points. Move one, or make the net flat or symmetric by the Edit menu."
"""What is said instead of deleting."""

_LOST = (QEvent.Type.FocusOut, QEvent.Type.WindowDeactivate, QEvent.Type.Hide, QEvent.Type.UngrabMouse)
"""After these nobody tells where the mouse is, or that its button was released."""

_ENTER = (Qt.Key.Key_Return, Qt.Key.Key_Enter)


class Watched(Protocol):
    """What an interactor needs of a viewport."""

    @property
    def widget(self) -> QWidget: ...
    @property
    def logical_size(self) -> Size: ...


class Interactor(QObject):
    """Watches the events of one viewport. It reports; the view decides.

    ``camera_requested(Camera)``; ``pointed`` with the mouse's x and y, or None when it has left; ``hovered`` with a net
    index or None; ``wanted`` with an intent; ``radius_turned`` with the notches that the wheel went while
    points were dragged softly; ``changed()`` when something else is to be drawn. What is picked reports the ``mouse``,
    what is dragged the ``dragger``.

    Parameters
    ----------
    picture : gives what the viewport shows now; None before there is anything
    """

    camera_requested = Signal(object)
    pointed = Signal(object)
    hovered = Signal(object)
    wanted = Signal(object)
    radius_turned = Signal(float)
    changed = Signal()

    def __init__(self, viewport: Watched, picture: Callable[[], Picture | None]) -> None:
        super().__init__(viewport.widget)
        self._viewport, self.widget, self._picture = viewport, viewport.widget, picture
        self.dragger = PointDragger(self.widget)
        self.knot_dragger = KnotDragger(self.widget)
        self.mouse = Mouse(self.dragger, self.knot_dragger)
        self._freedom: Freedom | None = None
        self._knot: KnotPlace | None = None
        self._view = ""
        self._letter_is_down = False
        self.mouse.camera_requested.connect(self.camera_requested)
        for part in (self.mouse, self.dragger, self.knot_dragger):
            part.changed.connect(self.changed)
        for source in (self.mouse, self.knot_dragger):
            source.wanted.connect(self.wanted)
        self.widget.setMouseTracking(True)
        self.widget.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.widget.installEventFilter(self)

    @property
    def hand(self) -> Hand:
        """What is seen of the mouse in this viewport."""
        marks, hovered = self.dragger.marks, None if self._knot is None else KnotMarks(self._knot)
        freedom = self._freedom if marks is None else marks.freedom
        return Hand(freedom, marks, self.mouse.band, self.knot_dragger.marks or hovered, self._view)

    def eventFilter(self, _watched: QObject, event: QEvent) -> bool:
        picture = self._picture()
        if picture is None:
            return False
        if isinstance(event, QMouseEvent):
            return self._on_mouse(event, picture)
        if isinstance(event, QKeyEvent):
            return self._on_key(event, picture)
        if isinstance(event, QWheelEvent):
            return self._on_wheel(event, picture)
        if isinstance(event, QNativeGestureEvent):
            size = self._viewport.logical_size
            return self.mouse.is_held or self._request(moved_by_gesture(event, picture.camera, size))
        if event.type() == QEvent.Type.Leave:
            self._view = ""
            self.hovered.emit(None)
            self.pointed.emit(None)
        elif event.type() in _LOST and self.mouse.is_held:
            self.mouse.put_back()
        return False

    def _request(self, camera: Camera | None) -> bool:
        """Ask for another camera, if there is one; return whether that is so."""
        if camera is not None:
            self.camera_requested.emit(camera)
        return camera is not None

    # The mouse

    def _on_mouse(self, event: QMouseEvent, picture: Picture) -> bool:
        size = self._viewport.logical_size
        if event.type() == QEvent.Type.MouseButtonPress:
            self.widget.setFocus(Qt.FocusReason.MouseFocusReason)
            self.mouse.press(event, picture, size)
        elif event.type() == QEvent.Type.MouseButtonDblClick:
            self.mouse.double_click(event, picture, size)
        elif event.type() == QEvent.Type.MouseMove:
            self.pointed.emit((event.position().x(), event.position().y()))
            self.mouse.move(event, self._without_letter(event.modifiers()), picture, size)
            if not event.buttons():
                self._hover(event.position())
        elif event.type() == QEvent.Type.MouseButtonRelease:
            self.mouse.release(event, picture, size)
            if not event.buttons():
                self._hover(event.position())
        else:
            return False
        return True

    def _on_wheel(self, event: QWheelEvent, picture: Picture) -> bool:
        if self.dragger.is_dragging and picture.tools.soft and event.angleDelta().y():
            self.radius_turned.emit(event.angleDelta().y() / 120)
            self.mouse.follow_modifiers(self._without_letter(event.modifiers()))  # what follows softly follows at once
        if self.mouse.is_held:
            return True
        return self._request(moved_by_wheel(event, picture.camera, self._viewport.logical_size))

    def _hover(self, at: QPointF) -> None:
        picture, size = self._picture(), self._viewport.logical_size  # a drag that has just ended leaves another one
        if picture is None:
            return
        x, y = at.x(), at.y()
        view = view_under(picture.settings, picture.camera, size, x, y)
        freedom = None if view else gizmo_under(picture, size, x, y)
        handle = None if view or freedom else handle_under(picture, size, x, y)
        is_free = not view and freedom is None and handle is None
        points = points_under(picture, size, x, y) if is_free else []
        is_free = is_free and not points
        self.widget.setCursor(Qt.CursorShape.ArrowCursor if is_free else Qt.CursorShape.PointingHandCursor)
        knot = None if handle is None else handle.knot.place
        if (freedom, knot, view) != (self._freedom, self._knot, self._view):
            self._freedom, self._knot, self._view = freedom, knot, view
            self.widget.setToolTip(f"Look from: {view}" if view else "")
            self.changed.emit()
        self.hovered.emit(points[0] if points else None)

    # Keys

    def _on_key(self, event: QKeyEvent, picture: Picture) -> bool:
        if event.type() == QEvent.Type.ShortcutOverride:
            if self.mouse.dragger.is_pressed:  # whatever shortcuts the window has, a drag is not disturbed
                event.accept()
            return self.mouse.dragger.is_pressed
        if self.mouse.dragger.is_pressed:
            self._on_key_in_drag(event)
            return True
        return event.type() == QEvent.Type.KeyPress and self._on_key_press(event, picture)

    def _on_key_in_drag(self, event: QKeyEvent) -> None:
        key, axis, is_press = event.key(), axis_of(event), event.type() == QEvent.Type.KeyPress
        if axis is not None:
            if not event.isAutoRepeat():
                self._letter_is_down = is_press
                if is_press:
                    self.mouse.dragger.lock(axis, plane=_has_shift(event.modifiers()))
                self.mouse.follow_modifiers(self._without_letter(event.modifiers()))
        elif key in (Qt.Key.Key_Shift, Qt.Key.Key_Control):
            changed = (
                Qt.KeyboardModifier.ShiftModifier if key == Qt.Key.Key_Shift else Qt.KeyboardModifier.ControlModifier
            )
            held = event.modifiers() | changed if is_press else event.modifiers() & ~changed
            self.mouse.follow_modifiers(self._without_letter(held))
        elif is_press and key == Qt.Key.Key_Escape:
            self.mouse.put_back()
        elif is_press and key in _ENTER:
            self.mouse.commit()
        elif is_press:
            self.mouse.dragger.type(event)

    def _without_letter(self, modifiers: Qt.KeyboardModifier) -> Qt.KeyboardModifier:
        """Return the modifiers without Shift while it belongs to the letter of an axis."""
        return modifiers & ~Qt.KeyboardModifier.ShiftModifier if self._letter_is_down else modifiers

    def _on_key_press(self, event: QKeyEvent, picture: Picture) -> bool:
        key, selected, shape = event.key(), picture.last_selected, picture.scene.net_shape
        if key == Qt.Key.Key_Escape:
            if self.mouse.is_held:
                self.mouse.put_back()
            elif picture.tools.measures:
                self.wanted.emit(ToolChosen("measures", value=False))
            elif picture.selected or picture.curve is not None:
                self.mouse.picked.emit((), Picking.REPLACE)
            else:
                return False
            return True
        if key == Qt.Key.Key_Delete:
            self.wanted.emit(MessageShown(KEPT_POINTS))
            return True
        if self.mouse.is_held:
            return False
        if not event.modifiers() & ~Qt.KeyboardModifier.KeypadModifier and picture.settings.control_points:
            step = arrow_step(selected, shape, key, picture.camera)
            if step is not None:
                self.mouse.picked.emit((step,), Picking.REPLACE)
                return True
        return self._request(moved_by_key(event, picture.camera, self._viewport.logical_size))


def _has_shift(modifiers: Qt.KeyboardModifier) -> bool:
    return bool(modifiers & Qt.KeyboardModifier.ShiftModifier)
