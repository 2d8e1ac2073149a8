"""Symmetry of a document across its rows or its columns: of the points, and of the knots."""

from __future__ import annotations

from collections.abc import Mapping
from enum import StrEnum

import numpy as np

from qovr_core.arrays import Array
from qovr_core.document import Document
from qovr_core.edits import CoordinatePlace, Place, knots_of, set_knots, set_points, value_at
from qovr_core.errors import DocumentError
from qovr_core.geometry.knots import KNOT_NAMES, Direction, KnotPlace, Knots, knot_array
from qovr_core.net_moves import COLUMNS_MIRROR, ROWS_MIRROR, Mirror

MIRRORS = {Direction.ROWS: ROWS_MIRROR, Direction.COLUMNS: COLUMNS_MIRROR}
"""The plane in which rows, or columns, mirror each other."""

_REVERSED = {"r": "t", "s": "s", "u": "u", "t": "r"}
"""Which knot takes the place of which where a curve runs the other way; its value is 1 minus the other's."""

_KNOT_SIDES = np.array([-1, 0, 0, 1])
"""Which knots of a curve, in the order of ``KNOT_NAMES``, lie on its first side, in the middle, on its last side."""


class Source(StrEnum):
    """Of what a document is made symmetric: of the side of low indices, that of high ones, or the mean of both."""

    FIRST = "first"
    LAST = "last"
    MEAN = "mean"


def make_symmetric(document: Document, across: Direction, source: Source, mirror: Mirror | None = None) -> Document:
    """Return the document in which net and knots are their own mirror image.

    Parameters
    ----------
    across : COLUMNS lets column j mirror column N-1-j in the plane x = mean of the middle column; ROWS likewise in y
    source : which side stays as it is
    mirror : another plane than that
    """
    mirror, net = mirror or MIRRORS[across], document.control_points.copy()
    place = mirror.place(net)
    net[..., mirror.coordinate] -= place
    shape = (-1, 1, 1) if mirror.axis == 0 else (1, -1, 1)
    net = _of_source(net, mirror.flipped(net), _sides(net.shape[mirror.axis]).reshape(shape), source)
    net[..., mirror.coordinate] += place
    paired = knot_array(knots_of(document, across))
    paired = _of_source(paired, paired[::-1], _sides(len(paired))[:, None], source)
    turned = knot_array(knots_of(document, across.other))
    reverse = 1 - turned[:, [KNOT_NAMES.index(_REVERSED[name]) for name in KNOT_NAMES]]
    turned = _of_source(turned, reverse, _KNOT_SIDES, source)
    result = set_points(document, net)
    for direction, family in ((across, paired), (across.other, turned)):
        result = set_knots(result, direction, tuple(Knots(*knots) for knots in family.tolist()))
    return result


def mirrored_values(
    document: Document, values: Mapping[Place, float], across: Direction, mirror: Mirror | None = None
) -> dict[Place, float]:
    """Return what is set together with these numbers, so that a net and knots that are symmetric stay so.

    A coordinate's mirror image changes by as much, along the plane's normal the other way; a knot's is the same on the
    partner of its curve, or the reverse on a curve that crosses the plane. What ``values`` says itself is left. Without
    ``mirror``, the plane is that of ``MIRRORS``.

    Raises
    ------
    DocumentError : a value is its own mirror image and would leave the plane
    """
    wanted = dict(values)
    for place, value in values.items():
        partner, image = _image(document, place, value, across, mirror or MIRRORS[across])
        if partner == place and image != value:
            raise DocumentError(
                str(place), f"{value!r}", f"{_resting(document, place)!r}, as symmetry has it; or switch it off"
            )
        wanted.setdefault(partner, image)
    return wanted


def _image(document: Document, place: Place, value: float, across: Direction, mirror: Mirror) -> tuple[Place, float]:
    """Return where the mirror image of a number stands, and what it becomes."""
    if isinstance(place, KnotPlace):
        if place.direction is across:
            last = len(knots_of(document, across)) - 1
            return KnotPlace(across, last - place.curve, place.name), value
        return KnotPlace(place.direction, place.curve, _REVERSED[place.name]), 1 - value
    last = document.control_points.shape[mirror.axis] - 1
    i, j = (last - place.i, place.j) if mirror.axis == 0 else (place.i, last - place.j)
    partner = CoordinatePlace(i, j, place.axis)
    if place.axis != mirror.coordinate and partner == place:
        return partner, value
    moved = value - value_at(document, place)
    return partner, value_at(document, partner) + (-moved if place.axis == mirror.coordinate else moved)


def _resting(document: Document, place: Place) -> float:
    """Return the one value that is its own mirror image."""
    return 0.5 if isinstance(place, KnotPlace) else value_at(document, place)


def _sides(count: int) -> Array:
    """Return -1, 0 or 1 for every one of a row: on the first side, in the middle, on the last side."""
    side: Array = np.sign(2.0 * np.arange(count) - (count - 1))
    return side


def _of_source(own: Array, image: Array, side: Array, source: Source) -> Array:
    """Return each entry as its source has it; what is its own mirror image is the mean of both."""
    stays = {Source.FIRST: side < 0, Source.LAST: side > 0, Source.MEAN: np.zeros_like(side, dtype=bool)}[source]
    comes = {Source.FIRST: side > 0, Source.LAST: side < 0, Source.MEAN: np.zeros_like(side, dtype=bool)}[source]
    result: Array = np.where(stays, own, np.where(comes, image, (own + image) / 2))
    return result
