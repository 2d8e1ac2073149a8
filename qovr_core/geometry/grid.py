"""Evaluation of a tensor-product polynomial, mostly on a grid of parameters: the one place where speed is won.

A grid of n x m points is one product of an (n, degree + 1) basis with a (degree + 1, 3 m) table, which writes
the points in their final order. Blocks of rows that fit a core's cache keep the product off the main memory; large
grids are worth one thread a core.
"""

from __future__ import annotations

import os
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from functools import cache
from itertools import pairwise
from typing import TypeVar

import numpy as np

from qovr_core.arrays import Array

BLOCK_BYTES = 288 * 1024
"""Result of one block: it stays in a core's cache, and OpenBLAS, which threads products beyond 2^18 multiplications
of its own accord, leaves it alone. Its threads would spin on for a while and take the cores from whoever draws."""

THREADED_BYTES = 4 * 1024 * 1024
"""Results smaller than this are done in the caller's thread; larger ones are bound by memory."""

_Partial = TypeVar("_Partial")


def _table(coefficients: Array, basis_v: Array) -> Array:
    """Return (a, 3 m): for every coefficient along u, the points of its curve in v."""
    a, b, d = coefficients.shape
    along_v = basis_v @ coefficients.transpose(1, 0, 2).reshape(b, a * d)
    return along_v.reshape(-1, a, d).transpose(1, 0, 2).reshape(a, -1)


@cache
def _threads() -> int:
    """Return how many threads a grid may use: one a core, or what is allowed to the libraries below NumPy as well."""
    allowed = os.environ.get("OMP_NUM_THREADS", "")
    return int(allowed) if allowed.isdecimal() and int(allowed) > 0 else os.cpu_count() or 1


@cache
def _pool() -> ThreadPoolExecutor:
    return ThreadPoolExecutor(_threads(), thread_name_prefix="qovr-grid")


def _over_rows(rows: int, row_bytes: int, work: Callable[[list[slice]], _Partial]) -> list[_Partial]:
    """Run ``work`` on all rows, cut into blocks, in as many threads as the size is worth."""
    step = max(1, BLOCK_BYTES // row_bytes)
    blocks = [slice(k, min(k + step, rows)) for k in range(0, rows, step)]
    workers = min(_threads(), len(blocks)) if rows * row_bytes >= THREADED_BYTES else 1
    if workers == 1:
        return [work(blocks)]
    cuts = [len(blocks) * k // workers for k in range(workers + 1)]
    others = [_pool().submit(work, blocks[a:b]) for a, b in pairwise(cuts[1:])]
    return [work(blocks[: cuts[1]]), *(other.result() for other in others)]


@np.errstate(under="ignore")  # what underflows is nothing
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
    n, m, d = len(basis_u), len(basis_v), coefficients.shape[2]
    table = _table(coefficients, basis_v)
    points = np.empty((n, m, d))
    flat = points.reshape(n, m * d)

    def work(blocks: list[slice]) -> None:
        for rows in blocks:
            np.matmul(basis_u[rows], table, out=flat[rows])

    _over_rows(n, flat.itemsize * m * d, work)
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


@np.errstate(under="ignore")  # what underflows is nothing
def box(coefficients: Array, basis_u: Array, basis_v: Array) -> Array:
    """Return the box of the points alone, (d, 2) with columns min and max; no more than a block of them is ever held.

    Parameters
    ----------
    coefficients : (a, b, d)
    basis_u : (n, a)
    basis_v : (m, b)
    """
    m, d = len(basis_v), coefficients.shape[2]
    table = _table(coefficients, basis_v)

    def work(blocks: list[slice]) -> tuple[Array, Array]:
        low, high = np.full(m * d, np.inf), np.full(m * d, -np.inf)
        held = np.empty((len(basis_u[blocks[0]]), m * d))
        for rows in blocks:
            u = basis_u[rows]
            block = held[: len(u)]
            np.matmul(u, table, out=block)
            np.minimum(low, block.min(axis=0), out=low)
            np.maximum(high, block.max(axis=0), out=high)
        return low.reshape(m, d).min(axis=0), high.reshape(m, d).max(axis=0)

    parts = _over_rows(len(basis_u), table.itemsize * m * d, work)
    low, high = (np.array(bounds) for bounds in zip(*parts, strict=True))
    return np.stack([low.min(axis=0), high.max(axis=0)], axis=1)
