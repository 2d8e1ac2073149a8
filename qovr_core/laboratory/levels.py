"""Where a function on a grid over the unit square exceeds a level, and the line on which it has that level.

Between the samples the function is taken as linear on the two triangles of every cell, so that area and line agree.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from qovr_core.arrays import Array, Flags, Indices, read_only

_CORNERS = np.array([[[0, 0], [1, 1]], [[1, 0], [1, 0]], [[0, 1], [0, 1]]])
"""Steps along u and v from a cell's first sample to the three corners of its two triangles, [corner, triangle]."""


def area_above(values: Array, level: float) -> float:
    """Return the share of the unit square on which a function exceeds a level.

    Parameters
    ----------
    values : (n, m) on a regular grid over the unit square
    """
    cut = _cut(values, level)
    # The line cuts a triangle similar to the whole one off the corner that is alone.
    similar = cut.parts.prod(axis=0)
    area = cut.whole + np.where(cut.is_above, similar, 1 - similar).sum()
    return float(area / cut.count)


def level_line(values: Array, level: float) -> Array:
    """Return the line on which a function has a level, as separate segments.

    Parameters
    ----------
    values : (n, m) on a regular grid over the unit square, indexed [iu, iv]

    Returns
    -------
    (k, 2, 2) float64, read-only: for each segment its two ends, for each end u and v
    """
    cut = _cut(values, level)
    corners = (cut.cells + _CORNERS[:, cut.families]) / (np.array(values.shape) - 1)
    every = np.arange(cut.alone.size)
    ends = [
        corners[cut.alone, every] + part[:, None] * (corners[other, every] - corners[cut.alone, every])
        for other, part in zip(_others(cut.alone), cut.parts, strict=True)
    ]
    return read_only(np.stack(ends, axis=1))


@dataclass(frozen=True)
class _Cut:
    """The triangles through which a level runs. One corner of each is alone on its side of the level.

    ``families`` (k,) and ``cells`` (k, 2) say which triangles of which cells they are, ``alone`` (k,) which corner is
    alone and ``is_above`` (k,) whether above the level; the line meets the two edges from there after the ``parts``
    (2, k) of their lengths. ``whole`` of all ``count`` triangles lie above the level altogether.
    """

    families: Indices
    cells: Indices
    alone: Indices
    is_above: Flags
    parts: Array
    whole: int
    count: int


def _cut(values: Array, level: float) -> _Cut:
    triangles = _triangles(values - level)
    above = np.count_nonzero(triangles > 0, axis=0)
    families, iu, iv = np.nonzero((above == 1) | (above == 2))
    excess = triangles[:, families, iu, iv]
    is_above = above[families, iu, iv] == 1
    alone = ((excess > 0) == is_above).argmax(axis=0)
    every = np.arange(alone.size)
    lone = excess[alone, every]
    parts = lone / (lone - excess[_others(alone), every])
    whole = int(np.count_nonzero(above == 3))
    return _Cut(families, np.stack([iu, iv], axis=-1), alone, is_above, parts, whole, above.size)


def _others(corner: Indices) -> Indices:
    """Return the two other corners of each triangle, (2, k)."""
    others: Indices = (corner + np.array([[1], [2]])) % 3
    return others


def _triangles(values: Array) -> Array:
    """Return the values at the three corners of both triangles of every cell, (3, 2, n - 1, m - 1)."""
    n, m = np.array(values.shape) - 1
    return np.stack([[values[i : i + n, j : j + m] for i, j in corner] for corner in _CORNERS.tolist()])
