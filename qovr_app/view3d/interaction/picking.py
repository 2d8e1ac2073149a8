"""Picking and dragging control points by projection, on the CPU. NumPy alone."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from qovr_app.view3d.scene.camera import Camera, Size
from qovr_app.view3d.scene.scene import NetIndex, Scene
from qovr_core.arrays import Array, read_only
from qovr_core.document import NET_SIZE

PICK_RADIUS = 10.0
"""Logical pixels around a point that belong to it: twice the disc, an easy target also for a trackpad."""

_SAME_PLACE = 0.5
"""Points closer than this many pixels lie on one another; the nearer to the viewer is meant."""

_PARALLEL = 0.12
"""Sine of the angle between the line of sight and an axis below which a pixel would mean a leap along the
axis."""

_ROUNDING = 1e-9
"""Unit lengths; a coordinate that moves by less is not meant to move, as z seen from above."""


def pick(scene: Scene, camera: Camera, size: Size, x: float, y: float) -> NetIndex | None:
    """Return the control point under a pixel: the nearest on the screen, then the nearest to the viewer."""
    seen = camera.project(scene.points.reshape(-1, 3), size)
    away = np.hypot(seen[:, 0] - x, seen[:, 1] - y)
    near = np.flatnonzero(away <= PICK_RADIUS)  # points behind the eye are NaN, and near to nothing
    if near.size == 0:
        return None
    best = near[np.lexsort((seen[near, 2], np.floor(away[near] / _SAME_PLACE)))][0]
    i, j = divmod(int(best), NET_SIZE)
    return i, j


@dataclass(frozen=True, eq=False)
class Grip:
    """A control point as it was when it was taken hold of; every target is computed from here.

    Parameters
    ----------
    scene, camera, size : as they were then
    index : which point
    x, y : the pixel where the mouse went down
    """

    scene: Scene
    camera: Camera
    size: Size
    index: NetIndex
    x: float
    y: float

    def target(self, x: float, y: float, axis: int | None) -> Array | None:
        """Return where the point belongs when the mouse is at a pixel.

        Parameters
        ----------
        axis : 0, 1, 2 keeps to a line along X, Y, Z; None moves in the plane of the view

        Returns
        -------
        (3,) float64 in the document's units, read-only; None where the axis points at the viewer
        """
        start = self.scene.points[self.index]
        seen = self.camera.project(start[None], self.size)[0]
        goal = np.array([seen[0] + x - self.x, seen[1] + y - self.y, seen[2]])
        if axis is None:
            move = self.camera.unproject(goal[None], self.size)[0] - start
        else:
            along = self._along(axis, start, goal)
            if along is None:
                return None
            move = np.zeros(3)
            move[axis] = along
        move[np.abs(move) < _ROUNDING] = 0.0
        return read_only(self.scene.document.control_points[self.index] + move / self.scene.frame.scale)

    def _along(self, axis: int, start: Array, goal: Array) -> float | None:
        """Return how far along an axis its line comes closest to the line of sight through a pixel."""
        origin, sight = self.camera.ray(goal[0], goal[1], self.size)
        across = 1 - sight[axis] ** 2
        if across < _PARALLEL**2:
            return None
        offset = start - origin
        return float((sight[axis] * (sight @ offset) - offset[axis]) / across)
