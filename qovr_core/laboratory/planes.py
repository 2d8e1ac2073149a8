"""Planes in which a curve in space is drawn."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum

import numpy as np
import numpy.typing as npt

from qovr_core.arrays import Array, read_only
from qovr_core.number_texts import MINUS

_ON_A_LINE = 1e-9
"""Points whose second extent is below this part of the first count as on one line: they single out no plane."""

_NO_PART = 5e-3
"""A direction cosine below this is not written: it would read 0.00."""


class View(StrEnum):
    """The planes to choose from."""

    XY = "xy"
    XZ = "xz"
    YZ = "yz"
    BEST = "best"


_AXES = {View.XY: (0, 1), View.XZ: (0, 2), View.YZ: (1, 2)}


@dataclass(frozen=True, eq=False)
class Plane:
    """Two directions of unit length at right angles, rightward and upward in a drawing; (2, 3)."""

    directions: Array

    def drawn(self, points: npt.ArrayLike) -> Array:
        """Return points (..., 3) as they are drawn, (..., 2)."""
        return np.asarray(points, dtype=np.float64) @ self.directions.T

    @property
    def labels(self) -> tuple[str, str]:
        """What the two directions are called: ``x``, or a sum such as ``0.80 x + 0.60 y``."""
        across, up = (_label(direction) for direction in self.directions)
        return across, up


def plane_of(points: npt.ArrayLike, view: View) -> Plane:
    """Return the plane in which points are drawn.

    Parameters
    ----------
    points : (n, 3), n at least 3
    view : a coordinate plane, or ``best`` for the plane of least squares through the points, its directions
        turned as near to those of the nearest coordinate plane as they go. Points on one line are drawn in
        the coordinate plane in which they reach farthest.
    """
    if view is not View.BEST:
        return _coordinate_plane(*_AXES[view])
    centred = np.asarray(points, dtype=np.float64)
    centred = centred - centred.mean(axis=0)
    _, extents, principal = np.linalg.svd(centred)
    if extents[1] <= _ON_A_LINE * extents[0]:
        away = int(np.argmin(np.ptp(centred, axis=0)))
        return _coordinate_plane(*(axis for axis in range(3) if axis != away))
    normal = principal[2]
    across, up = _AXES_WITHOUT[int(np.argmax(np.abs(normal)))]
    upward = np.eye(3)[up] - normal[up] * normal
    upward /= np.linalg.norm(upward)
    rightward = np.cross(upward, normal)
    rightward *= np.copysign(1.0, rightward[across])
    return Plane(read_only(np.array([rightward, upward])))


_AXES_WITHOUT = {2: _AXES[View.XY], 1: _AXES[View.XZ], 0: _AXES[View.YZ]}


def _coordinate_plane(across: int, up: int) -> Plane:
    return Plane(read_only(np.eye(3)[[across, up]]))


def _label(direction: Array) -> str:
    parts = [(value, axis) for value, axis in zip(direction, "xyz", strict=True) if abs(value) >= _NO_PART]
    if len(parts) == 1:
        return parts[0][1]
    text = " ".join(f"{'+' if value > 0 else MINUS} {abs(value):.2f} {axis}" for value, axis in parts)
    return text.removeprefix("+ ")
