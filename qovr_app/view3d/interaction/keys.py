"""What keys mean in the view: steps through the control net, turns and zooms of the camera."""

from __future__ import annotations

from PySide6.QtCore import Qt
from PySide6.QtGui import QGuiApplication, QKeyEvent

from qovr_app.view3d.scene.camera import Camera
from qovr_core.document import NetIndex

_AXIS_KEYS: dict[int, int] = {Qt.Key.Key_X: 0, Qt.Key.Key_Y: 1, Qt.Key.Key_Z: 2}
"""A tap locks a dragged point to the line along that axis, with Shift to the plane that the axis stands on."""

_FIRST_FOREIGN = 0x370
"""Keys are named by their letters; from here on, those of scripts that have no X, Y, Z on any key."""

_EVDEV_AXES = {53: 0, 29: 1, 52: 2}
"""Scan codes of the keys on which a Latin keyboard has X, Y, Z: X11 and Wayland count from 8, as Linux from 0."""

_MAC_AXES = {7: 0, 16: 1, 6: 2}
_WINDOWS_AXES = {ord("X"): 0, ord("Y"): 1, ord("Z"): 2}
"""Virtual keys, which on Windows are Latin letters under every layout, and on macOS places."""

_ARROWS: dict[int, tuple[float, float]] = {
    Qt.Key.Key_Left: (-1.0, 0.0),
    Qt.Key.Key_Right: (1.0, 0.0),
    Qt.Key.Key_Up: (0.0, 1.0),
    Qt.Key.Key_Down: (0.0, -1.0),
}
_ZOOM = 1.15
_ZOOMS: dict[int, float] = {Qt.Key.Key_Plus: _ZOOM, Qt.Key.Key_Equal: _ZOOM, Qt.Key.Key_Minus: 1 / _ZOOM}


def axis_of(event: QKeyEvent) -> int | None:
    """Return the axis that a key stands for under any layout: by its letter, else by its place; None for other keys."""
    key = event.key()
    if key in _AXIS_KEYS:
        return _AXIS_KEYS[key]
    if not _FIRST_FOREIGN <= key < Qt.Key.Key_Escape and key != Qt.Key.Key_unknown:
        return None
    platform = QGuiApplication.platformName()
    if platform == "windows":
        return _WINDOWS_AXES.get(event.nativeVirtualKey())
    if platform == "cocoa":
        return _MAC_AXES.get(event.nativeVirtualKey())
    return _EVDEV_AXES.get(event.nativeScanCode())


def arrow_step(selected: NetIndex | None, shape: tuple[int, int], key: int, camera: Camera) -> NetIndex | None:
    """Return the neighbour in a net of rows and columns that lies in an arrow's direction on the screen.

    The net is taken as it lies in the paper's data, j along x and i along y; None for other keys, the point itself
    where the net ends, and the first point where none is selected yet.
    """
    if key not in _ARROWS:
        return None
    if selected is None:
        return 0, 0
    right, up, _ = camera.axes
    across, upward = _ARROWS[key]
    along = {(0, 1): (right[0], up[0]), (1, 0): (right[1], up[1])}
    along |= {(-i, -j): (-x, -y) for (i, j), (x, y) in along.items()}
    di, dj = max(along, key=lambda step: float(across * along[step][0] + upward * along[step][1]))
    i, j = selected[0] + di, selected[1] + dj
    return (i, j) if 0 <= i < shape[0] and 0 <= j < shape[1] else selected


def orbit_step(key: int) -> tuple[float, float] | None:
    """Return the arrow's direction, right and up; None for other keys."""
    return _ARROWS.get(key)


def zoom_step(key: int) -> float | None:
    """Return by how much a key enlarges; None for other keys."""
    return _ZOOMS.get(key)
