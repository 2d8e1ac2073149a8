"""What the hand does in the view: values that the window keeps from one start to the next."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum

from qovr_core import Document, DocumentError
from qovr_core.checks import LARGEST_MAGNITUDE, checked_number, described
from qovr_core.geometry.knots import Direction
from qovr_core.net_moves import COLUMNS_MIRROR, ROWS_MIRROR, Mirror
from qovr_core.number_texts import natural_step

SETTING_NAMES = {"snap_step": "the snap step", "soft_radius": "the soft radius"}
"""What messages call the settings that are numbers."""


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
    mirror_rows, mirror_columns : in which planes
    measures : whether a click measures, and changes nothing
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
    mirror_rows: Mirror = ROWS_MIRROR
    mirror_columns: Mirror = COLUMNS_MIRROR
    measures: bool = False
    xray: bool = False

    @property
    def symmetries(self) -> tuple[Direction, ...]:
        """Across what moves are mirrored."""
        chosen = {Direction.ROWS: self.symmetry_rows, Direction.COLUMNS: self.symmetry_columns}
        return tuple(direction for direction, is_on in chosen.items() if is_on)

    def mirror(self, across: Direction) -> Mirror:
        """Return the plane in which rows, or columns, mirror each other."""
        return self.mirror_rows if across is Direction.ROWS else self.mirror_columns


def nudge_step(tools: ToolSettings, document: Document) -> float:
    """Return by how much a nudge moves: the step that drags keep to, or what means something in the net's size."""
    return tools.snap_step if tools.snaps else natural_step(0.0, document.net_size)


def checked_size(value: object, place: str) -> float:
    """Return a step or a radius; anything but a number above 0 that has an end raises DocumentError."""
    if not (isinstance(value, float) and 0 < value <= LARGEST_MAGNITUDE):
        raise DocumentError(place, described(value), f"a number above 0, at most {LARGEST_MAGNITUDE:g}")
    return value


def check_setting(setting: str, value: object) -> None:
    """Raise DocumentError where a setting cannot have a value."""
    if setting in SETTING_NAMES:
        checked_size(value, SETTING_NAMES[setting])
    if isinstance(value, Mirror) and value.at is not None:
        checked_number(value.at, "the place of the symmetry plane")
