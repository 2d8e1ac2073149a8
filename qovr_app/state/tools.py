"""What the hand does in the view: values that the window keeps from one start to the next."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum

from qovr_core import Document
from qovr_core.checks import LARGEST_MAGNITUDE
from qovr_core.geometry.knots import Direction
from qovr_core.number_texts import natural_step

_SIZES = ("snap_step", "soft_radius")


class Way(StrEnum):
    """Along what a point moves that is dragged itself: its height, the view's plane, or the surface's normal."""

    Z = "z"
    VIEW = "view"
    NORMAL = "normal"


@dataclass(frozen=True)
class ToolSettings:
    """How control points are picked and moved; ``replace`` makes the next one.

    Parameters
    ----------
    way : along what a dragged point moves
    selects : whether a drag draws a rectangle that selects, wherever it begins
    snaps, snap_step : whether a drag keeps to multiples of a step, in the document's units
    soft, soft_radius : whether moves fade out over the points around, and after how many steps along the net
    symmetry_rows, symmetry_columns : whether moves are mirrored across the rows' middle, and the columns'
    xray : whether points behind the surface can be picked
    """

    way: Way = Way.Z
    selects: bool = False
    snaps: bool = False
    snap_step: float = 0.05
    soft: bool = False
    soft_radius: float = 2.0
    symmetry_rows: bool = False
    symmetry_columns: bool = False
    xray: bool = False

    @property
    def symmetries(self) -> tuple[Direction, ...]:
        """Across what moves are mirrored."""
        chosen = {Direction.ROWS: self.symmetry_rows, Direction.COLUMNS: self.symmetry_columns}
        return tuple(direction for direction, is_on in chosen.items() if is_on)


def nudge_step(tools: ToolSettings, document: Document) -> float:
    """Return by how much a nudge moves: the step that drags keep to, or what means something in the net's size."""
    return tools.snap_step if tools.snaps else natural_step(0.0, document.net_size)


def can_be(setting: str, value: object) -> bool:
    """Return whether a setting can have a value: a step and a radius are above 0 and have an end."""
    return setting not in _SIZES or (isinstance(value, float) and 0 < value <= LARGEST_MAGNITUDE)
