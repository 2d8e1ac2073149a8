"""Evaluation of a tensor-product polynomial, mostly on a grid of parameters: the one place where speed is won.

A grid of n x m points is one product of an (n, degree + 1) basis with a (degree + 1, 3 m) table, which writes
the points in their final order. Blocks of rows that fit a core's cache keep the product off the main memory; large
grids are worth one thread a core. A polynomial in pieces has one such product a piece along u: each sample belongs to
one piece, so that the cost grows with samples and with pieces, never with both at once.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from functools import cache
from itertools import pairwise
from typing import TypeVar

import numpy as np

from qovr_core.arrays import Array, Indices

BLOCK_BYTES = 288 * 1024
"""Result of one block: it stays in a core's cache, and OpenBLAS, which threads products beyond 2^18 multiplications
of its own accord, leaves it alone. Its threads would spin on for a while and take the cores from whoever draws."""

THREADED_BYTES = 4 * 1024 * 1024
"""Results smaller than this are done in the caller's thread; larger ones are bound by memory."""

TABLE_BYTES = 1024 * 1024
"""Size of the curves in v of the pieces along u that are worked on together: little beside large results."""

_Block = tuple[int, slice]
"""The number of a piece along u, and some of its rows."""

_Partial = TypeVar("_Partial")


@dataclass(frozen=True, eq=False)
class PieceBasis:
    """The basis functions at the parameters of one direction, piece by piece of a piecewise polynomial.

    Parameters
    ----------
    values : (k, degree + 1), rows by piece
    starts : (pieces + 1,) the first row of each piece, and the number of rows
    """

    values: Array
    starts: Sequence[int]

    def rows(self, piece: int) -> slice:
        """Return the rows of a piece."""
        return slice(self.starts[piece], self.starts[piece + 1])


def _alike(basis: PieceBasis) -> list[range]:
    """Return the pieces in runs that have equally many rows, which one product can serve."""
    counts = np.diff(basis.starts)
    ends = [0, *(np.flatnonzero(np.diff(counts)) + 1).tolist(), len(counts)]
    return [range(start, stop) for start, stop in pairwise(ends) if counts[start]]


def _table(coefficients: Array, along_v: PieceBasis) -> Array:
    """Return (n, a, d M) for pieces (m, n, a, b, d): for every coefficient along u, the points of its curve in v."""
    m, n, a, b, d = coefficients.shape
    table = np.empty((n, a, len(along_v.values), d))
    across = coefficients.transpose(0, 3, 1, 2, 4).reshape(m, b, n * a * d)
    for pieces in _alike(along_v):
        rows = slice(along_v.starts[pieces.start], along_v.starts[pieces.stop])
        bases = along_v.values[rows].reshape(len(pieces), -1, b)
        values = bases @ across[pieces.start : pieces.stop]
        table[:, :, rows] = values.reshape(-1, n, a, d).transpose(1, 2, 0, 3)
    return table.reshape(n, a, -1)


@cache
def _threads() -> int:
    """Return how many threads a grid may use: one a core, or what is allowed to the libraries below NumPy as well."""
    allowed = os.environ.get("OMP_NUM_THREADS", "")
    return int(allowed) if allowed.isdecimal() and int(allowed) > 0 else os.cpu_count() or 1


@cache
def _pool() -> ThreadPoolExecutor:
    return ThreadPoolExecutor(_threads(), thread_name_prefix="qovr-grid")


def _over_blocks(blocks: list[_Block], size: int, work: Callable[[list[_Block]], _Partial]) -> list[_Partial]:
    """Run ``work`` on blocks, in as many threads as the size of their result, in bytes, is worth."""
    workers = min(_threads(), len(blocks)) if size >= THREADED_BYTES else 1
    if workers <= 1:  # none where pieces are so short that no parameter lies in them
        return [work(blocks)]
    cuts = [len(blocks) * k // workers for k in range(workers + 1)]
    others = [_pool().submit(work, blocks[a:b]) for a, b in pairwise(cuts[1:])]
    return [work(blocks[: cuts[1]]), *(other.result() for other in others)]


def _blocks(basis: PieceBasis, pieces: range, row_bytes: int) -> list[_Block]:
    """Return the rows of some pieces in blocks that stay in a core's cache."""
    step = max(1, BLOCK_BYTES // row_bytes)
    return [
        (piece, slice(k, min(k + step, basis.starts[piece + 1])))
        for piece in pieces
        for k in range(basis.starts[piece], basis.starts[piece + 1], step)
    ]


def evaluate(coefficients: Array, basis_u: Array, basis_v: Array) -> Array:
    """Return the points of a tensor-product polynomial.

    Parameters
    ----------
    coefficients : (a, b, d)
    basis_u : (n, a)
    basis_v : (m, b)

    Returns
    -------
    (n, m, d) float64, u along the first axis
    """
    along_u, along_v = (PieceBasis(basis, (0, len(basis))) for basis in (basis_u, basis_v))
    return evaluate_pieces(coefficients[None, None], along_u, along_v)


@np.errstate(under="ignore")  # what underflows is nothing
def evaluate_pieces(coefficients: Array, along_u: PieceBasis, along_v: PieceBasis) -> Array:
    """Return the points of a piecewise tensor-product polynomial.

    Parameters
    ----------
    coefficients : (m, n, a, b, d), the pieces' order along v first, inside each u first
    along_u, along_v : the bases for N parameters in n pieces, and for M in m

    Returns
    -------
    (N, M, d) float64, u along the first axis
    """
    n, a, d = coefficients.shape[1], coefficients.shape[2], coefficients.shape[4]
    rows, width = len(along_u.values), len(along_v.values) * d
    points = np.empty((rows, len(along_v.values), d))
    flat = points.reshape(rows, width)
    row_bytes = points.itemsize * width
    together = max(1, TABLE_BYTES // max(a * row_bytes, 1))
    for first in range(0, n, together):
        pieces = range(first, min(first + together, n))
        table = _table(coefficients[:, first : pieces.stop], along_v)

        def work(blocks: list[_Block], table: Array = table, first: int = first) -> None:
            for piece, some in blocks:
                np.matmul(along_u.values[some], table[piece - first], out=flat[some])

        _over_blocks(_blocks(along_u, pieces, max(row_bytes, 1)), points.nbytes, work)
        del table, work  # before the next one is made
    return points


@np.errstate(under="ignore")  # what underflows is nothing
def evaluate_scattered(coefficients: Array, basis_u: Array, basis_v: Array) -> Array:
    """Return the values of a tensor-product polynomial at k places.

    Parameters
    ----------
    coefficients : (a, b, d)
    basis_u, basis_v : (k, a) and (k, b), one row a place

    Returns
    -------
    (k, d) float64
    """
    a, b, d = coefficients.shape
    table = coefficients.reshape(a, b * d)
    values = np.empty((len(basis_u), d))
    step = max(1, BLOCK_BYTES // (table.itemsize * b * d))
    for k in range(0, len(values), step):
        places = slice(k, k + step)
        along_v = (basis_u[places] @ table).reshape(-1, b, d)
        np.einsum("kb,kbd->kd", basis_v[places], along_v, out=values[places])
    return values


def asked_pieces(coefficients: Array, pieces: tuple[Indices, Indices]) -> tuple[Array, tuple[Indices, Indices]]:
    """Return of a piecewise polynomial (m, n, ...) only the pieces that are asked, and which of them each place asks.

    Parameters
    ----------
    pieces : for every place the piece's number along v and along u, (k,) each
    """
    if coefficients.shape[:2] == (1, 1):
        return coefficients, pieces
    (a, b), number = np.unique(pieces, axis=1, return_inverse=True)
    return coefficients[None, a, b], (np.zeros_like(number), number)


@np.errstate(under="ignore")  # what underflows is nothing
def evaluate_scattered_pieces(
    coefficients: Array, pieces: tuple[Indices, Indices], basis_u: Array, basis_v: Array
) -> Array:
    """Return the values of a piecewise tensor-product polynomial at k places, (k, d).

    Parameters
    ----------
    coefficients : (m, n, a, b, d)
    pieces : for every place the piece's number along v and along u, (k,) each
    basis_u, basis_v : (k, a) and (k, b), one row a place
    """
    m, n, a, b, d = coefficients.shape
    if m * n == 1:
        return evaluate_scattered(coefficients[0, 0], basis_u, basis_v)
    values = np.empty((len(basis_u), d))
    step = max(1, BLOCK_BYTES // (coefficients.itemsize * a * b * d))
    for k in range(0, len(values), step):
        places = slice(k, k + step)
        own = coefficients[pieces[0][places], pieces[1][places]].reshape(-1, a, b * d)
        along_v = (basis_u[places, None] @ own).reshape(-1, b, d)
        np.einsum("kb,kbd->kd", basis_v[places], along_v, out=values[places])
    return values


@np.errstate(under="ignore")  # what underflows is nothing
def box(coefficients: Array, along_u: PieceBasis, along_v: PieceBasis) -> Array:
    """Return the box of the points alone, (d, 2) with columns min and max; no more than a block of them is ever held.

    Parameters are those of ``evaluate_pieces``.
    """
    n, d, m = coefficients.shape[1], coefficients.shape[4], len(along_v.values)
    table = _table(coefficients, along_v)
    row_bytes = table.itemsize * m * d

    def work(blocks: list[_Block]) -> tuple[Array, Array]:
        low, high = np.full(m * d, np.inf), np.full(m * d, -np.inf)
        held = np.empty((max(rows.stop - rows.start for _, rows in blocks), m * d))
        for piece, rows in blocks:
            u = along_u.values[rows]
            block = held[: len(u)]
            np.matmul(u, table[piece], out=block)
            np.minimum(low, block.min(axis=0), out=low)
            np.maximum(high, block.max(axis=0), out=high)
        return low.reshape(m, d).min(axis=0), high.reshape(m, d).max(axis=0)

    parts = _over_blocks(_blocks(along_u, range(n), row_bytes), len(along_u.values) * row_bytes, work)
    low, high = (np.array(bounds) for bounds in zip(*parts, strict=True))
    return np.stack([low.min(axis=0), high.max(axis=0)], axis=1)
