"""Symmetry of a document across its rows or its columns: of the points, and of the knots."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from enum import StrEnum
from typing import Any

import numpy as np

from qovr_core.arrays import Array
from qovr_core.document import Document
from qovr_core.edits import CoordinatePlace, Place, knots_of, value_at
from qovr_core.errors import DocumentError
from qovr_core.geometry.knots import KNOT_NAMES, Direction, KnotPlace
from qovr_core.joints import Joint
from qovr_core.net_moves import COLUMNS_MIRROR, ROWS_MIRROR, Mirror

MIRRORS = {Direction.ROWS: ROWS_MIRROR, Direction.COLUMNS: COLUMNS_MIRROR}
"""The plane in which rows, or columns, mirror each other."""

_REVERSED = {"r": "t", "s": "s", "u": "u", "t": "r"}
"""Which knot takes the place of which where a curve runs the other way; its value is 1 minus the other's."""

OTHER_END = [KNOT_NAMES.index(_REVERSED[name]) for name in KNOT_NAMES]
"""The same by their places in ``KNOT_NAMES``."""

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
    paired = knots_of(document, across).array
    paired = _of_source(paired, paired[::-1], _sides(len(paired))[:, None, None], source)
    turned = knots_of(document, across.other).array
    side = _sides(turned.shape[1])[:, None]
    turned = _of_source(turned, reversed_knots(turned), np.where(side == 0, _KNOT_SIDES, side), source)
    joints = _mirrored_joints(document, across.other, source)
    _settle_own_joints(turned, joints)
    changes: dict[str, Any] = {"control_points": net, str(across): paired, str(across.other): turned}
    return replace(document, **changes, joints=replace(document.joints, **{across.other.parameter: joints}))


def reversed_knots(knots: Array) -> Array:
    """Return knots (curves, windows, 4) as they are where the curves run the other way: (1-t, 1-s, 1-u, 1-r)."""
    reverse: Array = 1 - knots[:, ::-1, OTHER_END]
    return reverse


def _mirrored_joints(document: Document, along: Direction, source: Source) -> tuple[Joint, ...]:
    """Return the joints that the curves of a direction cross as their own mirror image: as on the source's side, and
    for the mean smooth where both are. The seam of a closed net, which comes last, is one already."""
    inner = knots_of(document, along).windows - 1
    smooth = document.joints.smooth(along).astype(np.float64)
    smooth[:inner] = _of_source(smooth[:inner], smooth[:inner][::-1], _sides(inner), source)
    return tuple(Joint.SMOOTH if value == 1 else Joint.SHARP for value in smooth)


def _settle_own_joints(knots: Array, joints: tuple[Joint, ...]) -> None:
    """Give the smooth joints that are their own mirror images, in the middle and at a seam, the one tau that is so."""
    windows = knots.shape[1]
    own = {windows - 1} if windows % 2 else {windows - 1, windows // 2 - 1}
    for joint in own:
        if joint < len(joints) and joints[joint] is Joint.SMOOTH:
            knots[:, joint, KNOT_NAMES.index("t")] = knots[:, (joint + 1) % windows, KNOT_NAMES.index("r")] = 0.5


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
            return replace(place, curve=last - place.curve), value
        last = knots_of(document, place.direction).windows - 1
        return KnotPlace(place.direction, place.curve, _REVERSED[place.name], last - place.window), 1 - value
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
