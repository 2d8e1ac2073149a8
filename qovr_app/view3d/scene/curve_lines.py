"""Curves in windows as polylines."""

from __future__ import annotations

from functools import lru_cache

import numpy as np

from qovr_core.arrays import Array, read_only
from qovr_core.geometry.bernstein import basis
from qovr_core.geometry.patch import PATCH_DEGREE

FEW = 4
"""Pieces in a window, at least; more are a multiple of these, so that as few can be picked out."""


def pieces_in_window(windows: int, pieces: int) -> int:
    """Return in how many pieces a curve through so many windows is cut in each: at least so many in all, and a
    multiple of ``FEW``."""
    return -(-pieces // (windows * FEW)) * FEW


def curve_points(coefficients: Array, pieces: int) -> Array:
    """Return points of Bezier curves, even in every window, those between two windows once.

    Parameters
    ----------
    coefficients : (k, windows, 7, 3)
    pieces : how many there are between points, at least

    Returns
    -------
    (k, n, 3) float64
    """
    k, windows = coefficients.shape[:2]
    each = pieces_in_window(windows, pieces)
    points: Array = _curve_basis(each + 1) @ coefficients
    return np.concatenate([points[:, :, :-1].reshape(k, windows * each, 3), points[:, -1, -1:]], axis=1)


@lru_cache(maxsize=4)
def _curve_basis(count: int) -> Array:
    return read_only(basis(PATCH_DEGREE, np.linspace(0.0, 1.0, count)))
