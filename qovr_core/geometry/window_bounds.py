"""What the samples of each window of a net can reach, and what some of them do: kept from one edit to the next."""

from __future__ import annotations

import numpy as np

from qovr_core.arrays import Array, read_only


def window_bounds(windows: Array) -> Array:
    """Return what no sample of a window exceeds, by its Bernstein coefficients, and the sample at which it begins.

    Parameters
    ----------
    windows : (w, a, b, d) Bernstein coefficients

    Returns
    -------
    (2, 2 d, w) read-only: bounds, then samples; of each, minus every coordinate, whose largest is the least sample,
    then the coordinates
    """
    count, d = len(windows), windows.shape[3]
    rows = windows.reshape(count, -1)
    low, high = (_folded(extreme, rows, d) for extreme in (np.minimum, np.maximum))
    first = windows[:, 0, 0]
    return read_only(np.stack([np.concatenate([-low, high], axis=1).T, np.concatenate([-first, first], axis=1).T]))


def _folded(extreme: np.ufunc, rows: Array, d: int) -> Array:
    """Return the extremes of rows of points (w, k d) by coordinate, (w, d).

    Rows are folded in halves: NumPy's own reduction over an axis that is not the last takes ten times as long.
    """
    while rows.shape[1] > d:
        points = rows.shape[1] // d
        half = points // 2 * d
        folded = extreme(rows[:, :half], rows[:, half : 2 * half])
        if points % 2:
            folded[:, :d] = extreme(folded[:, :d], rows[:, -d:])
        rows = folded
    return rows
