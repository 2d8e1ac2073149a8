"""The cells of evenly spaced samples in which their largest are looked for, along one direction."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from qovr_core.arrays import Array, Indices, read_only
from qovr_core.geometry import bernstein

PARTS = 4
"""Cells along each direction to begin with, and parts of a cell that is cut."""

_LARGEST_LEAF = 32
"""Intervals of a cell along one direction up to which its samples cost no more than to cut it further."""


@dataclass(frozen=True, eq=False)
class Cells:
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


@lru_cache(maxsize=64)
def cells_of(degree: int, intervals: int) -> Cells:
    """Return the cells with which to begin along one direction.

    Where the samples are fewer than the coefficients of cells would be, it is one, and its samples are computed.
    """
    if intervals < PARTS * (degree + 1):
        return Cells(read_only(np.eye(degree + 1)[None]), read_only(np.zeros(1, dtype=np.intp)), intervals, 0)
    cuts = 0
    while -(-intervals // PARTS ** (cuts + 1)) > _LARGEST_LEAF:
        cuts += 1
    leaf = -(-intervals // PARTS ** (cuts + 1))
    size = leaf * PARTS**cuts
    starts = np.linspace(0, intervals - size, -(-intervals // size)).round().astype(np.intp)
    ends = [(start / intervals, (start + size) / intervals) for start in starts.tolist()]
    restrictions = np.stack([bernstein.restriction(degree, *end) for end in ends])
    return Cells(read_only(restrictions), read_only(starts), leaf, cuts)


@lru_cache(maxsize=8)
def restrictions_to_parts(degree: int, count: int) -> Array:
    """Return the matrix (count (degree + 1), degree + 1) that restricts to each of ``count`` equal parts of [0, 1]."""
    ends = [(k / count, (k + 1) / count) for k in range(count)]
    return read_only(np.concatenate([bernstein.restriction(degree, *end) for end in ends]))
