"""What the mouse does in a viewport, as far as it is seen: values for the overlay."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum

from qovr_app.view3d.scene.grip import Freedom
from qovr_app.view3d.scene.knot_handles import KnotHandle
from qovr_core.arrays import Array
from qovr_core.document import NetIndex
from qovr_core.geometry.knots import KnotPlace

Band = tuple[float, float, float, float]
"""Left, top, right and bottom of a rectangle that is drawn with the mouse, in logical pixels."""


class MenuPlace(StrEnum):
    """What a menu is asked for."""

    KNOT = "knot"
    POINT = "point"
    NET_LINE = "net line"
    COLOUR_BAR = "colour bar"
    VIEW = "view"


@dataclass(frozen=True)
class MenuWish:
    """A menu that is wanted.

    Parameters
    ----------
    place : what it is for
    points : the control points there, the nearest first, or those of the line
    knot : the knot whose handle is there, or one of the curve that is; None elsewhere
    """

    place: MenuPlace
    points: tuple[NetIndex, ...] = ()
    knot: KnotPlace | None = None


@dataclass(frozen=True, eq=False)
class DragMarks:
    """A drag of control points.

    Parameters
    ----------
    indices : the points, the one in the hand first
    begun : (k, 3) where they were when the drag began, in the document's units
    ways : (m, 3) unit vectors of the unit space along which the one in the hand moves; m is 0 in the view's plane
    freedom : what may change
    typed : the number that is being typed
    is_difference : whether what is typed is the way, and not a coordinate
    is_new : whether the drag has only just begun
    """

    indices: tuple[NetIndex, ...]
    begun: Array
    ways: Array
    freedom: Freedom
    typed: str = ""
    is_difference: bool = False
    is_new: bool = True


@dataclass(frozen=True, eq=False)
class KnotMarks:
    """The handle of a knot that is under the mouse or in the hand.

    Parameters
    ----------
    place : which knot
    begun : the handle as it was when the drag began; None while the mouse is only over it
    typed : the number that is being typed
    is_possible : whether that can be a knot
    is_new : whether the drag has only just begun
    """

    place: KnotPlace
    begun: KnotHandle | None = None
    typed: str = ""
    is_possible: bool = True
    is_new: bool = True


@dataclass(frozen=True, eq=False)
class Hand:
    """Everything that is seen of the mouse in one viewport.

    Parameters
    ----------
    freedom : of the part of the gizmo that is under the mouse or in use; None for none
    drag : the points that are being moved; None for none
    band : the rectangle that selects; None for none
    knot : the handle of a knot that is under the mouse or in use; None for none
    view : the named view for which the axes in the corner are under the mouse; empty for none
    """

    freedom: Freedom | None = None
    drag: DragMarks | None = None
    band: Band | None = None
    knot: KnotMarks | None = None
    view: str = ""
