"""Pure functions from one document to the next; each raises DocumentError where the next is not valid."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from enum import StrEnum
from typing import Any

import numpy as np
import numpy.typing as npt

from qovr_core.arrays import Array
from qovr_core.document import Document, NetIndex
from qovr_core.errors import DocumentError
from qovr_core.formulations import Formulation
from qovr_core.geometry.knots import Direction, KnotPlace, Knots, knot_array


class Zone(StrEnum):
    """The parts of a document that are set as a whole, by the names of its fields."""

    ROW_KNOTS = "row_knots"
    COLUMN_KNOTS = "column_knots"
    CONTROL_POINTS = "control_points"


@dataclass(frozen=True, slots=True)
class CoordinatePlace:
    """Where one coordinate stands: of P_{i,j} along axis 0, 1 or 2."""

    i: int
    j: int
    axis: int

    def __str__(self) -> str:
        return f"control_points[{self.i}][{self.j}][{self.axis}]"


Place = KnotPlace | CoordinatePlace
"""One number of a document; ``str`` gives it in the document's own words."""


def knots_of(document: Document, direction: Direction) -> tuple[Knots, ...]:
    """Return the knots of the curves of a direction."""
    curves: tuple[Knots, ...] = getattr(document, direction.value)
    return curves


def zone_of(place: Place) -> Zone:
    """Return the part of the document in which a place lies."""
    return Zone.CONTROL_POINTS if isinstance(place, CoordinatePlace) else Zone(place.direction.value)


def check_points(document: Document, indices: Iterable[NetIndex]) -> None:
    """Raise DocumentError where the net has no such points."""
    rows, columns, _ = document.control_points.shape
    for i, j in indices:
        if not (0 <= i < rows and 0 <= j < columns):
            raise DocumentError("the point", f"P {i},{j}", f"one of a net of {rows} x {columns}")


def set_point(document: Document, i: int, j: int, point: npt.ArrayLike) -> Document:
    """Return the document with P_{i,j} at ``point``, (3,)."""
    net = document.control_points.copy()
    net[i, j] = point
    return set_points(document, net)


def set_points(document: Document, control_points: npt.ArrayLike) -> Document:
    """Return the document with another control net, (5, 5, 3)."""
    return replace(document, control_points=np.asarray(control_points, dtype=np.float64))


def set_knots(document: Document, direction: Direction, knots: tuple[Knots, ...]) -> Document:
    """Return the document with the knots of all curves of a direction replaced."""
    family: dict[str, Any] = {direction.value: knots}
    return replace(document, **family)


def set_all_knots(document: Document, knots: Knots) -> Document:
    """Return the document with the same knots on all curves."""
    rows, columns = ((knots,) * len(knots_of(document, direction)) for direction in Direction)
    return replace(document, row_knots=rows, column_knots=columns)


def set_knot(
    document: Document, direction: Direction, name: str, value: float, *, curve: int | None = None
) -> Document:
    """Return the document with one knot changed.

    Parameters
    ----------
    direction : which family of curves
    name : ``r``, ``s``, ``u`` or ``t``; ``u`` stands for v_ip on column curves
    value : strictly between 0 and 1
    curve : 0 to 4; None sets it on all curves of the direction
    """
    curves = list(knots_of(document, direction))
    for k in range(len(curves)) if curve is None else (curve,):
        try:
            curves[k] = replace(curves[k], **{name: value})
        except DocumentError as error:
            raise DocumentError(f"{direction}[{k}].{error.place}", error.found, error.expected) from None
    return set_knots(document, direction, tuple(curves))


def set_formulation(document: Document, formulation: Formulation) -> Document:
    """Return the document with another formulation."""
    return replace(document, formulation=formulation)


def set_samples(document: Document, samples: tuple[int, int]) -> Document:
    """Return the document with other sample counts along u and v."""
    return replace(document, samples=samples)


def value_at(document: Document, place: Place) -> float:
    """Return the number that stands at a place."""
    if isinstance(place, CoordinatePlace):
        return float(document.control_points[place.i, place.j, place.axis])
    value: float = getattr(knots_of(document, place.direction)[place.curve], place.name)
    return value


def set_values(document: Document, values: Mapping[Place, float]) -> Document:
    """Return the document with several numbers changed, all or none of them.

    Raises
    ------
    DocumentError : a value is not valid at its place
    """
    net = document.control_points.copy()
    curves = {direction: list(knots_of(document, direction)) for direction in Direction}
    for place, value in values.items():
        if isinstance(place, CoordinatePlace):
            net[place.i, place.j, place.axis] = value
            continue
        try:
            changed = replace(curves[place.direction][place.curve], **{place.name: value})
        except DocumentError as error:
            raise DocumentError(str(place), error.found, error.expected) from None
        curves[place.direction][place.curve] = changed
    rows, columns = (tuple(curves[direction]) for direction in Direction)
    return replace(document, control_points=net, row_knots=rows, column_knots=columns)


def linked_places(document: Document, place: KnotPlace, *, curves: bool, directions: bool) -> tuple[KnotPlace, ...]:
    """Return the places that change together with one knot.

    Parameters
    ----------
    curves : whether all curves of a direction share their knots
    directions : whether both directions share their knots, curve by curve, where both have that curve
    """
    return tuple(
        KnotPlace(family, number, place.name)
        for family in (Direction if directions else (place.direction,))
        for number in range(len(knots_of(document, family)))
        if curves or number == place.curve
    )


def copy_zone(source: Document, target: Document, zone: Zone) -> Document:
    """Return ``target`` with one zone as it stands in ``source``."""
    return replace(target, **{zone.value: getattr(source, zone.value)})


def rebase(draft: Document, before: Document, after: Document) -> Document:
    """Return ``draft`` on new ground: what it changed in ``before`` stays, everything else is as in ``after``."""

    def merged(mine: Array, old: Array, new: Array) -> Array:
        return np.where(mine == old, new, mine)

    nets = (document.control_points for document in (draft, before, after))
    families = [
        merged(*(knot_array(knots_of(document, direction)) for document in (draft, before, after)))
        for direction in Direction
    ]
    rows, columns = (tuple(Knots(*knots) for knots in family.tolist()) for family in families)
    return replace(after, control_points=merged(*nets), row_knots=rows, column_knots=columns)
