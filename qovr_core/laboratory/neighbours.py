"""Two patches of one larger net, joined as the paper joins them (Lemmas 1 and 2, Theorem 1)."""

from __future__ import annotations

from dataclasses import dataclass, replace
from enum import StrEnum

import numpy as np

from qovr_core.arrays import Array
from qovr_core.construction import build_patch, surface_rounding
from qovr_core.document import Document
from qovr_core.geometry import bernstein
from qovr_core.geometry.knots import KnotTable
from qovr_core.geometry.patch import PATCH_DEGREE
from qovr_core.geometry.rounding import part_of

CONTINUATION_SEED = 7
"""The two further columns (rows) of the larger net are drawn from this seed."""

_SHIFT = 2
"""Neighbours share three columns (rows): the second begins two further on."""

_DRAWN = 0.25
"""Drawn points leave the affine continuation by up to this part of the net's longest side."""

_ORDERS = 3
"""Position, first and second cross derivative."""

_ALONG = np.linspace(0, 1, 41)
"""Where along a joint its sides are compared."""


class Across(StrEnum):
    """The direction in which the neighbour lies."""

    U = "u"
    V = "v"


class Continuation(StrEnum):
    """How the net goes on: drawn at random, or reflected through its last line, as an affine net goes on itself."""

    DRAWN = "drawn"
    REFLECTED = "reflected"


@dataclass(frozen=True, eq=False)
class Joint:
    """Two neighbours, joined at the first's 1 and the second's 0.

    Parameters
    ----------
    across : the parameter that crosses the joint
    first, second : documents on the larger net's first and last columns (``u``) or rows (``v``); the curves
        they share keep their knots
    """

    across: Across
    first: Document
    second: Document

    def jumps(self) -> tuple[Jump, ...]:
        """Return how position, first and second cross derivative jump, from the exact patches.

        Raises
        ------
        EvaluationError : a neighbour has no finite surface
        """
        first, second = (self._crossing(document) for document in (self.first, self.second))
        size = max(float(np.ptp(patch, axis=(0, 1)).max()) for patch in (first, second))
        noise = surface_rounding(self.first) + surface_rounding(self.second)
        jumps = []
        for _ in range(_ORDERS):
            difference = bernstein.basis(PATCH_DEGREE, _ALONG) @ (first[-1] - second[0])
            distance = float(np.linalg.norm(difference, axis=-1).max())
            jumps.append(Jump(part_of(distance, size), bool((np.abs(difference) <= noise).all())))
            noise = noise * 2 * (len(first) - 1)  # a derivative is so often a difference of two coefficients
            first, second = bernstein.derivative(first, 0), bernstein.derivative(second, 0)
        return tuple(jumps)

    def _crossing(self, document: Document) -> Array:
        """Return the document's patch as coefficients (7, 7, 3) with the crossing parameter first."""
        coefficients: Array = build_patch(document).coefficients[0, 0]
        return coefficients if self.across is Across.U else coefficients.swapaxes(0, 1)


@dataclass(frozen=True)
class Jump:
    """How far two neighbours differ along their joint.

    Parameters
    ----------
    part : the largest difference as part of the size of the larger patch (per unit of the parameter for
        derivatives)
    is_rounding : whether it is no more than rounding
    """

    part: float
    is_rounding: bool


def joints(document: Document, continuation: Continuation) -> tuple[Joint, Joint]:
    """Return the document joined with its neighbour across u = 1 and with that across v = 1.

    The neighbour across u takes the row knots of the document, the column knots of its K_2, K_3, K_4 for its K_0,
    K_1, K_2, and those of K_3 and K_4 for its new curves; across v likewise.

    Raises
    ------
    DocumentError : the net is so large that what goes on from it, up to four times as far, would be no document
    """
    net = document.control_points
    rows, columns = (
        KnotTable(np.concatenate([knots.array[_SHIFT:], knots.array[-_SHIFT:]]))
        for knots in (document.row_knots, document.column_knots)
    )
    across_u = _continued(net.swapaxes(0, 1), continuation).swapaxes(0, 1)
    return (
        Joint(Across.U, document, replace(document, control_points=across_u, column_knots=columns)),
        Joint(Across.V, document, replace(document, control_points=_continued(net, continuation), row_knots=rows)),
    )


def _continued(net: Array, continuation: Continuation) -> Array:
    """Return the net of the neighbour beyond the last index of the first axis."""
    beyond = 2 * net[-1] - net[[-2, -3]]
    if continuation is Continuation.DRAWN:
        rng = np.random.default_rng(CONTINUATION_SEED)
        extent = np.ptp(net, axis=(0, 1)).max() or 1.0
        beyond = beyond + _DRAWN * extent * rng.uniform(-1, 1, beyond.shape)
    return np.concatenate([net[_SHIFT:], beyond])
