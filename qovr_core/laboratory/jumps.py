"""How much what meets at joints differs: positions, derivatives, tangent planes, and where most."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from math import perm
from typing import Any

import numpy as np

from qovr_core.arrays import Array, Flags
from qovr_core.document import NetIndex, Window
from qovr_core.geometry import bernstein
from qovr_core.geometry.knots import Direction
from qovr_core.geometry.patch import PATCH_DEGREE
from qovr_core.geometry.windows import NET_SIZE, STEP
from qovr_core.laboratory.neighbours import Sides

_ORDERS = 3
"""Position, first and second cross derivative."""

_ALONG = np.linspace(0, 1, 41)
"""Where along every window of a joint its sides are compared; about the worst place they are compared again, so closely
that no more than a millionth of the largest difference is missed."""


@dataclass(frozen=True)
class JointPlace:
    """A place on a joint.

    Parameters
    ----------
    across : the direction of the curves that cross it
    window : the window before the joint
    after : the number of the window after it, along the curves that cross it
    at : the place in the window's own parameter along the joint, from 0 to 1
    """

    across: Direction
    window: Window
    after: int
    at: float

    @property
    def parameters(self) -> tuple[float, float]:
        """Its u and v in the window before the joint."""
        return (1.0, self.at) if self.across is Direction.ROWS else (self.at, 1.0)

    @property
    def nearest_point(self) -> NetIndex:
        """The control point on the joint that is nearest to it; the curve along the joint meets three."""
        a, b = self.window
        along, across = 1 + round(2 * self.at), NET_SIZE - 2
        i, j = (along, across) if self.across is Direction.ROWS else (across, along)
        return STEP * a + i, STEP * b + j

    def __str__(self) -> str:
        a, b = self.window
        before = b if self.across is Direction.ROWS else a
        along = self.across.other.parameter
        return f"{self.across.parameter}-joint {before}|{self.after} at {along} = {self.at:.2f} of window ({a}, {b})"


@dataclass(frozen=True)
class Jump:
    """How far neighbours differ along their joints.

    Parameters
    ----------
    value : the largest difference, as part of the size of the larger of both patches; of planes, in degrees
    is_rounding : whether it is nowhere more than rounding
    place : where it is largest
    """

    value: float
    is_rounding: bool
    place: JointPlace


@dataclass(frozen=True)
class Jumps:
    """What differs at joints.

    Parameters
    ----------
    by_order : position, first and second cross derivative in the windows' own parameters, from 0 to 1 in each
    in_net : the first cross derivative in the net's parameter, in which windows have their lengths
    planes : the tangent planes
    """

    by_order: tuple[Jump, ...]
    in_net: Jump
    planes: Jump

    @property
    def are_rounding(self) -> bool:
        """Whether neither positions nor first and second cross derivatives jump."""
        return all(jump.is_rounding for jump in self.by_order)


Compared = Callable[[Any, Array], tuple[Array, Flags]]
"""Given an index of joints and windows along them, and places along those, returns differences and whether each is no
more than rounding, both (..., places)."""


def jumps(sides: Sequence[Sides]) -> Jumps:
    """Return what differs at joints, from the exact derivatives on both sides."""
    of_sides = [[_worst(one, compared) for compared in _comparisons(one)] for one in sides]
    (*by_order, in_net, planes) = (_worst_of(each) for each in zip(*of_sides, strict=True))
    return Jumps(tuple(by_order), in_net, planes)


def _worst_of(each: Sequence[Jump]) -> Jump:
    return replace(max(each, key=lambda jump: jump.value), is_rounding=all(jump.is_rounding for jump in each))


def _comparisons(sides: Sides) -> Iterator[Compared]:
    """Yield what is compared: by order, the first derivative in the net's parameter, the planes."""
    sizes = [np.ptp(patches, axis=(2, 3)).max(axis=-1) for patches in (sides.before, sides.after)]
    size = np.maximum(*sizes)
    size[size == 0] = 1
    for order in range(_ORDERS):
        before, after, noise = _ends(sides, order)
        yield _distances(before - after, noise, size)
    before, after, noise = _ends(sides, 1)
    first, second = (length[:, None, None, None] for length in sides.lengths.T)
    shorter = np.minimum(first, second)
    yield _distances(before / first - after / second, noise / shorter[..., 0], size)
    yield _planes(sides)


def _ends(sides: Sides, order: int) -> tuple[Array, Array, Array]:
    """Return a cross derivative on both sides, (joints, windows, 7, 3), and its rounding (joints, windows, 3)."""
    factor = perm(PATCH_DEGREE, order)
    before = factor * np.diff(sides.before[:, :, -1 - order :], order, axis=2)[:, :, -1]
    after = factor * np.diff(sides.after[:, :, : 1 + order], order, axis=2)[:, :, 0]
    return before, after, factor * 2**order * sides.noise  # so often is it a difference of two coefficients


def _distances(differences: Array, noise: Array, size: Array) -> Compared:
    """Return a comparison by differences along the joint, (joints, windows, 7, 3), as part of sizes."""

    def compared(index: Any, along: Array) -> tuple[Array, Flags]:
        points = bernstein.basis(PATCH_DEGREE, along) @ differences[index]
        is_rounding = (np.abs(points) <= noise[index][..., None, :]).all(axis=-1)
        return np.linalg.norm(points, axis=-1) / size[index][..., None], is_rounding

    return compared


def _planes(sides: Sides) -> Compared:
    """Return a comparison by the angle between normals; where a side has none, there is nothing to compare."""
    lines, tangents = _ends(sides, 0)[:2], _ends(sides, 1)
    noise = np.linalg.norm(tangents[2], axis=-1)  # also that of a derivative along the joint

    def compared(index: Any, along: Array) -> tuple[Array, Flags]:
        (first, of_first), (second, of_second) = (
            _normals(line[index], tangent[index], noise[index], along)
            for line, tangent in zip(lines, tangents[:2], strict=True)
        )
        sine, cosine = np.linalg.norm(np.cross(first, second), axis=-1), (first * second).sum(axis=-1)
        angle, rounding = np.arctan2(sine, cosine), of_first + of_second
        is_defined = np.isfinite(rounding)
        return np.where(is_defined, np.degrees(angle), 0.0), ~is_defined | (angle <= rounding)

    return compared


def _normals(line: Array, tangent: Array, noise: Array, along: Array) -> tuple[Array, Array]:
    """Return normals along joints, (..., places, 3), and their rounding in radians; infinite where there are none."""
    crossing = bernstein.basis(PATCH_DEGREE, along) @ tangent
    running = bernstein.basis(PATCH_DEGREE - 1, along) @ bernstein.derivative(line, line.ndim - 2)
    normal = np.cross(crossing, running)
    noise = noise[..., None]
    rounding = noise * (np.linalg.norm(crossing, axis=-1) + np.linalg.norm(running, axis=-1) + noise)
    length = np.linalg.norm(normal, axis=-1)
    return normal, np.divide(rounding, length, out=np.full_like(length, np.inf), where=length > rounding)


def _worst(sides: Sides, compared: Compared) -> Jump:
    values, is_rounding = compared(np.s_[:, :], _ALONG)
    joint, window, k = (int(index) for index in np.unravel_index(values.argmax(), values.shape))
    near = np.linspace(_ALONG[max(k - 1, 0)], _ALONG[min(k + 1, len(_ALONG) - 1)], len(_ALONG))
    closer, _ = compared((joint, window), near)
    best = int(closer.argmax())
    of_window = (window, joint) if sides.across is Direction.ROWS else (joint, window)
    place = JointPlace(sides.across, of_window, (joint + 1) % sides.windows, float(near[best]))
    return Jump(float(closer[best]), bool(is_rounding.all()), place)
