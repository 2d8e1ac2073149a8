"""The control points as arrays: how far apart they are seen, which stand out, and which names have room."""

from __future__ import annotations

from functools import lru_cache

import numpy as np
import numpy.typing as npt

from qovr_app.view3d.scene.camera import Size
from qovr_app.view3d.scene.net_flags import flags_of
from qovr_app.view3d.scene.picture import Picture
from qovr_core.arrays import Array, Flags, read_only

Numbers = npt.NDArray[np.intp]

_FADES_WITHIN = 0.4
"""Part of a name's room beyond its neighbour's in which it fades in: none springs up while one zooms."""

_FAINTEST = 0.25

MANY = 200
"""Points above which names thin out by their room alone: of their boxes, the first in every cell is looked at."""

LAST, HOVERED, SELECTED, OTHER = range(4)
"""Ranks of points: whose name has the right of way."""


def gaps(seen: Array) -> tuple[float, float]:
    """Return the mean distance of neighbours along the rows and along the columns of a net at pixels (k, l, 2+)."""
    return _mean_step(seen[:, 1:, :2] - seen[:, :-1, :2]), _mean_step(seen[1:, :, :2] - seen[:-1, :, :2])


def _mean_step(ways: Array) -> float:
    lengths = np.hypot(ways[..., 0], ways[..., 1])
    lengths = lengths[np.isfinite(lengths)]
    return float(lengths.mean()) if lengths.size else np.inf


def is_within(seen: Array, size: Size) -> Flags:
    """Return which points at pixels (..., 2) lie in a viewport; none does that is not before the eye."""
    x, y = seen[..., 0], seen[..., 1]
    within: Flags = (x >= 0) & (x <= size[0]) & (y >= 0) & (y <= size[1])
    return within


def ranks(picture: Picture) -> Numbers:
    """Return the rank of every point, (rows, columns)."""
    shape = picture.scene.net_shape
    found = np.where(flags_of(picture.selected, shape), SELECTED, OTHER)
    for index, rank in ((picture.hovered, HOVERED), (picture.last_selected, LAST)):
        if index is not None and index[0] < shape[0] and index[1] < shape[1]:
            found[index] = rank
    return found


@lru_cache(maxsize=4)
def levels(shape: tuple[int, int]) -> Numbers:
    """Return how coarse a part of the net each point belongs to, (rows, columns): every 2^level-th row and column."""
    rows, columns = (_levels(count) for count in shape)
    return read_only(np.minimum(rows[:, None], columns[None, :]))


def _levels(count: int) -> Numbers:
    numbers = np.arange(count)
    numbers[[0, -1]] = 2 ** int(count).bit_length()  # corners and edges are the last to lose their names
    found: Numbers = np.log2(numbers & -numbers).astype(np.intp)
    return found


def covers(corners: Array, room: tuple[float, float], taken: Array) -> Flags:
    """Return which boxes, as below, lie on what is never covered."""
    upper, low, high = corners[:, None], taken[:, :2], taken[:, 2:]
    both: Flags = (upper < high) & (upper + room > low)
    found: Flags = np.any(both[..., 0] & both[..., 1], axis=1)
    return found


def with_room(corners: Array, room: tuple[float, float], taken: Array, freely: int) -> tuple[Numbers, Array]:
    """Return which of several boxes of one size are drawn, in their order of precedence, and how opaque each is.

    Parameters
    ----------
    corners : (k, 2) upper left corners in pixels, the first having the right of way
    room : width and height that a box takes
    taken : (m, 4) left, top, right and bottom of what is never covered
    freely : how many of the first do not fade
    """
    width, height = room
    is_free = ~covers(corners, room, taken)
    if len(corners) > MANY:
        is_free &= _first_in_cells(corners, room)
    numbers = np.flatnonzero(is_free)
    (left, top), away = corners[numbers].T, np.full(len(numbers), np.inf)
    waits, kept = np.ones(len(numbers), dtype=bool), list[int]()
    for k in range(len(numbers)):
        if waits[k]:
            kept.append(k)
            apart = np.maximum(np.abs(left - left[k]) / width, np.abs(top - top[k]) / height)
            waits &= apart >= 1
            away[k + 1 :] = np.minimum(away[k + 1 :], apart[k + 1 :])
    chosen = numbers[kept]
    opacity = np.clip((away[kept] - 1) / _FADES_WITHIN, _FAINTEST, 1.0)
    return chosen, np.where(chosen < freely, 1.0, opacity)


def _first_in_cells(corners: Array, room: tuple[float, float]) -> Flags:
    cells = np.floor(corners / room).astype(np.int64)
    cells -= cells.min(axis=0)
    _, first = np.unique(cells[:, 0] * (cells[:, 1].max() + 1) + cells[:, 1], return_index=True)
    is_first = np.zeros(len(corners), dtype=bool)
    is_first[first] = True
    return is_first
