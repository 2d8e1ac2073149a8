"""What an edit of a net's structure comes to: the next document, by how much the surface moves, and what went where."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from qovr_core.arrays import Array, Indices, read_only
from qovr_core.construction import document_arrays, overflow_error
from qovr_core.document import Document
from qovr_core.edits import knots_of
from qovr_core.errors import QovrError
from qovr_core.formulations import Formulation
from qovr_core.geometry import bernstein
from qovr_core.geometry.knots import Direction
from qovr_core.geometry.patch import PATCH_DEGREE, Patch
from qovr_core.geometry.windows import window_count
from qovr_core.joints import joint_count
from qovr_core.net_input import MOST_POINTS

FEWEST_WHERE_CLOSED, MOST_WINDOWS = 2, window_count(MOST_POINTS)
"""Windows along the curves of a direction: a net that closes there has two or more, and none has more than the most."""

_INTERVALS = 16

PLACES = read_only(np.linspace(0.0, 1.0, _INTERVALS + 1))
"""The places of a window, each way, at which the motion of the surface is measured."""

_ON_ONE_SURFACE = "{doing} needs windows that meet; those of the {name} formulation do not: choose interpolating first"


@dataclass(frozen=True, eq=False)
class NetChange:
    """The outcome of an edit that moves the surface or renumbers its points.

    Parameters
    ----------
    document : the next document
    motion : the largest distance of a point of the raw surface from where the same point was, measured on 17 x 17
        samples of every window it touches; None where windows do not meet, so that there is no one surface
    origin : which column (for an edit along column curves: row) each one was before, -1 where it is new; None where
        all are new
    """

    document: Document
    motion: float | None
    origin: Indices | None


def unmoved_lines(document: Document, direction: Direction) -> Indices:
    """Return the origin of an edit along a direction's curves that renumbers nothing."""
    return read_only(np.arange(document.control_points.shape[1 if direction is Direction.ROWS else 0]))


def motion_between(
    before: Document, after: Document, direction: Direction, spans: Mapping[int, tuple[float, float]]
) -> float | None:
    """Return how far apart the raw surfaces of two documents are; None where windows do not meet.

    Parameters
    ----------
    direction : along whose curves windows were changed
    spans : for every window along them in ``after`` that is touched, which part of ``before`` it was: from where to
        where, each as window + place in it

    Raises
    ------
    EvaluationError : coordinates overflow there
    """
    if not after.formulation.is_continuous and max(*before.windows, *after.windows) > 1:
        return None
    sides = (
        _points(document, direction, parts)
        for document, parts in ((before, list(spans.values())), (after, [(window, window + 1) for window in spans]))
    )
    return largest_distance(*sides)


def _points(document: Document, direction: Direction, parts: Sequence[tuple[float, float]]) -> Array:
    """Return points of some parts of windows along the curves of a direction, in all windows beside each other.

    Returns
    -------
    (parts, places along, windows across, places across, 3) float64
    """
    windows = [int((start + end) / 2) for start, end in parts]
    chosen = (slice(None), windows) if direction is Direction.ROWS else (windows, slice(None))
    with np.errstate(all="ignore"):  # what overflows is refused just below, in words
        coefficients = document.formulation.build(*(array[chosen] for array in document_arrays(document)))
    if not np.isfinite(coefficients).all():
        raise overflow_error(document)
    if direction is Direction.COLUMNS:
        coefficients = coefficients.transpose(1, 0, 3, 2, 4)
    along = [
        bernstein.basis(PATCH_DEGREE, start - window + (end - start) * PLACES)
        for (start, end), window in zip(parts, windows, strict=True)
    ]
    across = bernstein.basis(PATCH_DEGREE, PLACES)
    m, n, degrees = *coefficients.shape[:2], PATCH_DEGREE + 1
    curves = np.stack(along) @ coefficients.transpose(1, 2, 0, 4, 3).reshape(n, degrees, -1)
    points = curves.reshape(n, len(PLACES), m, 3, degrees) @ across.T
    return np.moveaxis(points, 3, -1)


def largest_distance(points: Array, others: Array) -> float:
    """Return the largest distance between points of two arrays (..., 3)."""
    return float(np.linalg.norm(points - others, axis=-1).max(initial=0.0))


def check_continuous(formulation: Formulation, doing: str) -> None:
    """Raise QovrError where windows do not meet along whole curves, so that an edit across them makes no sense."""
    if not formulation.is_continuous:
        raise QovrError(_ON_ONE_SURFACE.format(doing=doing, name=formulation))


def check_window(document: Document, direction: Direction, window: int) -> None:
    """Raise QovrError where the curves of a direction run through no such window."""
    windows = knots_of(document, direction).windows
    if not 0 <= window < windows:
        raise QovrError(
            f"There is no window {window} along {direction.parameter}; expected one from 0 to {windows - 1}"
        )


def check_joint(document: Document, direction: Direction, joint: int) -> None:
    """Raise QovrError where the curves of a direction cross no such joint."""
    joints = joint_count(knots_of(document, direction).windows, document.is_closed(direction))
    if joints == 0:
        raise QovrError(f"The net has one window along {direction.parameter}, so no joint; append a window first")
    if not 0 <= joint < joints:
        raise QovrError(f"There is no joint {joint} along {direction.parameter}; expected one from 0 to {joints - 1}")


def check_room(document: Document, direction: Direction) -> None:
    """Raise QovrError where no further window fits."""
    if knots_of(document, direction).windows >= MOST_WINDOWS:
        raise QovrError(
            f"The net has {MOST_WINDOWS} windows along {direction.parameter}, the most there may be; remove one first"
        )


def by_windows(patch: Patch) -> Patch:
    """Return the patch over windows of length 1, so that its parameters are window + place in it."""
    return Patch(patch.coefficients, patch.degree)
