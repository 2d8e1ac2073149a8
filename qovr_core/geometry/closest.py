"""The point of a surface closest to each of many points: seeds from a grid, then Newton's method on all at once."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from qovr_core.arrays import Array, Flags, Indices, read_only
from qovr_core.geometry.differential import ParametricSurface
from qovr_core.geometry.rounding import in_own_unit, largest

_SEED_SAMPLES = 65
"""Samples each way from which the search starts: a polynomial of degree 6 turns many times less often."""

_CELL = 1 / (_SEED_SAMPLES - 1)

_BESIDE = 1.5 * _CELL
"""Parameters no further apart than this in u and v are taken to lead to one foot."""

_NEIGHBOURS = 16
"""Nearest samples asked for: enough that the other sheets which pass as near as the first show among them."""

_LAST_STEP = 1e-8
"""A step shorter than this part of the surface's size leaves an error of about its square, which is rounding."""

_MOST_STEPS = 60
"""Newton's method needs about five steps; where the point is a centre of curvature it gains a third at each."""

_MOST_HALVINGS = 40
"""A step halved more often than this is rounding: the distance cannot be made smaller."""

_LEAST_CURVATURE = 1e-6
"""The Hessian's smaller eigenvalue is raised to this part of |S_u|^2 + |S_v|^2, where the distance is not convex."""

_LEAST_SCALE = 1e-100
"""|S_u|^2 + |S_v|^2 below this, of a surface of size 1, is rounding or a point; above it no product overflows."""

_LEAST_OF_LARGEST = 1e-12
"""And to this part of the larger eigenvalue, below which the smaller one is rounding."""


@dataclass(frozen=True)
class Closest:
    """The closest points of a surface, one for each of k given points; every array float64 and read-only.

    Parameters
    ----------
    u, v : (k,) parameters of the foot, in [0, 1]
    points : (k, 3) the foot
    distance : (k,) distance of the given point from the foot
    """

    u: Array
    v: Array
    points: Array
    distance: Array


def closest_points(surface: ParametricSurface, points: Array) -> Closest:
    """Return the points of a surface over [0, 1] x [0, 1] closest to given points.

    Every foot is a local minimum of the distance, exact to rounding, inside or on the border. It is the global
    minimum wherever the nearest of 65 x 65 samples tell which sheets of the surface are near; folds narrower than
    the samples can hide a nearer point.

    Parameters
    ----------
    surface : any parametric surface; it may be flat, folded or drawn together into a line or a point
    points : (k, 3), finite

    Raises
    ------
    ValueError : the points have another shape
    """
    from scipy.spatial import cKDTree

    targets = np.asarray(points, dtype=np.float64)
    if targets.ndim != 2 or targets.shape[1] != 3:
        raise ValueError(f"points have shape {targets.shape}; expected (k, 3)")
    surface, unit = in_own_unit(surface, beside=largest(targets))
    targets = targets / unit
    seeds = _seed_grid(surface)
    distance, nearest = cKDTree(seeds.points).query(targets, _NEIGHBOURS)
    best = _descend(surface, seeds.at[nearest[:, 0]], targets, seeds.last_step)
    candidates = _candidates(seeds, targets, distance, nearest, best)
    while candidates.target.size:
        rows, first = np.unique(candidates.target, return_index=True)
        start = seeds.at[candidates.sample[first]]
        other = _descend(surface, start, targets[rows], seeds.last_step)
        best.improve(rows, other)
        place = np.searchsorted(rows, candidates.target)
        at = seeds.at[candidates.sample]
        is_new = _apart(at, start[place]) & _apart(at, other.at[place])
        candidates = candidates.of(is_new & (candidates.promise < best.distance[candidates.target]))
    u, v = best.at.T.copy()
    return Closest(*map(read_only, (u, v, best.feet * unit, best.distance * unit)))


@dataclass(frozen=True)
class _Seeds:
    """Samples of the surface: parameters (q, 2), points (q, 3), tangents (q, 2, 3), the length of a last step."""

    at: Array
    points: Array
    tangents: Array
    last_step: float


def _seed_grid(surface: ParametricSurface) -> _Seeds:
    parameters = np.linspace(0.0, 1.0, _SEED_SAMPLES)
    at = np.stack(np.meshgrid(parameters, parameters, indexing="ij"), axis=-1).reshape(-1, 2)
    points, su, sv = (
        surface.derivative(parameters, parameters, *order).reshape(-1, 3) for order in ((0, 0), (1, 0), (0, 1))
    )
    with np.errstate(over="ignore"):  # so large a surface is searched again in other units
        size = float(np.linalg.norm(np.ptp(points, axis=0)))
    return _Seeds(at, points, np.stack([su, sv], axis=1), _LAST_STEP * size)


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


def _candidates(seeds: _Seeds, targets: Array, distance: Array, nearest: Indices, best: _Feet) -> _Candidates:
    """Return the nearest samples that do not lie beside the foot already found, and may lead to a nearer one."""
    target, rank = np.nonzero(_apart(seeds.at[nearest], best.at[:, None]))
    sample, far = nearest[target, rank], distance[target, rank]
    direction = (seeds.points[sample] - targets[target]) / np.where(far > 0, far, 1.0)[:, None]
    gain = np.abs(np.einsum("kpd,kd->kp", seeds.tangents[sample], direction)).sum(axis=1) * (_CELL / 2)
    candidates = _Candidates(target, sample, far - gain)
    candidates = candidates.of(candidates.promise < best.distance[target])
    return candidates.of(np.lexsort((candidates.promise, candidates.target)))


def _apart(a: Array, b: Array) -> Flags:
    """Return which parameters, (..., 2), are so far apart that they need not lead to one foot."""
    apart: Flags = np.abs(a - b).max(axis=-1) > _BESIDE
    return apart


@dataclass(frozen=True)
class _Feet:
    """Where searches have ended: parameters (k, 2), points (k, 3), distances (k,)."""

    at: Array
    feet: Array
    distance: Array

    def improve(self, rows: Indices, other: _Feet) -> None:
        """Take the others' rows over where they are nearer."""
        nearer = other.distance < self.distance[rows]
        for mine, theirs in zip(vars(self).values(), vars(other).values(), strict=True):
            mine[rows[nearer]] = theirs[nearer]


def _descend(surface: ParametricSurface, start: Array, targets: Array, last_step: float) -> _Feet:
    """Return where the distance from the targets has a local minimum, searched from parameters (k, 2)."""
    at = start.copy()
    feet = surface.derivative_at(at[:, 0], at[:, 1], 0, 0).copy()
    active = np.arange(len(at))
    for _ in range(_MOST_STEPS):
        step, length = _newton_steps(surface, at[active], feet[active] - targets[active])
        last = length <= last_step
        at[active[last]] += step[last]
        active, step = active[~last], step[~last]
        if active.size == 0:
            break
        active = active[_backtrack(surface, at, feet, targets, (active, step))]
    feet = surface.derivative_at(at[:, 0], at[:, 1], 0, 0).copy()
    return _Feet(at, feet, np.linalg.norm(feet - targets, axis=1))


def _newton_steps(surface: ParametricSurface, at: Array, residual: Array) -> tuple[Array, Array]:
    """Return the steps (k, 2) of Newton's method that stay in the domain, and their lengths in space (k,)."""
    orders = ((1, 0), (0, 1), (2, 0), (1, 1), (0, 2))
    su, sv, suu, suv, svv = (surface.derivative_at(at[:, 0], at[:, 1], *order) for order in orders)
    dot = "kd,kd->k"
    tangents = np.stack([np.einsum(dot, su, su), np.einsum(dot, sv, sv)], axis=1)
    gradient = np.stack([np.einsum(dot, residual, tangent) for tangent in (su, sv)], axis=1)
    diagonal = tangents + np.stack([np.einsum(dot, residual, second) for second in (suu, svv)], axis=1)
    mixed = np.einsum(dot, su, sv) + np.einsum(dot, residual, suv)
    scale = tangents.sum(axis=1, keepdims=True)
    scale = np.maximum(scale, _LEAST_SCALE)
    step = _bounded_steps(at, gradient / scale, diagonal / scale, mixed / scale[:, 0])
    return step, (np.abs(step) * np.sqrt(tangents)).sum(axis=1)


def _bounded_steps(at: Array, gradient: Array, diagonal: Array, mixed: Array) -> Array:
    """Return -H^-1 gradient, (k, 2), for a Hessian made positive definite, with no step across the border.

    A parameter that stands on the border and would leave it is held there; the other then moves alone.
    """
    held = _leaves(at, -gradient)
    gradient = np.where(held, 0.0, gradient)
    mixed = np.where(held.any(axis=1), 0.0, mixed)
    middle, reach = diagonal.mean(axis=1), np.hypot(np.diff(diagonal, axis=1)[:, 0] / 2, mixed)
    least = np.maximum(_LEAST_CURVATURE, _LEAST_OF_LARGEST * (np.abs(middle) + reach))
    diagonal = diagonal + np.maximum(least - (middle - reach), 0.0)[:, None]
    determinant = diagonal[:, 0] * diagonal[:, 1] - mixed**2
    step = (mixed[:, None] * gradient[:, ::-1] - diagonal[:, ::-1] * gradient) / determinant[:, None]
    alone = _leaves(at, step).any(axis=1)
    step[alone] = (-gradient / diagonal)[alone]
    return np.clip(at + step, 0.0, 1.0) - at


def _leaves(at: Array, direction: Array) -> Flags:
    """Return which parameters stand on the border of [0, 1] and would move out of it."""
    leaves: Flags = ((at <= 0.0) & (direction < 0)) | ((at >= 1.0) & (direction > 0))
    return leaves


def _backtrack(
    surface: ParametricSurface, at: Array, feet: Array, targets: Array, steps: tuple[Indices, Array]
) -> Flags:
    """Move some parameters by their steps, halved until the distance falls; return which of them moved."""
    active, step = steps
    before = np.linalg.norm(feet[active] - targets[active], axis=1)
    waiting = np.arange(len(active))
    for _ in range(_MOST_HALVINGS):
        rows = active[waiting]
        trial = np.clip(at[rows] + step[waiting], 0.0, 1.0)
        reached = surface.derivative_at(trial[:, 0], trial[:, 1], 0, 0)
        nearer = np.linalg.norm(reached - targets[rows], axis=1) < before[waiting]
        at[rows[nearer]], feet[rows[nearer]] = trial[nearer], reached[nearer]
        waiting = waiting[~nearer]
        if waiting.size == 0:
            break
        step[waiting] /= 2
    moved = np.ones(len(active), dtype=np.bool_)
    moved[waiting] = False
    return moved
