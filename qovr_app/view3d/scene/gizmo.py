"""The gizmo at the selected points: an arrow along every axis and a square in every plane. NumPy alone."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from qovr_app.view3d.scene.camera import Camera, Size
from qovr_app.view3d.scene.grip import Freedom, across, along
from qovr_core.arrays import Array, read_only

_LENGTH = 72.0
"""Logical pixels of an arrow that lies across the line of sight."""

_NEAR, _FAR = 0.3, 0.52
"""Where a plane's square begins and ends along both of its arrows."""

_SHORTEST = 24.0
"""Pixels: an arrow that looks shorter points at the viewer, and a hand cannot follow it."""

_FLATTEST = 40.0
"""Square pixels: a square that looks smaller is seen edge on."""

_BEGIN = 13.0
"""Pixels from the point at which its arrows begin: what is nearer is the point itself."""

_REACH = 6.0
"""Pixels beside an arrow, or beyond its tip, that belong to it."""


@dataclass(frozen=True, eq=False)
class Gizmo:
    """A gizmo on the screen, in logical pixels; what cannot be taken hold of from here is left out.

    Parameters
    ----------
    arrows : by the axis, where the arrow begins and ends, (2, 2)
    squares : by the axis that stands on it, the corners of a plane's square, (4, 2)
    """

    arrows: dict[int, Array]
    squares: dict[int, Array]

    def freedom_under(self, x: float, y: float) -> Freedom | None:
        """Return what a hand that takes hold of the gizmo at a pixel may change; None beside it."""
        at = np.array([x, y])
        for axis, ends in self.arrows.items():
            if _distance(at, ends) <= _REACH:
                return along(axis)
        for axis, corners in self.squares.items():
            if _holds(corners, at):
                return across(axis)
        return None


def gizmo_at(point: Array, camera: Camera, size: Size) -> Gizmo | None:
    """Return the gizmo at a point (3,) of the unit space; None where a part of it is behind the eye."""
    length = _LENGTH * camera.pixel_length(size, point)
    places = camera.project(point + length * _SHAPE, size)[:, :2]
    if not np.isfinite(places).all():
        return None
    origin, tips, corners = places[0], places[1:4], places[4:].reshape(3, 4, 2)
    arrows = {}
    for axis, tip in enumerate(tips):
        seen_length = math.hypot(*(tip - origin))
        if seen_length >= _SHORTEST:
            arrows[axis] = np.stack([origin + (tip - origin) * (_BEGIN / seen_length), tip])
    squares = {axis: square for axis, square in enumerate(corners) if abs(_area(square)) >= _FLATTEST}
    return Gizmo(arrows, squares)


def _shape() -> Array:
    """Return the origin, the three tips and the corners of the three squares, (16, 3), in lengths of an arrow."""
    squares = [
        first * np.eye(3)[across(axis).axes[0]] + second * np.eye(3)[across(axis).axes[1]]
        for axis in range(3)
        for first, second in ((_NEAR, _NEAR), (_FAR, _NEAR), (_FAR, _FAR), (_NEAR, _FAR))
    ]
    return read_only(np.concatenate([np.zeros((1, 3)), np.eye(3), squares]))


_SHAPE = _shape()


def _distance(at: Array, ends: Array) -> float:
    way = ends[1] - ends[0]
    part = min(1.0, max(0.0, float((at - ends[0]) @ way / (way @ way))))
    return math.hypot(*(at - ends[0] - part * way))


def _area(corners: Array) -> float:
    """Return the signed area of a polygon (k, 2)."""
    x, y = corners.T.tolist()
    return float(sum(x[k - 1] * y[k] - y[k - 1] * x[k] for k in range(len(x)))) / 2


def _holds(corners: Array, at: Array) -> bool:
    """Return whether a convex polygon (k, 2) holds a point."""
    along_side, to_point = np.roll(corners, -1, axis=0) - corners, at - corners
    side = along_side[:, 0] * to_point[:, 1] - along_side[:, 1] * to_point[:, 0]
    return bool((side >= 0).all() or (side <= 0).all())
