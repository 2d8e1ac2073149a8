"""The box of evenly spaced samples of patches: branch and bound over the grid, of which few samples are ever computed.

The extremes of all samples are wanted, not those of the surface, and on an oblique ridge the largest sample may lie far
from the crest's highest place: Newton's method from a critical point would find the wrong one. So the grid is cut into
cells that begin and end at samples. The Bernstein coefficients of the patch over a cell bound what it can hold, their
corners are samples it does hold, and a cell that cannot hold more than is known is dropped: of a net of many windows,
nearly all of these at once.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from qovr_core.arrays import Array, Indices
from qovr_core.geometry import bernstein, grid, locate, scattered
from qovr_core.geometry.sample_cells import PARTS, Cells, cells_of, restrictions_to_parts
from qovr_core.geometry.window_bounds import window_bounds

_FULL_BELOW = 400 * 400
"""Samples of a grid; of fewer, all are computed in less time than the cells take."""

_SLACK = 4 * float(np.finfo(np.float64).eps)
"""A cell is dropped that exceeds a sample that is known by no more than this part of the largest coefficient: what
the restriction to a cell rounds."""

_FIRST_AT_ONCE = 64
"""Functions over whole windows that are searched together, the most promising first: what they find may rule the others
out. Of those that it does not, four times as many are searched next."""

_MOST_AT_ONCE = 1024
"""The most of them; their cells take some ten megabytes."""

_SAMPLED_AT_ONCE = 128
"""Cells whose samples are computed together, the most promising first: what they hold may rule the others out."""

_BLOCK_MULTIPLICATIONS = 2**17
"""OpenBLAS leaves products of this size in the thread that asks for them (see ``grid.BLOCK_BYTES``)."""


@dataclass(frozen=True, eq=False)
class _Pieces:
    """Functions over cells: coefficients (k, a, b), which function (k,), and where the cell begins (k, 3): in which
    window, and at which of its samples."""

    coefficients: Array
    owner: Indices
    starts: Indices

    def at(self, rows: Indices) -> _Pieces:
        return _Pieces(self.coefficients[rows], self.owner[rows], self.starts[rows])


@dataclass(frozen=True, eq=False)
class _Best:
    """The largest sample found of each function, (f,), where, (f, 3), and what a larger one must exceed it by, (f,).

    ``last`` is the last sample of every window along u and v, (w, 2): on a joint that of the window which begins there.
    """

    values: Array
    places: Indices
    slack: Array
    last: Indices

    def offer(self, values: Array, owner: Indices, starts: Indices, steps: Indices) -> None:
        """Take larger ones: values (k, p, q) at ``starts`` (k, 3) + multiples of ``steps``, (2,) or (k, 2)."""
        is_beyond = starts[:, 1:] + (np.array(values.shape[1:]) - 1) * steps > self.last[starts[:, 0]]
        if is_beyond.any():
            values = values.copy()
            values[is_beyond[:, 0], -1] = values[is_beyond[:, 1], :, -1] = -np.inf
        largest, known = values.max(axis=(1, 2)), self.values.copy()
        np.maximum.at(self.values, owner, largest)
        for function in np.flatnonzero(self.values > known):
            row = np.flatnonzero((owner == function) & (largest == self.values[function]))[0]
            at = np.unravel_index(values[row].argmax(), values.shape[1:])
            self.places[function] = starts[row]
            self.places[function, 1:] += np.array(at) * (steps[row] if steps.ndim > 1 else steps)

    def exceeded_by(self, bounds: Array, owner: Indices) -> Indices:
        """Return the rows of bounds (k,) above what is known."""
        return np.flatnonzero(bounds > (self.values + self.slack)[owner])


def sampled_box(
    coefficients: Array, intervals_u: Indices, intervals_v: Indices, bounds: Callable[[], Array] | None = None
) -> Array:
    """Return the box of the evenly spaced samples of Bernstein patches, the joints once.

    Every bound is the coordinate of a sample, within 8 eps of the axis's largest coefficient of the largest (smallest).

    Parameters
    ----------
    coefficients : (m, n, a, b, d), finite
    intervals_u, intervals_v : (n,) and (m,) intervals between the samples of each, 1 or more
    bounds : gives the windows' ``window_bounds``, (2, 2 d, m, n), where these are known

    Returns
    -------
    (d, 2) float64, columns min and max
    """
    *windows, a, b, d = coefficients.shape
    if (intervals_u.sum() + 1) * (intervals_v.sum() + 1) < _FULL_BELOW:
        along_u, along_v = (
            locate.even(intervals).by_window(size - 1, 0) for intervals, size in ((intervals_u, a), (intervals_v, b))
        )
        return grid.box(coefficients, along_u, along_v)
    patches = coefficients.reshape(-1, a, b, d)
    known = bounds().reshape(2, 2 * d, -1) if bounds else window_bounds(patches)
    counts, last = _sample_counts(intervals_u, intervals_v)
    best = _extremes(patches, counts, last, known)
    window, places = best.places[:, 0], best.places[:, 1:]
    at = places / counts[window]
    basis_u, basis_v = (bernstein.basis(size - 1, at[:, k]) for k, size in enumerate((a, b)))
    values = scattered.evaluate_pieces(coefficients, np.divmod(window, windows[1]), basis_u, basis_v)
    return np.diagonal(values.reshape(2, d, d), axis1=1, axis2=2).T.copy()


def _sample_counts(intervals_u: Indices, intervals_v: Indices) -> tuple[Indices, Indices]:
    """Return the intervals of every window along u and v, (m n, 2), and the last sample that is its own, likewise."""
    counts = np.empty((len(intervals_v), len(intervals_u), 2), dtype=np.intp)
    counts[..., 0], counts[..., 1] = intervals_u, intervals_v[:, None]
    last = counts - 1
    last[:, -1, 0] += 1
    last[-1, :, 1] += 1
    return counts.reshape(-1, 2), last.reshape(-1, 2)


@np.errstate(under="ignore")  # what underflows is nothing
def _extremes(windows: Array, counts: Indices, last: Indices, bounds: Array) -> _Best:
    """Return the least sample of every axis, then the largest ones, of windows (w, a, b, d) with ``counts`` (w, 2).

    Of what was known before only the bounds are, which are the same however they came about; so is what is found.
    """
    limits, firsts = bounds
    w, _, _, d = windows.shape
    largest = np.abs(limits).max(axis=1).reshape(2, d).max(axis=0)
    best = _Best(firsts.max(axis=1), np.zeros((2 * d, 3), dtype=np.intp), _SLACK * np.tile(largest, 2), last)
    best.places[:, 0] = firsts.argmax(axis=1)
    left, limits = np.flatnonzero(limits > (best.values + best.slack)[:, None]), limits.ravel()
    together = _FIRST_AT_ONCE
    while len(left):
        promise = best.values[left // w] - limits[left]
        order = np.argpartition(promise, together) if len(left) > together else np.arange(len(left))
        chosen, left = left[order[:together]], left[order[together:]]
        owner, window = np.divmod(chosen, w)
        functions = windows[window, :, :, owner % d] * np.where(owner < d, -1.0, 1.0)[:, None, None]
        starts = np.stack([window, 0 * window, 0 * window], axis=1)
        _search_alike(_Pieces(functions, owner, starts), limits[chosen], counts[window], best)
        left = left[best.exceeded_by(limits[left], left // w)]
        together = min(4 * together, _MOST_AT_ONCE)
    return best


def _search_alike(pieces: _Pieces, bounds: Array, intervals: Indices, best: _Best) -> None:
    """Look for larger samples in functions over whole windows, those with equal intervals (k, 2) together."""
    while len(bounds):
        is_alike = (intervals == intervals[0]).all(axis=1)
        alike, others = np.flatnonzero(is_alike), np.flatnonzero(~is_alike)
        _search(pieces.at(alike), bounds[alike], intervals[0].tolist(), best)
        pieces, bounds, intervals = pieces.at(others), bounds[others], intervals[others]


def _search(pieces: _Pieces, bounds: Array, intervals: list[int], best: _Best) -> None:
    """Look for larger samples in functions over whole windows, (k,) bounds, with so many intervals along u and v."""
    along = [cells_of(size - 1, count) for size, count in zip(pieces.coefficients.shape[1:], intervals, strict=True)]
    pieces, bounds = _first_cells(pieces, bounds, along, best)
    cuts = [cells.cuts for cells in along]
    while max(cuts) > 0 and len(bounds):
        is_cut = [cut == max(cuts) for cut in cuts]
        cuts = [cut - is_it for cut, is_it in zip(cuts, is_cut, strict=True)]
        steps = np.array([cells.leaf * PARTS**cut for cells, cut in zip(along, cuts, strict=True)])
        pieces, bounds = _cut(pieces, is_cut, steps, best)
    _sample(pieces, bounds, [cells.leaf for cells in along], best)


def _first_cells(whole: _Pieces, limits: Array, along: list[Cells], best: _Best) -> tuple[_Pieces, Array]:
    """Return functions over the first cells that can hold more than is known, and their bounds.

    The functions come with their bounds over whole windows.
    """
    some = whole.at(best.exceeded_by(limits, whole.owner))
    in_u, in_v = (cells.restrictions for cells in along)
    steps = np.array([cells.leaf * PARTS**cells.cuts for cells in along])
    starts = np.stack(np.meshgrid(*(cells.starts for cells in along), indexing="ij"), axis=-1).reshape(-1, 1, 2)
    cells = in_u[:, None, None] @ some.coefficients @ in_v.transpose(0, 2, 1)[:, None]
    at = np.repeat(some.starts[None], len(starts), axis=0)
    at[..., 1:] += starts
    owner = np.repeat(some.owner[None], len(starts), axis=0).ravel()
    pieces = _Pieces(cells.reshape(-1, *some.coefficients.shape[1:]), owner, at.reshape(-1, 3))
    best.offer(_corners(pieces.coefficients), owner, pieces.starts, steps)
    bounds = pieces.coefficients.max(axis=(1, 2))
    rows = best.exceeded_by(bounds, owner)
    return pieces.at(rows), bounds[rows]


def _corners(coefficients: Array) -> Array:
    """Return the values (k, 2, 2) that pieces (k, a, b) have at their corners."""
    return coefficients[:, :: coefficients.shape[1] - 1, :: coefficients.shape[2] - 1]


def _cut(pieces: _Pieces, is_cut: list[bool], steps: Indices, best: _Best) -> tuple[_Pieces, Array]:
    """Cut pieces along u, along v, or both; return the parts that can hold more than is known, and their bounds."""
    k, a, b = pieces.coefficients.shape
    p, q = (PARTS if it else 1 for it in is_cut)
    parts = _tensor_product(restrictions_to_parts(a - 1, p), pieces.coefficients, restrictions_to_parts(b - 1, q))
    parts = parts.reshape(k, p, a, q, b).transpose(0, 1, 3, 2, 4).reshape(-1, a, b)
    offsets = np.stack(np.meshgrid(np.arange(p), np.arange(q), indexing="ij"), axis=-1) * steps
    owner = np.repeat(pieces.owner, p * q)
    starts = np.repeat(pieces.starts, p * q, axis=0)
    starts.reshape(k, p * q, 3)[..., 1:] += offsets.reshape(-1, 2)
    best.offer(_corners(parts), owner, starts, steps)
    bounds = parts.max(axis=(1, 2))
    rows = best.exceeded_by(bounds, owner)
    return _Pieces(parts, owner, starts).at(rows), bounds[rows]


def _sample(pieces: _Pieces, bounds: Array, leaf: list[int], best: _Best) -> None:
    """Compute the samples of the pieces that can hold more than is known."""
    bases = (
        bernstein.basis(size - 1, np.arange(count + 1) / count)
        for size, count in zip(pieces.coefficients.shape[1:], leaf, strict=True)
    )
    basis_u, basis_v = bases
    order = np.argsort(best.values[pieces.owner] - bounds, kind="stable")
    for k in range(0, len(order), _SAMPLED_AT_ONCE):
        rows = order[k : k + _SAMPLED_AT_ONCE]
        some = pieces.at(rows[best.exceeded_by(bounds[rows], pieces.owner[rows])])
        if len(some.owner):
            values = _tensor_product(basis_u, some.coefficients, basis_v)
            best.offer(values, some.owner, some.starts, np.ones(2, dtype=np.intp))


def _tensor_product(left: Array, pieces: Array, right: Array) -> Array:
    """Return left (p, a) times each of pieces (k, a, b) times the transpose of right (q, b), (k, p, q)."""
    k, a, b = pieces.shape
    along_v = _product(pieces.reshape(k * a, b), right).reshape(k, a, -1).transpose(0, 2, 1)
    along_both = _product(along_v.reshape(-1, a), left).reshape(k, -1, len(left))
    return along_both.transpose(0, 2, 1)


def _product(rows: Array, matrix: Array) -> Array:
    """Return rows (k, b) times the transpose of a matrix (q, b), in products small enough for one thread."""
    result = np.empty((len(rows), len(matrix)))
    step = max(1, _BLOCK_MULTIPLICATIONS // matrix.size)
    for k in range(0, len(rows), step):
        np.matmul(rows[k : k + step], matrix.T, out=result[k : k + step])
    return result
