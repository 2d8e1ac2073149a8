"""Where labels in a drawing find room."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from qovr_core.arrays import Array, Flags, Indices

_NEAR = 0.15
"""Labels on two functions are closer than they may be within this part of the drawing both ways."""

_SIDES = np.array([(x, y) for x in (-1, 0, 1) for y in (-1, 0, 1) if (x, y) != (0, 0)], dtype=np.float64)
_REACHES = (1.0, 3.0)
"""A label is tried at its gap, and where that is crowded at this many gaps."""

_MORE = 1.01
"""So much farther than a label can reach, points of a line are looked at: rounding leaves out none that it covers."""

_FARTHER, _TURNED, _HIDDEN = 3.0, 3.0, 1000.0
"""What counts as much as covering so many points of a line: lying farther off, lying on the side opposite to that
wanted, and covering another label or leaving the drawing."""


def label_places(values: npt.ArrayLike) -> Indices:
    """Return where a label on each of several functions is farthest from the others and from their labels.

    Parameters
    ----------
    values : (n, k) the functions' values at n places; NaN where one is not in the drawing

    Returns
    -------
    (k,) the number of the place for each function; the outer tenths, where labels have no room, are left out
    """
    table = np.asarray(values, dtype=np.float64)
    count, functions = table.shape
    extent = np.nanmax(table) - np.nanmin(table)
    margin, near = count // 10, _NEAR * np.array([count, extent])
    apart = np.abs(table[:, :, None] - table[:, None, :])
    apart[:, np.arange(functions), np.arange(functions)] = np.inf
    apart[np.isnan(apart)] = np.inf
    clear = apart.min(axis=2)
    clear[np.isnan(table)] = -np.inf
    clear[:margin] = clear[count - margin :] = -np.inf
    places = np.zeros(functions, dtype=np.intp)
    for k in range(functions):
        for other in range(k):
            is_near = np.abs(np.arange(count) - places[other]) < near[0]
            is_near &= np.abs(table[:, k] - table[places[other], other]) < near[1]
            clear[is_near, k] -= extent
        places[k] = np.argmax(clear[:, k])
    return places


def free_place(own: Array, others: Array) -> int:
    """Return the number of the point on a line, (n, 2), that is farthest from all of some others, (m, 2)."""
    x, y = (own[:, None, k] - others[None, :, k] for k in range(2))
    return int(np.argmax(np.sqrt((x * x + y * y).min(axis=1))))


def place_labels(places: Array, sizes: Array, wanted: Array, lines: Array, *, gap: float, box: Array) -> Array:
    """Return where the centres of labels lie: beside their places, clear of lines and of each other.

    Parameters
    ----------
    places : (k, 2) what the labels belong to, in pixels or other units that are equal both ways
    sizes : (k, 2) the labels' widths and heights
    wanted : (k, 2) to which side of its place each label goes if nothing is in the way; any length
    lines : (n, 2) points of the lines to keep clear of
    gap : between a place and its label
    box : (2, 2) the drawing's lower left and upper right corner

    Returns
    -------
    (k, 2) float64
    """
    centres = np.empty_like(places)
    others: list[Array] = []
    for k, (place, size) in enumerate(zip(places, sizes, strict=True)):
        tried = np.concatenate([place + _SIDES * (size / 2 + reach * gap) for reach in _REACHES])
        cost = np.repeat([0.0, _FARTHER], len(_SIDES)) + np.tile(_TURNED * _turn(wanted[k]), len(_REACHES))
        at_hand = _inside(lines, place[None], _MORE * (size + _REACHES[-1] * gap))[0]
        cost += _inside(lines[at_hand], tried, size / 2).sum(axis=1)
        for centre, other in others:
            cost += _HIDDEN * _inside(centre[None], tried, (size + other) / 2)[:, 0]
        cost += _HIDDEN * ((tried - size / 2 < box[0]) | (tried + size / 2 > box[1])).any(axis=1)
        centres[k] = tried[np.argmin(cost)]
        others.append(np.array([centres[k], size]))
    return centres


def _turn(wanted: Array) -> Array:
    """Return how far each side is from the one that is wanted, from 0 to 1."""
    length = np.linalg.norm(wanted)
    aim = wanted / length if length > 0 else np.array([0.0, 1.0])
    turned: Array = (1 - _SIDES @ aim / np.linalg.norm(_SIDES, axis=1)) / 2
    return turned


def _inside(points: Array, centres: Array, halves: Array) -> Flags:
    """Return for every centre which points lie within a rectangle around it, (centres, points)."""
    x, y = (np.abs(points[None, :, k] - centres[:, None, k]) < halves[k] for k in range(2))
    return np.asarray(x & y)
