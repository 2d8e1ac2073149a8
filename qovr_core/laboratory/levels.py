"""Where a function on a grid over the unit square exceeds a level, and the line on which it has that level.

Both are contourpy's, whose filled regions are bounded by its lines, so that area and line agree.
"""

from __future__ import annotations

from collections.abc import Iterable
from itertools import pairwise
from math import fsum
from typing import Any

import numpy as np

from qovr_core.arrays import Array, read_only


def areas_above(values: Array, levels: Iterable[float]) -> tuple[float, ...]:
    """Return the shares of the unit square on which a function exceeds levels.

    Parameters
    ----------
    values : (n, m) on a regular grid over the unit square
    """
    contours = _contours(values)
    return tuple(_area(*contours.filled(level, np.inf)) for level in levels)


def _area(polygons: list[Array], offsets: list[Array]) -> float:
    parts = zip(polygons, offsets, strict=True)
    return sum(_enclosed(points[a:b]) for points, starts in parts for a, b in pairwise(starts.tolist()))


def level_line(values: Array, level: float) -> Array:
    """Return the line on which a function has a level, as separate segments.

    Parameters
    ----------
    values : (n, m) on a regular grid over the unit square, indexed [iu, iv]

    Returns
    -------
    (k, 2, 2) float64, read-only: for each segment its two ends, for each end u and v
    """
    lines = _contours(values).lines(level)
    segments = [np.stack([line[:-1], line[1:]], axis=1) for line in lines]
    return read_only(np.concatenate([np.empty((0, 2, 2)), *segments])[..., ::-1])  # theirs are x = v and y = u


def _contours(values: Array) -> Any:
    """Return a contour generator whose lines are arrays (k, 2), and whose regions arrays with where rings begin."""
    from contourpy import FillType, LineType, contour_generator

    u, v = (np.linspace(0.0, 1.0, count) for count in values.shape)
    return contour_generator(v, u, values, line_type=LineType.Separate, fill_type=FillType.OuterOffset)


def _enclosed(ring: Array) -> float:
    """Return the area within a closed ring of points (k, 2), negative for a hole."""
    x, y = ring.T
    return fsum((np.diff(y) * (x[1:] + x[:-1])).tolist()) / 2
