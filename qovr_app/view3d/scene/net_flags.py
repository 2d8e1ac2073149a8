"""Sets of control points as arrays of flags."""

from __future__ import annotations

from functools import lru_cache

import numpy as np

from qovr_core.arrays import Flags, read_only
from qovr_core.document import NetIndex


@lru_cache(maxsize=8)
def flags_of(points: frozenset[NetIndex], shape: tuple[int, ...]) -> Flags:
    """Return which points of a net are among these, (rows, columns) bool, read-only; what the net has not is left."""
    flags = np.zeros(shape, dtype=bool)
    if points:
        i, j = np.array(list(points)).T
        is_in = (i < shape[0]) & (j < shape[1])
        flags[i[is_in], j[is_in]] = True
    return read_only(flags)


def has_index(shape: tuple[int, ...], index: NetIndex) -> bool:
    """Return whether a net of a shape has a point of an index."""
    return index[0] < shape[0] and index[1] < shape[1]
