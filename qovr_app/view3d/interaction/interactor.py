"""Mouse, trackpad and keys of a viewport, as intents: a camera, a hover, a selection, a drag."""

from __future__ import annotations

from collections.abc import Callable
from typing import Protocol

from PySide6.QtCore import QEvent, QObject, QPointF, Qt, Signal
from PySide6.QtGui import QKeyEvent, QMouseEvent, QNativeGestureEvent, QWheelEvent
from PySide6.QtWidgets import QWidget

from qovr_app.view3d.interaction.camera_input import moved_by_gesture, moved_by_key, moved_by_mouse, moved_by_wheel
from qovr_app.view3d.interaction.dragging import PointDragger, PressedPoint
from qovr_app.view3d.interaction.keys import arrow_step, axis_of, next_point
from qovr_app.view3d.interaction.picking import pick
from qovr_app.view3d.scene.camera import Camera, Size
from qovr_app.view3d.scene.picture import Picture
from qovr_core.document import NetIndex


class Watched(Protocol):
    """What an interactor needs of a viewport."""

    @property
    def widget(self) -> QWidget: ...
    @property
    def logical_size(self) -> Size: ...


class Interactor(QObject):
    """Watches the events of one viewport. It reports; the view decides.

    ``camera_requested(Camera)``; ``pointed`` with the mouse's x and y, or None when it has left; ``hovered`` and
    ``selected`` with a net index or None. What is dragged reports the ``dragger``.

    Parameters
    ----------
    picture : gives what the viewport shows now; None before there is anything
    """

    camera_requested = Signal(object)
    pointed = Signal(object)
    hovered = Signal(object)
    selected = Signal(object)

    def __init__(self, viewport: Watched, picture: Callable[[], Picture | None]) -> None:
        super().__init__(viewport.widget)
        self._viewport, self._widget, self._picture = viewport, viewport.widget, picture
        self.dragger = PointDragger(self._widget)
        self._last = QPointF()
        self._widget.setMouseTracking(True)
        self._widget.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self._widget.installEventFilter(self)

    def eventFilter(self, _watched: QObject, event: QEvent) -> bool:
        picture = self._picture()
        if picture is None:
            return False
        if isinstance(event, QMouseEvent):
            return self._on_mouse(event, picture)
        if isinstance(event, QKeyEvent):
            return self._on_key(event, picture)
        if isinstance(event, QWheelEvent):
            return self.dragger.is_dragging or self._request(
                moved_by_wheel(event, picture.camera, self._viewport.logical_size)
            )
        if isinstance(event, QNativeGestureEvent):
            return self._request(moved_by_gesture(event, picture.camera, self._viewport.logical_size))
        if event.type() == QEvent.Type.Leave:
            self.hovered.emit(None)
            self.pointed.emit(None)
        elif event.type() == QEvent.Type.FocusOut:
            self.dragger.let_axes_go()
        return False

    def _request(self, camera: Camera | None) -> bool:
        """Ask for another camera, if there is one; return whether that is so."""
        if camera is not None:
            self.camera_requested.emit(camera)
        return camera is not None

    def _pick(self, at: QPointF, picture: Picture) -> NetIndex | None:
        if not picture.settings.control_points:
            return None
        return pick(picture.scene, picture.camera, self._viewport.logical_size, at.x(), at.y())

    # The mouse

    def _on_mouse(self, event: QMouseEvent, picture: Picture) -> bool:
        kind = event.type()
        if kind in (QEvent.Type.MouseButtonPress, QEvent.Type.MouseButtonDblClick):
            self._on_press(event, picture)
        elif kind == QEvent.Type.MouseMove:
            self._on_move(event, picture)
        elif kind == QEvent.Type.MouseButtonRelease:
            self._on_release(event)
        else:
            return False
        return True

    def _on_press(self, event: QMouseEvent, picture: Picture) -> None:
        at = self._last = event.position()
        self._widget.setFocus(Qt.FocusReason.MouseFocusReason)
        if event.button() == Qt.MouseButton.LeftButton and not event.modifiers():
            index = self._pick(at, picture)
            if index is not None:
                size = self._viewport.logical_size
                self.dragger.press(PressedPoint(picture.scene, picture.camera, size, index, at.x(), at.y()))
            self._select(index, picture)

    def _on_release(self, event: QMouseEvent) -> None:
        if event.button() == Qt.MouseButton.LeftButton:
            self.dragger.finish()
            self._hover(event.position())

    def _on_move(self, event: QMouseEvent, picture: Picture) -> None:
        at, moved = event.position(), event.position() - self._last
        self._last = at
        self.pointed.emit((at.x(), at.y()))
        if not event.buttons():
            self._hover(at)
        elif self.dragger.is_pressed:
            self.dragger.move_to(at)
        else:
            self._request(moved_by_mouse(event, moved, picture.camera, self._viewport.logical_size))

    def _hover(self, at: QPointF) -> None:
        picture = self._picture()  # a drag that has just ended leaves another one
        index = self._pick(at, picture) if picture is not None else None
        self._widget.setCursor(Qt.CursorShape.ArrowCursor if index is None else Qt.CursorShape.PointingHandCursor)
        self.hovered.emit(index)

    # Keys

    def _on_key(self, event: QKeyEvent, picture: Picture) -> bool:
        if event.type() == QEvent.Type.ShortcutOverride:
            return self._claim(event)
        if event.type() == QEvent.Type.KeyPress:
            return self._on_key_press(event, picture)
        axis = axis_of(event)
        if axis is None or not self.dragger.holds_axis(axis):
            return False
        if not event.isAutoRepeat():
            self.dragger.let_axis_go(axis)
        return True

    def _claim(self, event: QKeyEvent) -> bool:
        """Claim the axis keys and Escape during a drag, whatever shortcuts the window has."""
        is_claimed = self.dragger.is_pressed and (axis_of(event) is not None or event.key() == Qt.Key.Key_Escape)
        if is_claimed:
            event.accept()
        return is_claimed

    def _on_key_press(self, event: QKeyEvent, picture: Picture) -> bool:
        key, selected, shape = event.key(), picture.last_selected, picture.scene.net_shape
        axis = axis_of(event)
        if axis is not None and self.dragger.is_pressed:
            if not event.isAutoRepeat():
                self.dragger.hold_axis(axis)
            return True
        if key == Qt.Key.Key_Escape:
            return self._escape(picture)
        if key in (Qt.Key.Key_Tab, Qt.Key.Key_Backtab):
            return self._step_to(next_point(selected, shape, forward=key == Qt.Key.Key_Tab), picture)
        if selected is not None and not event.modifiers():
            step = arrow_step(selected, shape, key, picture.camera)
            if step is not None:
                return self._step_to(step, picture)
        if self.dragger.is_dragging:
            return False
        return self._request(moved_by_key(event, picture.camera, self._viewport.logical_size))

    def _escape(self, picture: Picture) -> bool:
        if self.dragger.is_pressed:
            self.dragger.cancel()
        elif picture.last_selected is not None:
            self.selected.emit(None)
        else:
            return False
        return True

    def _step_to(self, index: NetIndex | None, picture: Picture) -> bool:
        if index is None or self.dragger.is_pressed or not picture.settings.control_points:
            return False
        self._select(index, picture)
        return True

    def _select(self, index: NetIndex | None, picture: Picture) -> None:
        if index != picture.last_selected:
            self.selected.emit(index)
