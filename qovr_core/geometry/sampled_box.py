"""The box of a patch's evenly spaced samples: branch and bound over the grid, of which few samples are ever computed.

The extremes of all samples are wanted, not those of the surface, and on an oblique ridge the largest sample may lie far
from the crest's highest place: Newton's method from a critical point would find the wrong one. So the grid is cut into
cells that begin and end at samples. The Bernstein coefficients of the patch over a cell bound what it can hold, their
corners are samples it does hold, and a cell that cannot hold more than is known is dropped.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from qovr_core.arrays import Array, Indices, read_only
from qovr_core.geometry import bernstein, grid

_FULL_BELOW = 400 * 400
"""Samples of a grid; of fewer, all are computed in less time than the cells take."""

_PARTS = 4
"""Cells along each direction to begin with, and parts of a cell that is cut."""

_LARGEST_LEAF = 16
"""Intervals of a cell along one direction up to which its samples cost no more than to cut it further."""

SLACK = 4 * float(np.finfo(np.float64).eps)
"""A cell is dropped that exceeds a sample that is known by no more than this part of the largest coefficient: what
the restriction to a cell rounds."""

_SAMPLED_AT_ONCE = 128
"""Cells whose samples are computed together, the most promising first: what they hold may rule the others out."""

_BLOCK_MULTIPLICATIONS = 2**17
"""OpenBLAS leaves products of this size in the thread that asks for them (see ``grid.BLOCK_BYTES``)."""


@dataclass(frozen=True, eq=False)
class _Cells:
    """Cells of equal size along one direction, which overlap where they do not divide the samples.

    Parameters
    ----------
    restrictions : (k, a, a), the matrices that restrict Bernstein coefficients to each cell
    starts : (k,), the first sample of each
    leaf : intervals between samples of the smallest cells
    cuts : how often a cell is cut until it is one of those
    """

    restrictions: Array
    starts: Indices
    leaf: int
    cuts: int


@dataclass(frozen=True, eq=False)
class _Pieces:
    """Functions over cells: coefficients (k, a, b), which function (k,), and the cell's first sample (k, 2)."""

    coefficients: Array
    owner: Indices
    starts: Indices

    def at(self, rows: Indices) -> _Pieces:
        return _Pieces(self.coefficients[rows], self.owner[rows], self.starts[rows])


@dataclass(frozen=True, eq=False)
class _Best:
    """The largest sample found of each function, (f,), where, (f, 2), and what a larger one must exceed it by, (f,)."""

    values: Array
    places: Indices
    slack: Array

    def offer(self, values: Array, owner: Indices, starts: Indices, steps: Indices) -> None:
        """Take larger ones: values (k, p, q) at samples ``starts`` (k, 2) + multiples of ``steps`` (2,)."""
        largest, known = values.max(axis=(1, 2)), self.values.copy()
        np.maximum.at(self.values, owner, largest)
        for function in np.flatnonzero(self.values > known):
            row = np.flatnonzero((owner == function) & (largest == self.values[function]))[0]
            at = np.unravel_index(values[row].argmax(), values.shape[1:])
            self.places[function] = starts[row] + np.array(at) * steps

    def exceeded_by(self, bounds: Array, owner: Indices) -> Indices:
        """Return the rows of bounds (k,) above what is known."""
        return np.flatnonzero(bounds > (self.values + self.slack)[owner])


def sampled_box(coefficients: Array, n: int, m: int) -> Array:
    """Return the box of n x m evenly spaced samples of a Bernstein patch, both ends included.

    Every bound is the coordinate of a sample, within 8 eps of the axis's largest coefficient of the largest (smallest).

    Parameters
    ----------
    coefficients : (a, b, d), finite
    n, m : samples along u and along v, each 2 or more

    Returns
    -------
    (d, 2) float64, columns min and max
    """
    degrees = [count - 1 for count in coefficients.shape[:2]]
    if n * m < _FULL_BELOW:
        basis_u, basis_v = (
            bernstein.basis(degree, np.linspace(0.0, 1.0, count)) for degree, count in zip(degrees, (n, m), strict=True)
        )
        return grid.box(coefficients, basis_u, basis_v)
    at = _places_of_extremes(coefficients, n, m) / np.array([n - 1, m - 1])
    basis_u, basis_v = (bernstein.basis(degree, at[:, k]) for k, degree in enumerate(degrees))
    values = grid.evaluate_scattered(coefficients, basis_u, basis_v).reshape(2, -1, coefficients.shape[2])
    return np.diagonal(values, axis1=1, axis2=2).T.copy()


@np.errstate(under="ignore")  # what underflows is nothing
def _places_of_extremes(coefficients: Array, n: int, m: int) -> Indices:
    """Return where the least sample of every axis stands, then where the largest ones do, (2 d, 2)."""
    axes = np.moveaxis(coefficients, -1, 0)
    functions = np.concatenate([-axes, axes])
    count, largest = len(functions), np.abs(functions).max(axis=(1, 2))
    best = _Best(np.full(count, -np.inf), np.zeros((count, 2), dtype=np.intp), SLACK * largest)
    along = [_cells(size - 1, samples - 1) for size, samples in zip(coefficients.shape[:2], (n, m), strict=True)]
    pieces, bounds = _first_pieces(functions, along, best)
    cuts = [cells.cuts for cells in along]
    while max(cuts) > 0 and len(bounds):
        is_cut = [cut == max(cuts) for cut in cuts]
        cuts = [cut - is_it for cut, is_it in zip(cuts, is_cut, strict=True)]
        steps = np.array([cells.leaf * _PARTS**cut for cells, cut in zip(along, cuts, strict=True)])
        pieces, bounds = _cut(pieces, is_cut, steps, best)
    _sample(pieces, bounds, [cells.leaf for cells in along], best)
    return best.places


@lru_cache(maxsize=64)
def _cells(degree: int, intervals: int) -> _Cells:
    """Return the cells with which to begin along one direction."""
    cuts = 0
    while -(-intervals // _PARTS ** (cuts + 1)) > _LARGEST_LEAF:
        cuts += 1
    leaf = -(-intervals // _PARTS ** (cuts + 1))
    size = leaf * _PARTS**cuts
    starts = np.linspace(0, intervals - size, -(-intervals // size)).round().astype(np.intp)
    ends = [(start / intervals, (start + size) / intervals) for start in starts.tolist()]
    return _Cells(np.stack([bernstein.restriction(degree, *end) for end in ends]), starts, leaf, cuts)


@lru_cache(maxsize=8)
def _parts(degree: int, count: int) -> Array:
    """Return the matrix (count (degree + 1), degree + 1) that restricts to each of ``count`` equal parts of [0, 1]."""
    ends = [(k / count, (k + 1) / count) for k in range(count)]
    return read_only(np.concatenate([bernstein.restriction(degree, *end) for end in ends]))


def _first_pieces(functions: Array, along: list[_Cells], best: _Best) -> tuple[_Pieces, Array]:
    """Return functions (f, a, b) over the first cells that can hold more than their corners, and their bounds."""
    in_u, in_v = (cells.restrictions for cells in along)
    coefficients = in_u[:, None, None] @ functions @ in_v.transpose(0, 2, 1)[:, None]
    starts = np.stack(np.meshgrid(*(cells.starts for cells in along), indexing="ij"), axis=-1)
    f, (k_u, k_v) = len(functions), coefficients.shape[:2]
    pieces = _Pieces(
        coefficients.reshape(-1, *functions.shape[1:]),
        np.tile(np.arange(f, dtype=np.intp), k_u * k_v),
        np.repeat(starts.reshape(-1, 2), f, axis=0),
    )
    steps = np.array([cells.leaf * _PARTS**cells.cuts for cells in along])
    best.offer(_corners(pieces.coefficients), pieces.owner, pieces.starts, steps)
    bounds = pieces.coefficients.max(axis=(1, 2))
    rows = best.exceeded_by(bounds, pieces.owner)
    return pieces.at(rows), bounds[rows]


def _corners(coefficients: Array) -> Array:
    """Return the values (k, 2, 2) that pieces (k, a, b) have at their corners."""
    return coefficients[:, :: coefficients.shape[1] - 1, :: coefficients.shape[2] - 1]


def _cut(pieces: _Pieces, is_cut: list[bool], steps: Indices, best: _Best) -> tuple[_Pieces, Array]:
    """Cut pieces along u, along v, or both; return the parts that can hold more than is known, and their bounds."""
    k, a, b = pieces.coefficients.shape
    p, q = (_PARTS if it else 1 for it in is_cut)
    parts = _tensor_product(_parts(a - 1, p), pieces.coefficients, _parts(b - 1, q))
    parts = parts.reshape(k, p, a, q, b).transpose(0, 1, 3, 2, 4).reshape(-1, a, b)
    offsets = np.stack(np.meshgrid(np.arange(p), np.arange(q), indexing="ij"), axis=-1) * steps
    owner = np.repeat(pieces.owner, p * q)
    starts = (pieces.starts[:, None] + offsets.reshape(-1, 2)).reshape(-1, 2)
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
