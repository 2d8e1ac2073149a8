"""The control points as arrays: how far apart they are seen, which stand out, and which names have room."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache
from typing import TypeVar

import numpy as np
import numpy.typing as npt

from qovr_app.view3d.scene.camera import Size
from qovr_app.view3d.scene.net_flags import flags_of
from qovr_app.view3d.scene.picture import Picture
from qovr_core.arrays import Array, Flags, read_only
from qovr_core.document import NetIndex

Numbers = npt.NDArray[np.intp]
_Number = TypeVar("_Number", bound=np.generic)

_FADES_WITHIN = 0.4
"""Part of a name's room beyond its neighbour's in which it fades in: none springs up while one zooms."""

_FAINTEST = 0.25

_MOVING = 24
"""Rows, and columns, of points that are shown at most of more than twice as many, while something moves."""

_FEW_MARKED = 8

MANY = 200
"""Points above which names thin out by their room alone: of their boxes, the first in every cell is looked at."""

LAST, HOVERED, SELECTED, OTHER = range(4)
"""Ranks of points: whose name has the right of way."""


@dataclass(frozen=True, eq=False)
class NetPart:
    """Some rows and columns of a net, by their numbers: all, or while something moves those of a coarser one."""

    rows: Numbers
    columns: Numbers

    def of(self, net: npt.NDArray[_Number]) -> npt.NDArray[_Number]:
        """Return what an array over the net, (rows, columns, ...), has there."""
        return net if net.shape[:2] == (len(self.rows), len(self.columns)) else net[np.ix_(self.rows, self.columns)]

    def place(self, index: NetIndex) -> NetIndex:
        """Return where a point that is in the part stands in it."""
        i, j = (int(np.searchsorted(numbers, k)) for numbers, k in zip((self.rows, self.columns), index, strict=True))
        return i, j

    def gaps(self, seen: Array) -> tuple[float, float]:
        """Return ``gaps`` of the whole net by the part at pixels (k, l, 2+)."""
        along, across = gaps(seen)
        column, row = ((numbers[-1] - numbers[0]) / (len(numbers) - 1) for numbers in (self.columns, self.rows))
        return float(along / column), float(across / row)


def shown_part(picture: Picture) -> NetPart:
    """Return the part of the net that a picture shows: marked points are in it as long as they are few."""
    shape = picture.scene.net_shape
    marked = [index for index in (picture.hovered, picture.last_selected) if index is not None]
    marked += picture.selected if len(picture.selected) <= _FEW_MARKED else []
    rows, columns = (
        _shown_numbers(count, frozenset(numbers), moving=picture.moving)
        for count, numbers in zip(shape, zip(*marked, strict=True) if marked else ((), ()), strict=True)
    )
    return NetPart(rows, columns)


@lru_cache(maxsize=16)
def _shown_numbers(count: int, marked: frozenset[int], *, moving: bool) -> Numbers:
    step = 2 ** math.ceil(math.log2(count / _MOVING)) if moving and count > 2 * _MOVING else 1
    wanted = {*range(0, count, step), count - 1, *(number for number in marked if number < count)}
    return read_only(np.array(sorted(wanted)))


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
        if index is not None:
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
