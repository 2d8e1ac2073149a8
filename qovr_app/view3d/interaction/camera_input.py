"""Mouse, trackpad and keys as moves of the camera: from an event and the camera to the next one."""

from __future__ import annotations

from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QKeyEvent, QNativeGestureEvent, QWheelEvent

from qovr_app.view3d.interaction.keys import orbit_step, zoom_step
from qovr_app.view3d.interaction.mouse_schemes import Motion
from qovr_app.view3d.scene.camera import Camera, Size
from qovr_app.view3d.scene.picture import Picture
from qovr_app.view3d.scene.probing import parameters_under
from qovr_core.arrays import Array

_DEGREES_PER_PIXEL = 0.4
_DEGREES_PER_KEY = 5.0
_PIXELS_PER_KEY = 30.0
_ZOOM_PER_NOTCH = 1.15
_NOTCH = 120.0
"""Eighths of a degree that a mouse wheel turns from one notch to the next."""


def pivot_under(picture: Picture, size: Size, at: QPointF) -> Array | None:
    """Return the point (3,) of the unit space about which an orbit turns: what is seen there; None beside it."""
    if not picture.settings.surface:
        return None
    found = parameters_under(picture.scene, picture.camera, size, at.x(), at.y())
    if found is None:
        return None
    u, v = found
    point: Array = picture.scene.patch.points([u], [v])[0, 0]
    return point


def moved_by_mouse(motion: Motion, moved: QPointF, camera: Camera, size: Size, pivot: Array | None) -> Camera:
    """Return the camera after a move of the mouse."""
    if motion is Motion.PAN:
        return camera.panned(moved.x(), moved.y(), size)
    return camera.orbited(-_DEGREES_PER_PIXEL * moved.x(), _DEGREES_PER_PIXEL * moved.y(), pivot)


def moved_by_wheel(event: QWheelEvent, camera: Camera, size: Size) -> Camera:
    """Return the camera after a turn of the wheel, which zooms, or two fingers on a trackpad, which orbit or pan."""
    is_touched = event.phase() != Qt.ScrollPhase.NoScrollPhase and not event.pixelDelta().isNull()
    if not is_touched or event.modifiers() & Qt.KeyboardModifier.ControlModifier:
        # Some systems turn the wheel sideways while Alt or Shift is held.
        turned = event.angleDelta().y() or event.angleDelta().x()
        at = event.position().x(), event.position().y()
        return camera.zoomed(_ZOOM_PER_NOTCH ** (turned / _NOTCH), at, size)
    dx, dy = event.pixelDelta().x(), event.pixelDelta().y()
    if event.modifiers() & Qt.KeyboardModifier.ShiftModifier:
        return camera.panned(dx, dy, size)
    return camera.orbited(-_DEGREES_PER_PIXEL * dx, _DEGREES_PER_PIXEL * dy)


def moved_by_gesture(event: QNativeGestureEvent, camera: Camera, size: Size) -> Camera | None:
    """Return the camera after a trackpad's own gesture; None for gestures that mean nothing here."""
    if event.gestureType() == Qt.NativeGestureType.ZoomNativeGesture:
        return camera.zoomed(1 + event.value(), (event.position().x(), event.position().y()), size)
    if event.gestureType() == Qt.NativeGestureType.RotateNativeGesture:
        return camera.orbited(event.value(), 0.0)
    return None


def moved_by_key(event: QKeyEvent, camera: Camera, size: Size) -> Camera | None:
    """Return the camera after a key, Control and an arrow, or Shift and one; None for keys that mean nothing here."""
    zoom, turn, modifiers = zoom_step(event.key()), orbit_step(event.key()), event.modifiers()
    if zoom is not None:
        return camera.zoomed(zoom, (size[0] / 2, size[1] / 2), size)
    if turn is None:
        return None
    if modifiers & Qt.KeyboardModifier.ShiftModifier:
        return camera.panned(_PIXELS_PER_KEY * turn[0], -_PIXELS_PER_KEY * turn[1], size)
    if modifiers & Qt.KeyboardModifier.ControlModifier:
        return camera.orbited(_DEGREES_PER_KEY * turn[0], _DEGREES_PER_KEY * turn[1])
    return None
