"""How fine a grid must be for its triangles to stay within a distance of the surface."""

from __future__ import annotations

import math

import numpy as np

from qovr_core.arrays import Array, Indices
from qovr_core.checks import SAMPLES_RANGE
from qovr_core.errors import EvaluationError
from qovr_core.files.mesh_grid import MeshGrid
from qovr_core.geometry import bernstein
from qovr_core.geometry.patch import Patch

_HALVINGS = 4
"""Second derivatives are bounded on 16 x 16 pieces of a window, where coefficients lie close to values..."""

_MOST_PIECES = 1 << 15
"""...and of a large net, whose windows are pieces already, on fewer, so that there are not more than so many."""

_FEWEST_HALVINGS = 2

_TOGETHER = 64
"""Windows that are cut into pieces together."""

_RATIOS = np.geomspace(1e-3, 1e3, 241)
"""Tried shapes of a cell, step in v over step in u."""

_SHARES = np.linspace(0.1, 0.9, 17)
"""Tried parts of the tolerance that the steps along u of a net take; those along v take the rest."""

_MEASURED_ROWS = 64
"""Rows of cells measured at a time, so that a fine grid is never held twice."""

_MOST_CELLS = SAMPLES_RANGE[1] - 1
"""Intervals between the most samples that a grid may have."""

_SAFELY = 1.1
"""By so much more than what a net is reckoned to reach is proposed: windows have whole intervals."""

Bounds = tuple[Array, Array, Array]
"""Bounds of |S_uu|, |S_uv| and |S_vv| by each window's own parameters on all its pieces, (m, n, pieces) each."""


def intervals_within(patch: Patch, tolerance: float) -> tuple[Indices, Indices]:
    """Return the fewest intervals whose triangles are proven to stay within a distance of the surface.

    Over a cell of h x k a right triangle that interpolates S differs from it by at most
    (h^2 |S_uu| + 2 h k |S_uv| + k^2 |S_vv|) / 8 (Filip, Magedson, Markot 1986), each derivative being no larger
    than the coefficients of its piece.

    Returns
    -------
    those of every window along u, (n,), and along v, (m,)

    Raises
    ------
    EvaluationError : more samples would be needed than a grid may have
    """
    bounds = _second_derivatives(patch)
    return (_of_one_window if patch.windows == (1, 1) else _of_net)(bounds, tolerance)


def deviation(patch: Patch, grid: MeshGrid, points: Array) -> float:
    """Return the largest distance between surface and grid measured at the middle of every edge of a triangle.

    Parameters
    ----------
    patch : the surface
    points : (n, m, 3) vertices of the grid, cells cut from [i, j] to [i + 1, j + 1]
    """
    fine = grid.v.halved
    largest = 0.0
    for b in range(len(grid.u.intervals)):
        column, of_column, u = grid.column(patch, b), points[grid.u.samples(b)], grid.u.window(b).halved.located
        for start in range(0, len(of_column) - 1, _MEASURED_ROWS):
            corners = of_column[start : start + _MEASURED_ROWS + 1]
            exact = column.points(u[2 * start : 2 * (start + len(corners)) - 1], fine.located)
            for a in range(len(grid.v.intervals)):
                largest = max(largest, _squared_deviation(exact[:, fine.samples(a)], corners[:, grid.v.samples(a)]))
    return math.sqrt(largest)


def _squared_deviation(exact: Array, corners: Array) -> float:
    """Return the square of what ``deviation`` says, for cells of one window and points twice as dense as corners."""
    middles = (
        (exact[1::2, ::2], corners[:-1], corners[1:]),
        (exact[::2, 1::2], corners[:, :-1], corners[:, 1:]),
        (exact[1::2, 1::2], corners[:-1, :-1], corners[1:, 1:]),
    )
    return max(float(np.square(middle - (one + other) / 2).sum(axis=-1).max()) for middle, one, other in middles)


def _of_one_window(bounds: Bounds, tolerance: float) -> tuple[Indices, Indices]:
    uu, uv, vv = (bound[0, 0] for bound in bounds)
    bending = np.array([(uu + 2 * ratio * uv + ratio**2 * vv).max() for ratio in _RATIOS])
    with np.errstate(divide="ignore", over="ignore"):
        step_u = np.sqrt(8 * tolerance / bending)
        cells_u, cells_v = (np.clip(np.ceil(1 / step), 1, 1e9) for step in (step_u, step_u * _RATIOS))
    best = int(np.argmin(np.where(np.maximum(cells_u, cells_v) <= _MOST_CELLS, cells_u * cells_v, np.inf)))
    n, m = int(cells_u[best]), int(cells_v[best])
    if max(n, m) > _MOST_CELLS:
        step = 1 / _MOST_CELLS
        raise _too_fine(tolerance, float((uu + 2 * uv + vv).max() * step * step / 8))
    return np.array([n]), np.array([m])


def _of_net(bounds: Bounds, tolerance: float) -> tuple[Indices, Indices]:
    """Return intervals of a net: those of a column of windows as its most curved window demands, rows likewise.

    With 2 h k |S_uv| <= (s h^2 + k^2 / s) |S_uv| the two directions part, each taking a share of the tolerance; what
    both leave unused is given back to all steps alike.
    """
    uu, uv, vv = bounds
    least, best = np.inf, (np.ones(uu.shape[1]), np.ones(uu.shape[0]))
    for slope in _RATIOS[::4]:
        along_u, along_v = (uu + slope * uv).max(axis=(0, 2)), (vv + uv / slope).max(axis=(1, 2))
        for share in _SHARES:
            cells = np.sqrt(along_u / (8 * tolerance * share)), np.sqrt(along_v / (8 * tolerance * (1 - share)))
            count = float(np.prod([np.maximum(each, 1).sum() for each in cells]))
            if count < least:
                least, best = count, cells
    h, k = (1 / np.maximum(cells, 1) for cells in best)
    h, k = h[None, :, None], k[:, None, None]
    used = float((h * h * uu + 2 * h * k * uv + k * k * vv).max() / (8 * tolerance))
    n, m = (np.maximum(np.ceil(np.sqrt(used) * cells), 1) for cells in best)
    if max(n.sum(), m.sum()) > _MOST_CELLS:
        over = max(each.sum() / (_MOST_CELLS - len(each)) for each in (n, m))
        raise _too_fine(tolerance, _SAFELY * over**2 * tolerance)
    return n.astype(np.intp), m.astype(np.intp)


def _too_fine(tolerance: float, reached: float) -> EvaluationError:
    """Return an error that says which tolerance the largest grid is proven to reach."""
    most = SAMPLES_RANGE[1]
    return EvaluationError(
        f"a tolerance of {tolerance:g} needs more than {most} x {most} samples; expected at least {reached:.2g}"
    )


def _second_derivatives(patch: Patch) -> Bounds:
    m, n = patch.windows
    windows, halvings = patch.coefficients.reshape(m * n, *patch.coefficients.shape[2:]), _HALVINGS
    while m * n * 4**halvings > _MOST_PIECES and halvings > _FEWEST_HALVINGS:
        halvings -= 1
    parts = [_of_windows(windows[k : k + _TOGETHER], halvings) for k in range(0, m * n, _TOGETHER)]
    uu, uv, vv = (np.concatenate(part).reshape(m, n, -1) for part in zip(*parts, strict=True))
    return uu, uv, vv


def _of_windows(c: Array, halvings: int) -> tuple[Array, ...]:
    """Return bounds of the second derivatives on the pieces of windows (k, 7, 7, 3), (k, pieces) each."""
    along_u, along_v = bernstein.derivative(c, 1), bernstein.derivative(c, 2)
    seconds = (bernstein.derivative(along_u, 1), bernstein.derivative(along_u, 2), bernstein.derivative(along_v, 2))
    pieces = (_pieces(second, halvings) for second in seconds)
    return tuple(np.linalg.norm(each, axis=-1).max(axis=(1, 2)).reshape(-1, len(c)).T for each in pieces)


def _pieces(coefficients: Array, halvings: int) -> Array:
    """Return the coefficients of all pieces of windows (k, a, b, 3), (pieces k, a, b, 3)."""
    pieces = coefficients
    for axis in (1, 2):
        halves = bernstein.halving(coefficients.shape[axis] - 1)
        for _ in range(halvings):
            cut = [np.moveaxis(np.tensordot(half, pieces, axes=(1, axis)), 0, axis) for half in halves]
            pieces = np.concatenate(cut)
    return pieces
