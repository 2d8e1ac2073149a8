"""The gizmo at the selected points: an arrow along every axis and a square in every plane. NumPy alone."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from qovr_app.view3d.scene.camera import Camera, Size
from qovr_app.view3d.scene.grip import Freedom, across, along
from qovr_core.arrays import Array

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
    """Return the gizmo at a point (3,) of the unit space; None where the point is behind the eye."""
    seen = camera.project(point[None], size)[0]
    if not np.isfinite(seen).all():
        return None
    aside = camera.unproject((seen + np.array([1.0, 0.0, 0.0]))[None], size)[0]
    length = _LENGTH * float(np.linalg.norm(aside - point))
    axes = length * np.eye(3)
    places = camera.project(np.concatenate([point + axes, _squares(point, axes)]), size)[:, :2]
    origin, tips, corners = seen[:2], places[:3], places[3:].reshape(3, 4, 2)
    arrows = {}
    for axis, tip in enumerate(tips):
        seen_length = math.hypot(*(tip - origin))
        if seen_length >= _SHORTEST:
            arrows[axis] = np.stack([origin + (tip - origin) * (_BEGIN / seen_length), tip])
    squares = {axis: square for axis, square in enumerate(corners) if abs(_area(square)) >= _FLATTEST}
    return Gizmo(arrows, squares)


def _squares(point: Array, axes: Array) -> Array:
    """Return the corners (12, 3) of the three squares."""
    corners = [
        point + first * axes[across(axis).axes[0]] + second * axes[across(axis).axes[1]]
        for axis in range(3)
        for first, second in ((_NEAR, _NEAR), (_FAR, _NEAR), (_FAR, _FAR), (_NEAR, _FAR))
    ]
    return np.array(corners)


def _distance(at: Array, ends: Array) -> float:
    way = ends[1] - ends[0]
    part = min(1.0, max(0.0, float((at - ends[0]) @ way / (way @ way))))
    return math.hypot(*(at - ends[0] - part * way))


def _area(corners: Array) -> float:
    """Return the signed area of a polygon (k, 2)."""
    after = np.roll(corners, -1, axis=0)
    return float((corners[:, 0] * after[:, 1] - corners[:, 1] * after[:, 0]).sum() / 2)


def _holds(corners: Array, at: Array) -> bool:
    """Return whether a convex polygon (k, 2) holds a point."""
    along_side, to_point = np.roll(corners, -1, axis=0) - corners, at - corners
    side = along_side[:, 0] * to_point[:, 1] - along_side[:, 1] * to_point[:, 0]
    return bool((side >= 0).all() or (side <= 0).all())
