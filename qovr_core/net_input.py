"""The control points of a document from what a caller or a file gives, checked entry by entry."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import chain
from typing import Any

import numpy as np
import numpy.typing as npt

from qovr_core.arrays import Array, read_only
from qovr_core.checks import LARGEST_MAGNITUDE, checked_number, entries, plain_numbers
from qovr_core.errors import DocumentError
from qovr_core.geometry.windows import NET_SIZE

MOST_POINTS = 203
"""Rows, and columns, of the largest net: 100 windows each way."""

_COUNTS = f"a list of 5, 7, 9, ... or {MOST_POINTS} entries"


def checked_net(points: npt.ArrayLike) -> Array:
    """Return control points as an array (2m+3, 2n+3, 3).

    Raises
    ------
    DocumentError : they are no net, or a number is not finite or absurd; it names the place
    """
    if isinstance(points, np.ndarray) and points.dtype == np.float64 and points.ndim == 3 and points.shape[2] == 3:
        for count, place in zip(points.shape, ("control_points", "control_points[0]"), strict=False):
            _check_count(count, place)
        net = points
    else:
        net = _net_of_numbers(points)
    is_valid = np.abs(net) <= LARGEST_MAGNITUDE
    for i, j, k in () if is_valid.all() else np.argwhere(~is_valid):
        checked_number(net[i, j, k].item(), f"control_points[{i}][{j}][{k}]")
    return read_only(net.copy())


def _net_of_numbers(points: Any) -> Array:
    rows = _points_list(points, "control_points")
    _check_count(len(rows), "control_points")
    columns = len(_points_list(rows[0], "control_points[0]"))
    _check_count(columns, "control_points[0]")
    if (net := _plain_net(rows, columns)) is not None:
        return net
    return np.array(
        [
            [
                [
                    checked_number(value, f"control_points[{i}][{j}][{k}]")
                    for k, value in enumerate(entries(point, f"control_points[{i}][{j}]", 3))
                ]
                for j, point in enumerate(entries(row, f"control_points[{i}]", columns))
            ]
            for i, row in enumerate(rows)
        ]
    )


def _plain_net(rows: Sequence[Any], columns: int) -> Array | None:
    """Return a net of plain numbers in lists, all at once; None where anything in it is to be looked at singly."""
    if {*map(type, rows)} != {list} or {*map(len, rows)} != {columns}:
        return None
    points = list(chain.from_iterable(rows))
    if {*map(type, points)} != {list} or {*map(len, points)} != {3}:
        return None
    numbers = plain_numbers(list(chain.from_iterable(points)))
    if numbers is None or not (np.abs(numbers) <= LARGEST_MAGNITUDE).all():
        return None
    return numbers.reshape(len(rows), columns, 3)


def _points_list(value: object, place: str) -> Sequence[Any]:
    return entries(value, place, expected=_COUNTS)


def _check_count(count: int, place: str) -> None:
    """Raise DocumentError where so many rows, or columns, are no net."""
    if not (NET_SIZE <= count <= MOST_POINTS and count % 2):
        raise DocumentError(place, f"a list of {count} entries", _COUNTS)
