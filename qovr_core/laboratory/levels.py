"""Where a function on a grid over the unit square exceeds a level, and the line on which it has that level.

Between the samples the function is taken as linear on the two triangles of every cell, so that area and line agree.
"""

from __future__ import annotations

import numpy as np

from qovr_core.arrays import Array, read_only


def area_above(values: Array, level: float) -> float:
    """Return the share of the unit square on which a function exceeds a level.

    Parameters
    ----------
    values : (n, m) on a regular grid over the unit square
    """
    triangles = _triangles(values - level)
    above = np.count_nonzero(triangles > 0, axis=0)
    low, middle, high = np.sort(triangles[:, (above == 1) | (above == 2)], axis=0)
    # The line through a cut triangle parts one corner from the two others, and cuts a similar triangle off.
    is_one_above = middle <= 0
    alone = np.where(is_one_above, high, low)
    cut_off = alone**2 / ((high - low) * np.abs(alone - middle))
    area = np.count_nonzero(above == 3) + np.where(is_one_above, cut_off, 1 - cut_off).sum()
    return float(area / above.size)


def level_line(values: Array, level: float) -> Array:
    """Return the line on which a function has a level, as separate segments.

    Parameters
    ----------
    values : (n, m) on a regular grid over the unit square, indexed [iu, iv]

    Returns
    -------
    (k, 2, 2) float64, read-only: for each segment its two ends, for each end u and v
    """
    u, v = (np.linspace(0.0, 1.0, count) for count in values.shape)
    grid_u, grid_v = np.meshgrid(u, v, indexing="ij")
    excess, *places = (_triangles(table) for table in (values - level, grid_u, grid_v))
    above = np.count_nonzero(excess > 0, axis=0)
    is_cut = (above == 1) | (above == 2)
    order = np.argsort(excess[:, is_cut], axis=0)
    low, middle, high = np.take_along_axis(excess[:, is_cut], order, axis=0)
    corners = np.stack([np.take_along_axis(place[:, is_cut], order, axis=0) for place in places], axis=-1)
    is_one_above = middle <= 0
    alone = np.where(is_one_above, high, low)
    lone_corner = np.where(is_one_above[:, None], corners[2], corners[0])
    far = np.where(is_one_above, low, high), np.where(is_one_above[:, None], corners[0], corners[2])
    ends = []
    for other, corner in (far, (middle, corners[1])):
        part = (alone / (alone - other))[:, None]
        ends.append(lone_corner + part * (corner - lone_corner))
    return read_only(np.stack(ends, axis=1))


def _triangles(values: Array) -> Array:
    """Return the values at the three corners of both triangles of every cell, (3, 2, n - 1, m - 1)."""
    diagonal = [values[1:, :-1], values[:-1, 1:]]
    return np.stack([np.stack([corner, *diagonal]) for corner in (values[:-1, :-1], values[1:, 1:])], axis=1)
