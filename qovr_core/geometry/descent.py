"""Newton's method for the distance of many points from a surface, at once."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from qovr_core.arrays import Array, Flags, Indices
from qovr_core.geometry.differential import ParametricSurface

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
class Feet:
    """Where searches have ended: parameters (k, 2), points (k, 3), distances (k,)."""

    at: Array
    feet: Array
    distance: Array

    def improve(self, rows: Indices, other: Feet) -> None:
        """Take the others' rows over where they are nearer."""
        nearer = other.distance < self.distance[rows]
        for mine, theirs in zip(vars(self).values(), vars(other).values(), strict=True):
            mine[rows[nearer]] = theirs[nearer]


def descend(surface: ParametricSurface, start: Array, targets: Array, last_step: float) -> Feet:
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
    return Feet(at, feet, np.linalg.norm(feet - targets, axis=1))


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
    step = _bounded_steps(at, gradient / scale, diagonal / scale, mixed / scale[:, 0], np.array(surface.domain).T)
    # Where a tangent vanishes, a long step is short in space by its first derivative alone.
    bends = np.sqrt(np.einsum(dot, suu, suu) + 2 * np.einsum(dot, suv, suv) + np.einsum(dot, svv, svv))
    length = (np.abs(step) * np.sqrt(tangents)).sum(axis=1) + (step**2).sum(axis=1) * bends / 2
    return step, length


def _bounded_steps(at: Array, gradient: Array, diagonal: Array, mixed: Array, bounds: Array) -> Array:
    """Return -H^-1 gradient, (k, 2), for a Hessian made positive definite, with no step across the border.

    A parameter that stands on the border and would leave it is held there; the other then moves alone.
    """
    held = _leaves(at, -gradient, bounds)
    gradient = np.where(held, 0.0, gradient)
    mixed = np.where(held.any(axis=1), 0.0, mixed)
    middle, reach = diagonal.mean(axis=1), np.hypot(np.diff(diagonal, axis=1)[:, 0] / 2, mixed)
    least = np.maximum(_LEAST_CURVATURE, _LEAST_OF_LARGEST * (np.abs(middle) + reach))
    diagonal = diagonal + np.maximum(least - (middle - reach), 0.0)[:, None]
    determinant = diagonal[:, 0] * diagonal[:, 1] - mixed**2
    step = (mixed[:, None] * gradient[:, ::-1] - diagonal[:, ::-1] * gradient) / determinant[:, None]
    alone = _leaves(at, step, bounds).any(axis=1)
    step[alone] = (-gradient / diagonal)[alone]
    return np.clip(at + step, *bounds) - at


def _leaves(at: Array, direction: Array, bounds: Array) -> Flags:
    """Return which parameters stand on the border and would move out of it."""
    low, high = bounds
    leaves: Flags = ((at <= low) & (direction < 0)) | ((at >= high) & (direction > 0))
    return leaves


def _backtrack(
    surface: ParametricSurface, at: Array, feet: Array, targets: Array, steps: tuple[Indices, Array]
) -> Flags:
    """Move some parameters by their steps, halved until the distance falls; return which of them moved."""
    active, step = steps
    before = np.linalg.norm(feet[active] - targets[active], axis=1)
    waiting, bounds = np.arange(len(active)), np.array(surface.domain).T
    for _ in range(_MOST_HALVINGS):
        rows = active[waiting]
        trial = np.clip(at[rows] + step[waiting], *bounds)
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
