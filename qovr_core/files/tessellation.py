"""How fine a grid must be for its triangles to stay within a distance of the surface."""

from __future__ import annotations

import math

import numpy as np

from qovr_core.arrays import Array
from qovr_core.checks import SAMPLES_RANGE
from qovr_core.errors import EvaluationError
from qovr_core.evaluation import parameters
from qovr_core.geometry import bernstein
from qovr_core.geometry.patch import Patch

_HALVINGS = 4
"""Second derivatives are bounded on 16 x 16 pieces, where their coefficients lie close to their values."""

_RATIOS = np.geomspace(1e-3, 1e3, 241)
"""Tried shapes of a cell, step in v over step in u."""

_MEASURED_ROWS = 64
"""Rows of cells measured at a time, so that a fine grid is never held twice."""


def samples_within(patch: Patch, tolerance: float) -> tuple[int, int]:
    """Return the fewest samples in u and v whose triangles are proven to stay within a distance of the surface.

    Over a cell of h x k a right triangle that interpolates S differs from it by at most
    (h^2 |S_uu| + 2 h k |S_uv| + k^2 |S_vv|) / 8 (Filip, Magedson, Markot 1986), each derivative being no larger
    than the coefficients of its piece.

    Raises
    ------
    EvaluationError : more samples would be needed than a grid may have
    """
    uu, uv, vv = _second_derivatives(patch)
    fewest, most = SAMPLES_RANGE
    bending = np.array([(uu + 2 * ratio * uv + ratio**2 * vv).max() for ratio in _RATIOS])
    with np.errstate(divide="ignore", over="ignore"):
        step_u = np.sqrt(8 * tolerance / bending)
        cells_u, cells_v = (np.clip(np.ceil(1 / step), fewest - 1, 1e9) for step in (step_u, step_u * _RATIOS))
    best = int(np.argmin(np.where(np.maximum(cells_u, cells_v) < most, cells_u * cells_v, np.inf)))
    n, m = int(cells_u[best]) + 1, int(cells_v[best]) + 1
    if max(n, m) > most:
        raise EvaluationError(
            f"a tolerance of {tolerance:g} needs more than {most} x {most} samples; "
            f"expected at least {_finest(uu, uv, vv):.2g}"
        )
    return n, m


def deviation(patch: Patch, points: Array) -> float:
    """Return the largest distance between surface and grid measured at the middle of every edge of a triangle.

    Parameters
    ----------
    patch : the surface
    points : (n, m, 3) vertices at even parameters, cells cut from [i, j] to [i + 1, j + 1]
    """
    n, m = points.shape[:2]
    u, v = parameters(2 * n - 1), parameters(2 * m - 1)
    largest = 0.0
    for start in range(0, n - 1, _MEASURED_ROWS):
        corners = points[start : start + _MEASURED_ROWS + 1]
        exact = patch.points(u[2 * start : 2 * (start + len(corners)) - 1], v)
        middles = (
            (exact[1::2, ::2], corners[:-1], corners[1:]),
            (exact[::2, 1::2], corners[:, :-1], corners[:, 1:]),
            (exact[1::2, 1::2], corners[:-1, :-1], corners[1:, 1:]),
        )
        for middle, a, b in middles:
            largest = max(largest, float(np.square(middle - (a + b) / 2).sum(axis=-1).max()))
    return math.sqrt(largest)


def _finest(uu: Array, uv: Array, vv: Array) -> float:
    """Return the tolerance that the largest grid is proven to reach."""
    step = 1 / (SAMPLES_RANGE[1] - 1)
    return float((uu + 2 * uv + vv).max() * step * step / 8)


def _second_derivatives(patch: Patch) -> tuple[Array, Array, Array]:
    """Return bounds of |S_uu|, |S_uv| and |S_vv| on every piece."""
    c = patch.coefficients[0, 0]
    along_u, along_v = bernstein.derivative(c, 0), bernstein.derivative(c, 1)
    seconds = (bernstein.derivative(along_u, 0), bernstein.derivative(along_u, 1), bernstein.derivative(along_v, 1))
    uu, uv, vv = (np.linalg.norm(_pieces(second), axis=-1).max(axis=(1, 2)) for second in seconds)
    return uu, uv, vv


def _pieces(coefficients: Array) -> Array:
    """Return the coefficients of all pieces, (k, a, b, 3)."""
    pieces = coefficients[None]
    for axis in (1, 2):
        halves = bernstein.halving(coefficients.shape[axis - 1] - 1)
        for _ in range(_HALVINGS):
            cut = [np.moveaxis(np.tensordot(half, pieces, axes=(1, axis)), 0, axis) for half in halves]
            pieces = np.concatenate(cut)
    return pieces
