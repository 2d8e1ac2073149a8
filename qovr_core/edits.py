"""Pure functions from one document to the next; each raises DocumentError where the next is not valid."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from enum import StrEnum
from typing import Any

import numpy as np
import numpy.typing as npt

from qovr_core.arrays import Array
from qovr_core.checks import checked_knot
from qovr_core.document import ALIKE_WHERE_CLOSED, Document, NetIndex, Window
from qovr_core.errors import DocumentError
from qovr_core.formulations import Formulation
from qovr_core.geometry.knots import KNOT_NAMES, Direction, KnotPlace, Knots, KnotTable
from qovr_core.geometry.locate import spread
from qovr_core.geometry.windows import NET_SIZE, STEP
from qovr_core.joints import Joint


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


def knots_of(document: Document, direction: Direction) -> KnotTable:
    """Return the knots of the curves of a direction."""
    return document.row_knots if direction is Direction.ROWS else document.column_knots


def zone_of(place: Place) -> Zone:
    """Return the part of the document in which a place lies."""
    return Zone.CONTROL_POINTS if isinstance(place, CoordinatePlace) else Zone(place.direction.value)


def check_points(document: Document, indices: Iterable[NetIndex]) -> None:
    """Raise DocumentError where the net has no such points."""
    rows, columns, _ = document.control_points.shape
    for i, j in indices:
        if not (0 <= i < rows and 0 <= j < columns):
            raise DocumentError("the point", f"P {i},{j}", f"one of a net of {rows} x {columns}")


def check_window(document: Document, window: Window) -> None:
    """Raise DocumentError where the net has no such window."""
    (m, n), (a, b) = document.windows, window
    if not (0 <= a < m and 0 <= b < n):
        raise DocumentError("the window", f"{a},{b}", f"one of 0,0 to {m - 1},{n - 1}")


def set_point(document: Document, i: int, j: int, point: npt.ArrayLike) -> Document:
    """Return the document with P_{i,j} at ``point``, (3,)."""
    net = document.control_points.copy()
    net[i, j] = point
    return set_points(document, net)


def set_points(document: Document, control_points: npt.ArrayLike) -> Document:
    """Return the document with another control net of the same shape.

    Where the net is closed, what is changed on one side of the seam is changed on the other.
    """
    net = np.array(control_points, dtype=np.float64)
    for direction in Direction:
        if document.is_closed(direction) and net.shape == document.control_points.shape:
            axis = 1 if direction is Direction.ROWS else 0
            _close(np.moveaxis(net, axis, 0), np.moveaxis(document.control_points, axis, 0))
    return replace(document, control_points=net)


def set_knots(document: Document, direction: Direction, knots: Array) -> Document:
    """Return the document with the knots of all curves of a direction replaced, (curves, windows, 4)."""
    changes: dict[str, Any] = {direction.value: knots}
    return replace(document, **changes)


def set_all_knots(document: Document, knots: Knots) -> Document:
    """Return the document with the same knots on all curves."""
    tables = (np.broadcast_to(tuple(knots), knots_of(document, direction).array.shape) for direction in Direction)
    return replace(document, **dict(zip(Direction, tables, strict=True)))


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
    return float(knots_of(document, place.direction).array[place.curve, place.window, place.number])


def set_values(document: Document, values: Mapping[Place, float]) -> Document:
    """Return the document with several numbers changed, all or none of them.

    What has to stay alike changes together: the knots that a smooth joint shares, and both sides of a closed net's
    seam. Of two values for one number, the last counts.

    Raises
    ------
    DocumentError : a value is not valid at its place
    """
    net = document.control_points.copy()
    tables = {direction: knots_of(document, direction).array.copy() for direction in Direction}
    changed = set()
    for place, value in values.items():
        if isinstance(place, CoordinatePlace):
            net[place.i, place.j, place.axis] = value
            continue
        changed.add(place.direction)
        number = checked_knot(value, place.text(knots_of(document, place.direction).windows))
        for curves, window, knot in shared_knots(document, place):
            tables[place.direction][curves, window, knot] = number
    knots: dict[str, Any] = {str(direction): tables[direction] for direction in changed}
    moved = set_points(document, net) if len(changed) < len(values) else document
    return replace(moved, **knots) if knots else moved


def shared_knots(document: Document, place: KnotPlace) -> list[tuple[slice | list[int], int, int]]:
    """Return what has to stay alike with one knot: which curves, in which window along them, which of their knots.

    A smooth joint shares t before it, r after it and u in both windows over all curves; across the seam of a closed net
    the first three curves are the last three.
    """
    direction, name = place.direction, place.name
    joints, windows = document.joints.along(direction), knots_of(document, direction).windows
    smooth = [k for k, joint in enumerate(joints) if joint is Joint.SMOOTH]
    before, after = (place.window - 1) % windows, place.window
    if name == "t" and after in smooth:
        return [(slice(None), after, place.number), (slice(None), (after + 1) % windows, KNOT_NAMES.index("r"))]
    if name == "r" and before in smooth:
        return [(slice(None), before, KNOT_NAMES.index("t")), (slice(None), after, place.number)]
    if name == "u" and {before, after} & set(smooth):
        return [(slice(None), after, place.number)]
    return [(_same_curves(document, place), place.window, place.number)]


def _same_curves(document: Document, place: KnotPlace) -> list[int]:
    """Return the curve, and in a net that closes across its direction the one that is the same."""
    last = len(knots_of(document, place.direction)) - ALIKE_WHERE_CLOSED
    if not document.is_closed(place.direction.other):
        return [place.curve]
    return sorted(
        {place.curve, *(k for k in (place.curve - last, place.curve + last) if 0 <= k < last + ALIKE_WHERE_CLOSED)}
    )


def linked_places(
    document: Document, place: KnotPlace, *, curves: bool, directions: bool, windows: bool = False
) -> tuple[KnotPlace, ...]:
    """Return the places that change together with one knot.

    Parameters
    ----------
    curves : whether all curves of a direction share their knots
    directions : whether both directions share their knots, curve by curve and window by window, where both have them
    windows : whether all windows of a curve share their knots
    """
    return tuple(
        KnotPlace(family, number, place.name, window)
        for family in (Direction if directions else (place.direction,))
        for number in range(len(knots_of(document, family)))
        if curves or number == place.curve
        for window in range(knots_of(document, family).windows)
        if windows or window == place.window
    )


def extract_window(document: Document, window: Window) -> Document:
    """Return one window (a, b) of a net as a document of its own, with the intervals between samples that it has.

    Its raw surface is the same; T is made anew from its own boxes.

    Raises
    ------
    DocumentError : there is no such window
    """
    check_window(document, window)
    if document.is_one_window:
        return document
    (m, n), (a, b) = document.windows, window
    rows, columns = slice(STEP * a, STEP * a + NET_SIZE), slice(STEP * b, STEP * b + NET_SIZE)
    counts = zip(document.samples, (n, m), (b, a), strict=True)
    return Document(
        document.control_points[rows, columns],
        document.row_knots.array[rows, b : b + 1],
        document.column_knots.array[columns, a : a + 1],
        document.formulation,
        [int(spread(samples, windows)[k]) + 1 for samples, windows, k in counts],
    )


def copy_zone(source: Document, target: Document, zone: Zone) -> Document:
    """Return ``target`` with one zone as it stands in ``source``."""
    return replace(target, **{zone.value: getattr(source, zone.value)})


def rebase(draft: Document, before: Document, after: Document) -> Document:
    """Return ``draft`` on new ground: what it changed in ``before`` stays, everything else is as in ``after``.

    On a net of another shape there is nothing that could stay, and no knots along which other joints are smooth.
    """
    if (before.windows, before.closed) != (after.windows, after.closed):
        return after

    def merged(mine: Array, old: Array, new: Array) -> Array:
        return np.where(mine == old, new, mine)

    documents = (draft, before, after)
    nets = (document.control_points for document in documents)
    alike = [direction for direction in Direction if before.joints.along(direction) == after.joints.along(direction)]
    knots: dict[str, Any] = {
        str(direction): merged(*(knots_of(document, direction).array for document in documents)) for direction in alike
    }
    return replace(after, control_points=merged(*nets), **knots)


def _close(net: Array, before: Array) -> None:
    """Bring the first three and the last three of a closed net's lines together again: those that have moved lead."""
    first, last = slice(None, ALIKE_WHERE_CLOSED), slice(len(net) - ALIKE_WHERE_CLOSED, None)
    net[first] = net[last] = np.where(net[last] != before[last], net[last], net[first])
