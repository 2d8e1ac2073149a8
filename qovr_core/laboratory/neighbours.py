"""The patches on both sides of joints: those of a net, or of one window and of its continuation (Lemmas 1 and 2)."""

from __future__ import annotations

from dataclasses import dataclass, replace
from enum import StrEnum

import numpy as np

from qovr_core.arrays import Array
from qovr_core.construction import build_patch, window_rounding
from qovr_core.document import Document
from qovr_core.edits import knots_of
from qovr_core.geometry.knots import Direction, KnotTable
from qovr_core.geometry.patch import Patch
from qovr_core.geometry.windows import STEP
from qovr_core.joints import joint_count, window_lengths

CONTINUATION_SEED = 7
"""The two further columns (rows) of the larger net are drawn from this seed."""

_DRAWN = 0.25
"""Drawn points leave the affine continuation by up to this part of the net's longest side."""


class Continuation(StrEnum):
    """How the net goes on: drawn at random, or reflected through its last line, as an affine net goes on itself."""

    DRAWN = "drawn"
    REFLECTED = "reflected"


@dataclass(frozen=True, eq=False)
class Sides:
    """What meets at the joints that the curves of one direction cross.

    Parameters
    ----------
    across : that direction
    windows : how many windows there are along it
    before, after : (joints, windows, 7, 7, 3) patches that end and that begin there, the crossing parameter first;
        windows are counted along the joint
    noise : (joints, windows, 3) up to what size a difference of their coefficients is no more than rounding
    lengths : (joints, 2) of the windows before and after along that direction
    """

    across: Direction
    windows: int
    before: Array
    after: Array
    noise: Array
    lengths: Array


@dataclass(frozen=True, eq=False)
class Neighbours:
    """Two documents of one window, joined at the first's 1 and the second's 0.

    Parameters
    ----------
    across : the direction in which the second lies
    first, second : documents on the larger net's first and last columns (along the rows) or rows; the curves they share
        keep their knots
    """

    across: Direction
    first: Document
    second: Document

    def sides(self, of_first: _Surface | None = None) -> Sides:
        """Return what meets at their joint.

        Parameters
        ----------
        of_first : the first's surface, where it is known

        Raises
        ------
        EvaluationError : a neighbour has no finite surface
        """
        surfaces = of_first or _surface(self.first), _surface(self.second)
        (before, own), (after, others) = (_crossing(*surface, self.across) for surface in surfaces)
        return Sides(self.across, 2, before, after, own + others, np.ones((1, 2)))


def document_sides(document: Document) -> tuple[Sides, ...]:
    """Return what meets at every joint of a net; of one window, at the two that it would have if it were continued.

    Raises
    ------
    DocumentError : a net of one window is so large that its continuation would be no document
    EvaluationError : there is no finite surface
    """
    if document.is_one_window:
        return continued_sides(document, Continuation.DRAWN)
    patch, rounding = _surface(document)
    sides = []
    for direction in Direction:
        patches, noise = _crossing(patch, rounding, direction)
        along = window_lengths(knots_of(document, direction), document.joints.along(direction))
        count = joint_count(len(patches), document.is_closed(direction))
        if count:
            after, more, others = (np.roll(array, -1, axis=0)[:count] for array in (patches, noise, along))
            own = np.stack([along[:count], others], axis=1)
            sides.append(Sides(direction, len(patches), patches[:count], after, noise[:count] + more, own))
    return tuple(sides)


def continued_sides(document: Document, continuation: Continuation) -> tuple[Sides, ...]:
    """Return what meets at the joints of a document of one window with its neighbours.

    Raises
    ------
    DocumentError : the net is so large that its continuation would be no document
    EvaluationError : there is no finite surface
    """
    own = _surface(document)
    return tuple(neighbours.sides(own) for neighbours in continued(document, continuation))


_Surface = tuple[Patch, Array]


def _surface(document: Document) -> _Surface:
    """Return a document's surface, and what is rounding in each of its windows, (m, n, 3)."""
    return build_patch(document), window_rounding(document)


def _crossing(patch: Patch, rounding: Array, direction: Direction) -> tuple[Array, Array]:
    """Return the patches of all windows, (windows across, windows along, 7, 7, 3), and their rounding, (..., 3)."""
    if direction is Direction.COLUMNS:
        return patch.coefficients.swapaxes(2, 3), rounding
    return patch.coefficients.swapaxes(0, 1), rounding.swapaxes(0, 1)


def continued(document: Document, continuation: Continuation) -> tuple[Neighbours, Neighbours]:
    """Return a document of one window joined with its neighbour across u = 1 and with that across v = 1.

    The neighbour across u takes the row knots of the document, the column knots of its K_2, K_3, K_4 for its K_0,
    K_1, K_2, and those of K_3 and K_4 for its new curves; across v likewise.

    Raises
    ------
    DocumentError : the net is so large that what goes on from it, up to four times as far, would be no document
    """
    net = document.control_points
    rows, columns = (
        KnotTable(np.concatenate([knots.array[STEP:], knots.array[-STEP:]]))
        for knots in (document.row_knots, document.column_knots)
    )
    across_u = _continued(net.swapaxes(0, 1), continuation).swapaxes(0, 1)
    across_v = _continued(net, continuation)
    return (
        Neighbours(Direction.ROWS, document, replace(document, control_points=across_u, column_knots=columns)),
        Neighbours(Direction.COLUMNS, document, replace(document, control_points=across_v, row_knots=rows)),
    )


def _continued(net: Array, continuation: Continuation) -> Array:
    """Return the net of the neighbour beyond the last index of the first axis."""
    beyond = 2 * net[-1] - net[[-2, -3]]
    if continuation is Continuation.DRAWN:
        rng = np.random.default_rng(CONTINUATION_SEED)
        extent = np.ptp(net, axis=(0, 1)).max() or 1.0
        beyond = beyond + _DRAWN * extent * rng.uniform(-1, 1, beyond.shape)
    return np.concatenate([net[STEP:], beyond])
