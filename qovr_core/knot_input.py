"""The knots of a document from what a caller or a file gives, checked entry by entry."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from qovr_core.arrays import Array
from qovr_core.checks import checked_knot, described, entries
from qovr_core.errors import DocumentError
from qovr_core.geometry.knots import KNOT_NAMES, Direction, KnotPlace, Knots, KnotTable

KnotsLike = KnotTable | Array | Knots | Sequence[Knots] | Sequence[Sequence[Knots]]
"""The knots of all curves of a direction: as a table, an array (curves, windows, 4), one a curve, a list of one a
window for each curve, or one for all."""


def checked_knots(knots: KnotsLike, direction: Direction, curves: int, windows: int) -> KnotTable:
    """Return the knots of a direction as a table.

    Raises
    ------
    DocumentError : there are too few or too many, or one is not strictly between 0 and 1; it names the place
    """
    if isinstance(knots, Knots):
        return KnotTable(np.broadcast_to(tuple(knots), (curves, windows, len(KNOT_NAMES))))
    if isinstance(knots, KnotTable):
        array: Any = knots.array
    elif isinstance(knots, np.ndarray):
        array = knots
    else:
        return _of_entries(knots, direction, curves, windows)
    shape = (curves, windows, len(KNOT_NAMES))
    if array.shape != shape:
        found, expected = (" x ".join(map(str, each)) for each in (array.shape, shape))
        raise DocumentError(direction, f"an array of {found}", f"one of {expected}")
    is_valid = (array > 0) & (array < 1)
    for curve, window, number in () if is_valid.all() else np.argwhere(~is_valid):
        place = KnotPlace(direction, int(curve), KNOT_NAMES[number], int(window))
        checked_knot(array[curve, window, number].item(), place.text(windows))
    return knots if isinstance(knots, KnotTable) else KnotTable(array)


def _of_entries(knots: object, direction: Direction, curves: int, windows: int) -> KnotTable:
    array = np.empty((curves, windows, len(KNOT_NAMES)))
    for curve, entry in enumerate(entries(knots, direction, curves)):
        place = f"{direction}[{curve}]"
        if windows == 1 and isinstance(entry, Knots):
            array[curve] = tuple(entry)
            continue
        if windows == 1 and not isinstance(entry, list):
            raise DocumentError(place, described(entry), "a Knots object")
        for window, each in enumerate(entries(entry, place, windows)):
            if not isinstance(each, Knots):
                raise DocumentError(f"{place}[{window}]", described(each), "a Knots object")
            array[curve, window] = tuple(each)
    return KnotTable(array)
