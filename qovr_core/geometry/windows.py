"""The windows of a net: 5 x 5 points each, of which neighbours share three rows or columns."""

from __future__ import annotations

from typing import TypeVar

import numpy as np
import numpy.typing as npt

from qovr_core.arrays import Array
from qovr_core.geometry.knots import KnotTable

NET_SIZE = 5
"""Rows and columns of one window's control net."""

STEP = 2
"""The next window begins so many rows or columns further on."""


_Number = TypeVar("_Number", bound=np.generic)


def window_count(points: int) -> int:
    """Return how many windows lie along so many points."""
    return (points - NET_SIZE) // STEP + 1


def net_windows(net: npt.NDArray[_Number]) -> npt.NDArray[_Number]:
    """Return the nets of all windows, (m, n, 5, 5, d), of a net (2m+3, 2n+3, d); a view."""
    views = np.lib.stride_tricks.sliding_window_view(net, (NET_SIZE, NET_SIZE), axis=(0, 1))
    return views[::STEP, ::STEP].transpose(0, 1, 3, 4, 2)


def row_windows(rows: KnotTable) -> Array:
    """Return the knots of the five row curves of all windows, (m, n, 5, 4); a view."""
    return curve_windows(rows.array)


def column_windows(columns: KnotTable) -> Array:
    """Return the knots of the five column curves of all windows, (m, n, 5, 4); a view."""
    return row_windows(columns).swapaxes(0, 1)


def curve_windows(curves: Array) -> Array:
    """Return what five row curves have in each of their windows, (m, n, 5, ...), of all curves (2m+3, n, ...); a view.

    Column curves (2n+3, m, ...) come as (n, m, 5, ...).
    """
    views = np.lib.stride_tricks.sliding_window_view(curves, NET_SIZE, axis=0)
    return np.moveaxis(views[::STEP], -1, 2)


def curve_points(net: Array) -> Array:
    """Return the five points of every row curve in each of its windows, (2m+3, n, 5, 3); a view."""
    views = np.lib.stride_tricks.sliding_window_view(net, NET_SIZE, axis=1)
    return views[:, ::STEP].transpose(0, 1, 3, 2)
