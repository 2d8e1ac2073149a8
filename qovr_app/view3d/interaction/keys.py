"""What keys mean in the view: steps through the control net, turns and zooms of the camera."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import Qt

from qovr_app.view3d.scene.camera import Camera
from qovr_app.view3d.scene.scene import NetIndex
from qovr_core.document import NET_SIZE

_ARROWS = {
    Qt.Key.Key_Left: (-1.0, 0.0),
    Qt.Key.Key_Right: (1.0, 0.0),
    Qt.Key.Key_Up: (0.0, 1.0),
    Qt.Key.Key_Down: (0.0, -1.0),
}
_ZOOM = 1.15
_ZOOMS = {Qt.Key.Key_Plus: _ZOOM, Qt.Key.Key_Equal: _ZOOM, Qt.Key.Key_Minus: 1 / _ZOOM}


def next_point(selected: NetIndex | None, *, forward: bool) -> NetIndex | None:
    """Return the next control point in the order P_00, P_01, ...; None past the ends, where focus moves
    on."""
    count = NET_SIZE * NET_SIZE
    if selected is None:
        number = 0 if forward else count - 1
    else:
        number = selected[0] * NET_SIZE + selected[1] + (1 if forward else -1)
    return divmod(number, NET_SIZE) if 0 <= number < count else None


def arrow_step(selected: NetIndex, key: int, camera: Camera) -> NetIndex | None:
    """Return the neighbour in the net that lies in an arrow's direction on the screen.

    The net is taken as it lies in the paper's data, j along x and i along y; None for other keys and off
    the net.
    """
    if key not in _ARROWS:
        return None
    right, up, _ = camera.axes
    arrow = np.array(_ARROWS[key])
    steps = {(0, 1): (right[0], up[0]), (1, 0): (right[1], up[1])}
    steps |= {(-i, -j): (-x, -y) for (i, j), (x, y) in steps.items()}
    di, dj = max(steps, key=lambda step: float(arrow @ np.array(steps[step])))
    i, j = selected[0] + di, selected[1] + dj
    return (i, j) if 0 <= i < NET_SIZE and 0 <= j < NET_SIZE else selected


def orbit_step(key: int) -> tuple[float, float] | None:
    """Return the arrow's direction, right and up; None for other keys."""
    return _ARROWS.get(key)


def zoom_step(key: int) -> float | None:
    """Return by how much a key enlarges; None for other keys."""
    return _ZOOMS.get(key)
