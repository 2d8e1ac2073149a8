"""Pure functions from one document to the next; each raises DocumentError where the next is not valid."""

from __future__ import annotations

from dataclasses import replace
from enum import StrEnum

import numpy as np
import numpy.typing as npt

from qovr_core.document import Document, Formulation
from qovr_core.errors import DocumentError
from qovr_core.knots import Knots


class Direction(StrEnum):
    """The two families of curves."""

    ROWS = "row_knots"
    COLUMNS = "column_knots"


def knots_of(document: Document, direction: Direction) -> tuple[Knots, ...]:
    """Return the knots of the five curves of a direction."""
    return document.row_knots if direction is Direction.ROWS else document.column_knots


def set_point(document: Document, i: int, j: int, point: npt.ArrayLike) -> Document:
    """Return the document with P_{i,j} at ``point``, (3,)."""
    net = document.control_points.copy()
    net[i, j] = point
    return set_points(document, net)


def set_points(document: Document, control_points: npt.ArrayLike) -> Document:
    """Return the document with another control net, (5, 5, 3)."""
    return replace(document, control_points=np.asarray(control_points, dtype=np.float64))


def set_knots(document: Document, direction: Direction, knots: tuple[Knots, ...]) -> Document:
    """Return the document with the knots of all five curves of a direction replaced."""
    if direction is Direction.ROWS:
        return replace(document, row_knots=knots)
    return replace(document, column_knots=knots)


def set_knot(
    document: Document, direction: Direction, name: str, value: float, *, curve: int | None = None
) -> Document:
    """Return the document with one knot changed.

    Parameters
    ----------
    direction : which family of curves
    name : ``r``, ``s``, ``u`` or ``t``; ``u`` stands for v_ip on column curves
    value : strictly between 0 and 1
    curve : 0 to 4; None sets it on all five curves of the direction
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
