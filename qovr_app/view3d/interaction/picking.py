"""Picking control points by projection, on the CPU. NumPy alone."""

from __future__ import annotations

import numpy as np

from qovr_app.view3d.scene.camera import Camera, Size
from qovr_app.view3d.scene.scene import Scene
from qovr_core.document import NetIndex

PICK_RADIUS = 10.0
"""Logical pixels around a point that belong to it: twice the disc, an easy target also for a trackpad."""

_SAME_PLACE = 0.5
"""Points closer than this many pixels lie on one another; the nearer to the viewer is meant."""


def pick(scene: Scene, camera: Camera, size: Size, x: float, y: float) -> NetIndex | None:
    """Return the control point under a pixel: the nearest on the screen, then the nearest to the viewer."""
    _, columns = scene.net_shape
    seen = camera.project(scene.points.reshape(-1, 3), size)
    away = np.hypot(seen[:, 0] - x, seen[:, 1] - y)
    near = np.flatnonzero(away <= PICK_RADIUS)  # points behind the eye are NaN, and near to nothing
    if near.size == 0:
        return None
    best = near[np.lexsort((seen[near, 2], np.floor(away[near] / _SAME_PLACE)))][0]
    return divmod(int(best), columns)
