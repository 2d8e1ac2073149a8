"""Where a plane cuts a surface: curves on the surface itself, not on a mesh of it."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np
import numpy.typing as npt

from qovr_core.arrays import Array, read_only
from qovr_core.geometry.differential import ParametricSurface
from qovr_core.geometry.rounding import ROUNDING

_SAMPLES = 128
"""Samples each way that tell how the curves run; an even count, so that the middle of a symmetric net is none."""

_LEAST = 4
"""Gaps between them in one polynomial of many."""

_NEWTON_STEPS = 8
"""From a place on the grid, off by its square, four steps reach rounding; the others bring back what went astray."""

_NOT_REACHED = 1e-9
"""A point farther from the plane than this part of the surface's size is on no curve: the surface is level there."""


@dataclass(frozen=True)
class CuttingPlane:
    """A plane, and how what lies in it is drawn.

    Parameters
    ----------
    normal : unit vector
    offset : where it stands along the normal; None for the middle of the surface
    across, up : unit vectors in the plane, rightward and upward in a drawing
    origin : the point from which both are counted
    labels : what the two are called
    """

    normal: tuple[float, float, float]
    offset: float | None
    across: tuple[float, float, float]
    up: tuple[float, float, float]
    origin: tuple[float, float, float] = (0.0, 0.0, 0.0)
    labels: tuple[str, str] = ("", "")

    def drawn(self, points: npt.ArrayLike) -> Array:
        """Return points (..., 3) as they are drawn, (..., 2)."""
        from_origin = np.asarray(points, dtype=np.float64) - self.origin
        return np.asarray(from_origin @ np.transpose([self.across, self.up]))


@dataclass(frozen=True, eq=False)
class SectionCurve:
    """One piece of a section.

    Parameters
    ----------
    parameters : (n, 2) u and v
    points : (n, 3) on the surface and in the plane, to rounding
    length : of the curve, in the surface's unit
    """

    parameters: Array
    points: Array
    length: float

    @property
    def is_closed(self) -> bool:
        """Whether it ends where it begins, and not at an edge of the surface."""
        return bool((self.parameters[0] == self.parameters[-1]).all())


def plane_across(axis: int, place: float | None) -> CuttingPlane:
    """Return the plane on which x, y or z (axis 0, 1, 2) is constant; None for the middle of the surface."""
    unit = np.eye(3)
    first, second = (k for k in range(3) if k != axis)
    as_tuple = [(float(x), float(y), float(z)) for x, y, z in unit]
    labels = "xyz"[first], "xyz"[second]
    return CuttingPlane(as_tuple[axis], place, as_tuple[first], as_tuple[second], labels=labels)


def upright_plane(start: npt.ArrayLike, end: npt.ArrayLike) -> CuttingPlane | None:
    """Return the plane along z through two points (3,); None where one stands over the other."""
    a, b = (np.asarray(point, dtype=np.float64) for point in (start, end))
    across = (b - a) * (1, 1, 0)
    length = float(np.linalg.norm(across))
    if length <= ROUNDING * float(np.abs([a, b]).max(initial=0.0)):
        return None
    x, y, _ = (across / length).tolist()
    normal = (-y, x, 0.0)
    origin = (float(a[0]), float(a[1]), 0.0)
    return CuttingPlane(normal, float(a @ normal), (x, y, 0.0), (0.0, 0.0, 1.0), origin, ("along", "z"))


def section(surface: ParametricSurface, plane: CuttingPlane) -> tuple[float, tuple[SectionCurve, ...]]:
    """Cut a surface by a plane.

    Returns
    -------
    where along its normal the plane stands, and the pieces of the section, the longest first; none where the plane
    misses the surface or holds all of it
    """
    from contourpy import contour_generator

    u, v = (_grid(*ends, breaks) for ends, breaks in zip(surface.domain, surface.breaks, strict=True))
    points = surface.points(u, v)
    heights = points @ plane.normal
    low, high = float(heights.min()), float(heights.max())
    offset = (low + high) / 2 if plane.offset is None else plane.offset
    size, rounding = float(np.ptp(points.reshape(-1, 3), axis=0).max()), ROUNDING * float(np.abs(points).max())
    if high - low <= rounding:
        return offset, ()
    off = heights - offset
    off = np.where(np.abs(off) <= rounding, -np.copysign(rounding, off.mean()), off)  # finds an edge in the plane, too
    lines = contour_generator(x=u, y=v, z=off.T).lines(0.0)
    pieces = [_curve(surface, plane.normal, offset, np.asarray(line), _NOT_REACHED * size) for line in lines]
    found = [piece for piece in pieces if piece is not None]
    return offset, tuple(sorted(found, key=lambda piece: -piece.length))


def _grid(first: float, last: float, breaks: Array) -> Array:
    """Return the parameters of samples in one direction, as many in every polynomial."""
    ends = np.array([first, *breaks, last])
    each = max(-(-(_SAMPLES - 1) // (len(ends) - 1)), _LEAST)
    inner = [np.linspace(start, end, each + 1)[:-1] for start, end in pairwise(ends[:-1].tolist())]
    return np.concatenate([*inner, np.linspace(ends[-2], ends[-1], each + 1)])


def _curve(
    surface: ParametricSurface, normal: tuple[float, float, float], offset: float, line: Array, reached: float
) -> SectionCurve | None:
    """Return the curve near a line of the grid (n, 2), with a point between each two; None where it leads to none."""
    between = (line[1:] + line[:-1]) / 2
    dense = np.empty((2 * len(line) - 1, 2))
    dense[::2], dense[1::2] = line, between
    parameters = _onto_plane(surface, normal, offset, dense)
    if (dense[0] == dense[-1]).all():
        parameters[-1] = parameters[0]
    points = surface.derivative_at(parameters[:, 0], parameters[:, 1], 0, 0)
    is_there = np.abs(points @ normal - offset) <= reached
    if is_there.sum() < 2:
        return None
    parameters, points = parameters[is_there], points[is_there]
    return SectionCurve(read_only(parameters), read_only(points), _length(points))


def _onto_plane(surface: ParametricSurface, normal: tuple[float, float, float], offset: float, start: Array) -> Array:
    """Return parameters (n, 2) moved onto the plane by Newton's method; what is on an edge stays on it."""
    u, v = start.T.copy()
    ends_u, ends_v = surface.domain
    holds_u, holds_v = np.isin(u, ends_u), np.isin(v, ends_v)
    for _ in range(_NEWTON_STEPS):
        off = surface.derivative_at(u, v, 0, 0) @ normal - offset
        slope_u = np.where(holds_u, 0.0, surface.derivative_at(u, v, 1, 0) @ normal)
        slope_v = np.where(holds_v, 0.0, surface.derivative_at(u, v, 0, 1) @ normal)
        squared = slope_u**2 + slope_v**2
        part = np.divide(off, squared, out=np.zeros_like(off), where=squared > 0)
        u, v = np.clip(u - part * slope_u, *ends_u), np.clip(v - part * slope_v, *ends_v)
    return np.stack([u, v], axis=1)


def _length(points: Array) -> float:
    """Return the length of a curve through points, with what chords miss of it, which is a third of what half as many
    chords miss more."""
    fine = float(np.linalg.norm(np.diff(points, axis=0), axis=1).sum())
    coarse = float(np.linalg.norm(np.diff(points[::2], axis=0), axis=1).sum()) if len(points) % 2 else fine
    return fine + (fine - coarse) / 3
