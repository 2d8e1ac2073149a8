"""What the user wants of the selected control points, as values; moves by hand are in ``intents``."""

from __future__ import annotations

from dataclasses import dataclass

from qovr_app.state.intents import Intent
from qovr_core.document import NetIndex
from qovr_core.geometry.knots import Direction
from qovr_core.net_edits import NetEdit
from qovr_core.symmetry import Source


@dataclass(frozen=True)
class PointsNudged(Intent):
    """Control points are moved by one step each.

    Parameters
    ----------
    at : seconds of a clock that runs evenly; what follows within a second is the same undo step
    """

    indices: tuple[NetIndex, ...]
    displacement: tuple[float, float, float]
    at: float


@dataclass(frozen=True)
class PointsEdited(Intent):
    """An edit brings control points to other places; ``indices`` begin with the one that was picked last.

    With a ``gesture``, 0 for none, from where they stood when it began.
    """

    edit: NetEdit
    indices: tuple[NetIndex, ...]
    gesture: int = 0


@dataclass(frozen=True)
class MadeSymmetric(Intent):
    """Net and knots become their own mirror image, across rows or columns."""

    across: Direction
    source: Source
