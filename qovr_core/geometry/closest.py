"""The point of a surface closest to each of many points: seeds from a grid, then Newton's method on all at once."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from qovr_core.arrays import Array, Flags, Indices, read_only
from qovr_core.geometry.descent import Feet, descend
from qovr_core.geometry.differential import ParametricSurface
from qovr_core.geometry.patch import Patch
from qovr_core.geometry.rounding import LARGEST_BESIDE, in_own_unit, largest

_SEED_CELLS = 64
"""Cells each way between the samples from which the search starts: a polynomial of degree 6 turns many times less
often."""

_CELLS_A_WINDOW = 8
"""Cells of every window, where there are so many windows that these are more."""

_BESIDE = 1.5
"""Parameters no further apart than so many cells in u and v are taken to lead to one foot."""

_NEIGHBOURS = 16
"""Nearest samples asked for: enough that the other sheets which pass as near as the first show among them."""

_AROUND = read_only(np.stack(np.meshgrid(*[np.linspace(-1.0, 1.0, 9)] * 2), axis=-1).reshape(-1, 2))
_FINER = 4
"""Where a tangent vanishes, a foot is looked for among 9 x 9 places around it, and again around the best of them so
many times closer."""

_ROUNDS = 4
"""In the last of four the places are a 170th of a cell apart: along a tangent that vanishes that moves a point by about
its square."""

_LAST_STEP = 1e-8
"""A step shorter than this part of the surface's size leaves an error of about its square, which is rounding."""


@dataclass(frozen=True)
class Closest:
    """The closest points of a surface, one for each of k given points; every array float64 and read-only.

    Parameters
    ----------
    u, v : (k,) parameters of the foot, in the surface's domain
    points : (k, 3) the foot
    distance : (k,) distance of the given point from the foot
    """

    u: Array
    v: Array
    points: Array
    distance: Array


def closest_points(surface: ParametricSurface, points: Array) -> Closest:
    """Return the points of a surface over its domain closest to given points; see ``ClosestSearch``.

    Parameters
    ----------
    surface : any parametric surface; it may be flat, folded or drawn together into a line or a point
    points : (k, 3), finite

    Raises
    ------
    ValueError : the points have another shape
    """
    return ClosestSearch(surface)(points)


class ClosestSearch:
    """The search for the points of a surface closest to others, for as many as one likes: its samples are taken once.

    Every foot is a local minimum of the distance, exact to rounding, inside or on the border. It is the global
    minimum wherever the nearest of 65 x 65 samples, or 9 x 9 a window, tell which sheets of the surface are near;
    folds narrower than the samples can hide a nearer point.

    Parameters
    ----------
    surface : any parametric surface; it may be flat, folded or drawn together into a line or a point
    beside : a length whose square must not overflow either
    """

    def __init__(self, surface: ParametricSurface, beside: float = 0.0) -> None:
        from scipy.spatial import cKDTree

        self.surface = surface
        self._breakpoints = surface.breakpoints if isinstance(surface, Patch) else None
        if isinstance(surface, Patch):  # windows alike, however their lengths differ
            surface = Patch(surface.coefficients, surface.degree)
        self._in_unit, self._unit = in_own_unit(surface, beside=beside)
        self._seeds = _seed_grid(self._in_unit)
        self._tree = cKDTree(self._seeds.points)

    def __call__(self, points: Array) -> Closest:
        """Return the closest points to (k, 3) finite ones; raises ValueError where they have another shape."""
        targets = np.asarray(points, dtype=np.float64)
        if targets.ndim != 2 or targets.shape[1] != 3:
            raise ValueError(f"points have shape {targets.shape}; expected (k, 3)")
        if (far := largest(targets)) > LARGEST_BESIDE * self._unit:
            return ClosestSearch(self.surface, beside=far)(targets)
        best = self._feet(targets / self._unit)
        u, v = best.at.T.copy()
        if (ends := self._breakpoints) is not None:
            u, v = (np.interp(at, np.arange(len(along)), along) for at, along in zip((u, v), ends, strict=True))
        return Closest(*map(read_only, (u, v, best.feet * self._unit, best.distance * self._unit)))

    def _feet(self, targets: Array) -> Feet:
        surface, seeds = self._in_unit, self._seeds
        distance, nearest = self._tree.query(targets, _NEIGHBOURS)
        best = descend(surface, seeds.at[nearest[:, 0]], targets, seeds.last_step)
        candidates = _candidates(seeds, targets, distance, nearest, best)
        while candidates.target.size:
            rows, first = np.unique(candidates.target, return_index=True)
            start = seeds.at[candidates.sample[first]]
            other = descend(surface, start, targets[rows], seeds.last_step)
            best.improve(rows, other)
            place = np.searchsorted(rows, candidates.target)
            at = seeds.at[candidates.sample]
            is_new = _apart(at, start[place], seeds.cell) & _apart(at, other.at[place], seeds.cell)
            candidates = candidates.of(is_new & (candidates.promise < best.distance[candidates.target]))
        _look_around(surface, seeds, targets, best)
        return best


@dataclass(frozen=True)
class _Seeds:
    """Samples of the surface.

    Parameters
    ----------
    at, points, tangents : (q, 2) parameters, (q, 3) and (q, 2, 3)
    is_singular : (q,) whether some direction's tangent is so short there that it vanishes within a cell or so: the
        distance may have a minimum to either side of it, and none that its own derivatives at a sample tell
    last_step : the length of a last step
    cell : (2,) what the parameters of neighbours differ by
    low, counts : (2,) where the samples begin, and how many there are each way
    """

    at: Array
    points: Array
    tangents: Array
    is_singular: Flags
    last_step: float
    cell: Array
    low: Array
    counts: Indices

    def nearest_to(self, at: Array) -> Indices:
        """Return the samples nearest to parameters (k, 2)."""
        u, v = np.clip(np.rint((at - self.low) / self.cell).astype(np.intp), 0, self.counts - 1).T
        nearest: Indices = u * self.counts[1] + v
        return nearest


def _seed_grid(surface: ParametricSurface) -> _Seeds:
    (low_u, high_u), (low_v, high_v) = surface.domain
    windows = np.array(surface.windows if isinstance(surface, Patch) else (1, 1))[::-1]
    counts = np.maximum(_SEED_CELLS, _CELLS_A_WINDOW * windows) + 1
    low, high = np.array([low_u, low_v]), np.array([high_u, high_v])
    u, v = (np.linspace(*along) for along in zip(low, high, counts.tolist(), strict=True))
    cell = (high - low) / (counts - 1)
    at = np.stack(np.meshgrid(u, v, indexing="ij"), axis=-1).reshape(-1, 2)
    orders = ((0, 0), (1, 0), (0, 1), (2, 0), (1, 1), (0, 2))
    points, su, sv, suu, suv, svv = (surface.derivative(u, v, *order).reshape(-1, 3) for order in orders)
    with np.errstate(over="ignore"):  # so large a surface is searched again in other units
        size = float(np.linalg.norm(np.ptp(points, axis=0)))
    bends = sum(np.linalg.norm(second, axis=1) for second in (suu, suv, suv, svv))
    is_singular = _shortest_tangents(su, sv) <= cell.max() / 2 * bends
    return _Seeds(at, points, np.stack([su, sv], axis=1), is_singular, _LAST_STEP * size, cell, low, counts)


def _shortest_tangents(su: Array, sv: Array) -> Array:
    """Return the length of the shortest tangent S_u cos a + S_v sin a over all directions a, for (k, 3), as (k,)."""
    uu, uv, vv = (np.einsum("kd,kd->k", a, b) for a, b in ((su, su), (su, sv), (sv, sv)))
    shortest: Array = np.sqrt(np.maximum((uu + vv) / 2 - np.hypot((uu - vv) / 2, uv), 0.0))
    return shortest


def _look_around(surface: ParametricSurface, seeds: _Seeds, targets: Array, best: Feet) -> None:
    """Improve the feet beside which a tangent vanishes: there a step of Newton's method may be 0 on a ridge."""
    rows = np.flatnonzero(seeds.is_singular[seeds.nearest_to(best.at)])
    at, width = best.at[rows], _BESIDE * seeds.cell
    low, high = np.array(surface.domain).T
    for _ in range(_ROUNDS if rows.size else 0):
        tried = np.clip(at[:, None] + width * _AROUND, low, high)
        points = surface.derivative_at(tried[..., 0].ravel(), tried[..., 1].ravel(), 0, 0).reshape(*tried.shape[:2], 3)
        nearest = np.linalg.norm(points - targets[rows, None], axis=2).argmin(axis=1)
        at, width = tried[np.arange(len(rows)), nearest], width / _FINER
    if rows.size:
        best.improve(rows, descend(surface, at, targets[rows], seeds.last_step))


@dataclass(frozen=True)
class _Candidates:
    """Further samples to search from, (q,) each: for which target, which sample, how near it may lead.

    They stand by target, the most promising of each first.
    """

    target: Indices
    sample: Indices
    promise: Array

    def of(self, wanted: Flags | Indices) -> _Candidates:
        return _Candidates(self.target[wanted], self.sample[wanted], self.promise[wanted])


def _candidates(seeds: _Seeds, targets: Array, distance: Array, nearest: Indices, best: Feet) -> _Candidates:
    """Return the nearest samples that do not lie beside the foot already found, and may lead to a nearer one."""
    target, rank = np.nonzero(_apart(seeds.at[nearest], best.at[:, None], seeds.cell))
    sample, far = nearest[target, rank], distance[target, rank]
    direction = (seeds.points[sample] - targets[target]) / np.where(far > 0, far, 1.0)[:, None]
    gain = np.abs(np.einsum("kpd,kd->kp", seeds.tangents[sample], direction)) @ (seeds.cell / 2)
    candidates = _Candidates(target, sample, far - gain)
    candidates = candidates.of(candidates.promise < best.distance[target])
    return candidates.of(np.lexsort((candidates.promise, candidates.target)))


def _apart(a: Array, b: Array, cell: Array) -> Flags:
    """Return which parameters, (..., 2), are so far apart that they need not lead to one foot."""
    apart: Flags = (np.abs(a - b) / cell).max(axis=-1) > _BESIDE
    return apart
