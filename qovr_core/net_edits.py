"""Edits of selected control points, as values: each says where the points of any net come to stand.

``edit.of(net, indices)`` returns where the points come to stand, (k, 3), for a net (rows, columns, 3) and ``indices``
(k, 2), the one picked last first.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum
from math import cos, radians, sin
from typing import ClassVar

import numpy as np

from qovr_core.arrays import Array, Indices
from qovr_core.errors import QovrError

Triple = tuple[float, float, float]
"""Numbers for x, y, z."""

_STRENGTH = 0.5
"""How far one smoothing goes towards the mean of the neighbours: the whole way would let a net swing."""


class About(StrEnum):
    """The point that scaling and turning leave where it is."""

    CENTROID = "centroid"
    LAST = "last"


class Plane(StrEnum):
    """What flattening brings points into: the plane of their mean height, or the one nearest to all of them."""

    HEIGHT = "height"
    BEST = "best"


@dataclass(frozen=True)
class Transform:
    """Scale, then turn, both about a point, then move.

    Parameters
    ----------
    displacement : along x, y, z
    factors : along x, y, z
    axis, degrees : about which axis, 0, 1 or 2, and by how much, counterclockwise seen from its far end
    about : what stays where it is, the displacement apart
    """

    displacement: Triple = (0.0, 0.0, 0.0)
    factors: Triple = (1.0, 1.0, 1.0)
    axis: int = 2
    degrees: float = 0.0
    about: About = About.CENTROID

    is_soft: ClassVar[bool] = True

    @property
    def verb(self) -> str:
        """What a step calls it."""
        parts = {
            "Scale": self.factors != (1, 1, 1),
            "Rotate": self.degrees != 0,
            "Move": self.displacement != (0, 0, 0),
        }
        done = [verb for verb, is_done in parts.items() if is_done]
        return done[0] if len(done) == 1 else "Transform"

    def of(self, net: Array, indices: Indices) -> Array:
        points = _points(net, indices)
        centre = points[0] if self.about is About.LAST else points.mean(axis=0)
        away = (points - centre) * self.factors
        first, second = (self.axis + 1) % 3, (self.axis + 2) % 3
        c, s = cos(radians(self.degrees)), sin(radians(self.degrees))
        turned = away.copy()
        turned[:, first] = c * away[:, first] - s * away[:, second]
        turned[:, second] = s * away[:, first] + c * away[:, second]
        # only what is asked for touches a number: a move by 0.1 is that to the last bit
        is_move = self.factors == (1, 1, 1) and self.degrees == 0
        moved: Array = (points if is_move else centre + turned) + np.array(self.displacement)
        return moved


@dataclass(frozen=True)
class Flatten:
    """Bring points into one plane."""

    plane: Plane = Plane.HEIGHT

    verb: ClassVar[str] = "Flatten"
    is_soft: ClassVar[bool] = False

    def of(self, net: Array, indices: Indices) -> Array:
        """Return the points in their plane; raises QovrError where there are too few to have one."""
        best = self.plane is Plane.BEST
        points = _enough(net, indices, 4 if best else 2, "flatten")
        centre = points.mean(axis=0)
        if not best:
            points[:, 2] = centre[2]
            return points
        away = points - centre
        normal = np.linalg.svd(away, full_matrices=True)[2][2]
        flat: Array = points - np.outer(away @ normal, normal)
        return flat


@dataclass(frozen=True)
class Align:
    """Give points the coordinate of the one picked last, along axis 0, 1 or 2."""

    axis: int

    verb: ClassVar[str] = "Align"
    is_soft: ClassVar[bool] = False

    def of(self, net: Array, indices: Indices) -> Array:
        """Return the points in line; raises QovrError where there is only one."""
        points = _enough(net, indices, 2, "align")
        points[:, self.axis] = points[0, self.axis]
        return points


@dataclass(frozen=True)
class Smooth:
    """Bring points half the way to the mean of their neighbours in the net.

    Points of a border have their neighbours along it, so the border keeps its place; corners stay.
    """

    verb: ClassVar[str] = "Smooth"
    is_soft: ClassVar[bool] = False

    def of(self, net: Array, indices: Indices) -> Array:
        points = _points(net, indices)
        goal, count = np.zeros_like(points), np.zeros((len(points), 1))
        for axis in (0, 1):  # on a border there is no neighbour on one side: there those along it count alone
            step = np.eye(2, dtype=np.intp)[axis]
            inner = (indices[:, axis] > 0) & (indices[:, axis] < net.shape[axis] - 1)
            for neighbour in (indices[inner] - step, indices[inner] + step):
                goal[inner] += _points(net, neighbour)
            count[inner] += 2
        goal /= np.maximum(count, 1)
        smooth: Array = np.where(count > 0, points + _STRENGTH * (goal - points), points)
        return smooth


NetEdit = Transform | Flatten | Align | Smooth
"""Everything that can be done to selected points by a command."""


def _points(net: Array, indices: Indices) -> Array:
    points: Array = net[indices[:, 0], indices[:, 1]]
    return points


def _enough(net: Array, indices: Indices, count: int, verb: str) -> Array:
    """Return the points, of which there have to be some."""
    if len(indices) < count:
        raise QovrError(f"To {verb} takes {count} points or more; {len(indices)} selected")
    return _points(net, indices)
