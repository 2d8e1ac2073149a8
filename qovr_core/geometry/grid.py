"""Evaluation of a tensor-product polynomial, mostly on a grid of parameters: the one place where speed is won.

A grid of n x m points is one product of an (n, degree + 1) basis with a (degree + 1, 3 m) table, which writes
the points in their final order. Blocks of rows that fit a core's cache keep the product off the main memory. A
polynomial in pieces has one such product a piece along u: each sample belongs to one piece, so that the cost grows with
samples and with pieces, never with both at once.
"""

from __future__ import annotations

import os
import threading
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import cache, cached_property
from itertools import pairwise
from math import prod
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from qovr_core.arrays import Array, Indices, checked_out

if TYPE_CHECKING:
    from concurrent.futures import ThreadPoolExecutor

BLOCK_BYTES = 288 * 1024
"""Result of one block: it stays in a core's cache, and OpenBLAS, which threads products beyond 2^18 multiplications
of its own accord, leaves it alone. Its threads would spin on for a while and take the cores from whoever draws."""

THREADED_BYTES = 32 * 1024 * 1024
"""New results of this size, which C libraries take from the system each time, are shared by one thread a core: what
takes time is the system's clearing of their pages. Into pages that are there, one core writes as fast as several."""

TABLE_BYTES = 1024 * 1024
"""Size of the curves in v of the pieces along u that are worked on together: little beside large results."""

_Block = tuple[int, slice]
"""The number of a piece along u, and some of its rows."""


@dataclass(frozen=True, eq=False)
class PieceBasis:
    """The basis functions at the parameters of one direction, piece by piece of a piecewise polynomial.

    Parameters
    ----------
    values : (k, degree + 1), rows by piece
    starts : (pieces + 1,) the first row of each piece, and the number of rows
    order : (k,) which parameter each row is of; None where they are in order
    """

    values: Array
    starts: Sequence[int]
    order: Indices | None = None

    @property
    def parameters(self) -> Indices:
        """Which parameter each row is of, (k,)."""
        return np.arange(len(self.values)) if self.order is None else self.order

    @cached_property
    def alike(self) -> list[tuple[slice, slice, int]]:
        """Runs of pieces that have equally many rows, which one product can serve: pieces, rows, rows of each."""
        counts = np.diff(self.starts)
        ends = [0, *(np.flatnonzero(np.diff(counts)) + 1).tolist(), len(counts)]
        return [
            (slice(start, stop), slice(self.starts[start], self.starts[stop]), int(counts[start]))
            for start, stop in pairwise(ends)
            if counts[start]
        ]


class _Scratch(threading.local):
    """Arrays that a thread uses again: what is thrown away after every grid would be new memory each time."""

    def __init__(self) -> None:
        self._held: dict[str, Array] = {}

    def array(self, name: str, *shape: int) -> Array:
        """Return an array of any content, which is good until the next one of this name."""
        size = prod(shape)
        held = self._held.get(name)
        if held is None or held.size < size:
            held = np.empty(size)
            if held.nbytes <= TABLE_BYTES:
                self._held[name] = held
        return held[:size].reshape(shape)


_scratch = _Scratch()


@dataclass(frozen=True)
class _Blocks:
    """The rows of some pieces along u in blocks of so many that they stay in a core's cache."""

    starts: Sequence[int]
    pieces: range
    rows: int

    def __iter__(self) -> Iterator[_Block]:
        for piece in self.pieces:
            start, stop = self.starts[piece], self.starts[piece + 1]
            for k in range(start, stop, self.rows):
                yield piece, slice(k, min(k + self.rows, stop))


def _table(coefficients: Array, along_v: PieceBasis) -> Array:
    """Return (n, a, d M) for pieces (m, n, a, b, d): for every coefficient along u, the points of its curve in v."""
    _, n, a, b, d = coefficients.shape
    table = _scratch.array("table", n, a, len(along_v.values), d)
    for pieces, rows, each in along_v.alike:
        bases = along_v.values[rows].reshape(-1, 1, 1, each, b)
        by_piece = table[:, :, rows].reshape(n, a, -1, each, d).transpose(2, 0, 1, 3, 4)
        np.matmul(bases, coefficients[pieces], out=by_piece)
    return table.reshape(n, a, -1)


@cache
def _threads() -> int:
    """Return how many threads a grid may use: one a core, or what is allowed to the libraries below NumPy as well."""
    allowed = os.environ.get("OMP_NUM_THREADS", "")
    return int(allowed) if allowed.isdecimal() and int(allowed) > 0 else os.cpu_count() or 1


@cache
def _pool() -> ThreadPoolExecutor:
    from concurrent.futures import ThreadPoolExecutor

    return ThreadPoolExecutor(_threads(), thread_name_prefix="qovr-grid")


class _Left:
    """The blocks that no thread has taken: where other programs have the cores, nobody waits for a thread's share."""

    def __init__(self, blocks: _Blocks) -> None:
        self._blocks, self._lock = iter(blocks), threading.Lock()

    def __iter__(self) -> Iterator[_Block]:
        return self

    def __next__(self) -> _Block:
        with self._lock:
            return next(self._blocks)


def _in_threads(blocks: _Blocks, work: Callable[[Iterator[_Block]], None]) -> None:
    """Run ``work`` on blocks in one thread a core."""
    left = _Left(blocks)
    others = [_pool().submit(work, left) for _ in range(_threads() - 1)]
    work(left)
    for other in others:
        if not other.cancel():
            other.result()


def _rows_in_block(row_bytes: int) -> int:
    """Return how many rows stay in a core's cache together."""
    return max(1, BLOCK_BYTES // max(row_bytes, 1))


def blocks(along_u: PieceBasis, width: int) -> Iterator[Indices]:
    """Yield the parameters along u, as they are worked on together where every one gives so many numbers."""
    parameters, rows = along_u.parameters, _rows_in_block(along_u.values.itemsize * width)
    return (parameters[some] for _, some in _Blocks(along_u.starts, range(len(along_u.starts) - 1), rows))


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
def evaluate_pieces(
    coefficients: Array, along_u: PieceBasis, along_v: PieceBasis, out: npt.NDArray[Any] | None = None
) -> npt.NDArray[Any]:
    """Return the points of a piecewise tensor-product polynomial.

    Parameters
    ----------
    coefficients : (m, n, a, b, d), the pieces' order along v first, inside each u first
    along_u, along_v : the bases for N parameters in n pieces, and for M in m
    out : (N, M, d) to write to; see ``arrays.checked_out``

    Returns
    -------
    (N, M, d) float64, u along the first axis; or ``out``
    """
    n, a, d = coefficients.shape[1], coefficients.shape[2], coefficients.shape[4]
    rows, width = len(along_u.values), len(along_v.values) * d
    points = checked_out(out, (rows, len(along_v.values), d))
    if along_u.order is not None or along_v.order is not None:
        by_u, by_v = (PieceBasis(basis.values, basis.starts) for basis in (along_u, along_v))
        points[np.ix_(along_u.parameters, along_v.parameters)] = evaluate_pieces(coefficients, by_u, by_v)
        return points
    flat = points.reshape(rows, width) if points.flags.c_contiguous and points.dtype == np.float64 else None
    row_bytes, is_threaded = coefficients.itemsize * width, out is None and points.nbytes >= THREADED_BYTES
    together = max(1, TABLE_BYTES // max(a * row_bytes, 1))
    for first in range(0, n, together):
        pieces = range(first, min(first + together, n))
        table = _table(coefficients[:, first : pieces.stop], along_v)

        def work(blocks: Iterator[_Block], table: Array = table, first: int = first) -> None:
            for piece, some in blocks:
                u = along_u.values[some]
                if flat is not None:
                    np.matmul(u, table[piece - first], out=flat[some])
                else:
                    block = np.matmul(u, table[piece - first], out=_scratch.array("block", len(u), width))
                    points[some] = block.reshape(len(u), -1, d)

        blocks = _Blocks(along_u.starts, pieces, _rows_in_block(row_bytes))
        if is_threaded:
            _in_threads(blocks, work)
        else:
            work(iter(blocks))
        del table, work  # before the next one is made
    return points


@np.errstate(under="ignore")  # what underflows is nothing
def box(coefficients: Array, along_u: PieceBasis, along_v: PieceBasis) -> Array:
    """Return the box of the points alone, (d, 2) with columns min and max; no more than a block of them is ever held.

    Parameters are those of ``evaluate_pieces``.
    """
    n, d, m = coefficients.shape[1], coefficients.shape[4], len(along_v.values)
    table = _table(coefficients, along_v)
    low, high = np.full(m * d, np.inf), np.full(m * d, -np.inf)
    for piece, rows in _Blocks(along_u.starts, range(n), _rows_in_block(table.itemsize * m * d)):
        u = along_u.values[rows]
        block = np.matmul(u, table[piece], out=_scratch.array("block", len(u), m * d))
        np.minimum(low, block.min(axis=0), out=low)
        np.maximum(high, block.max(axis=0), out=high)
    return np.stack([low.reshape(m, d).min(axis=0), high.reshape(m, d).max(axis=0)], axis=1)
