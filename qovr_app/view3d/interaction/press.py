"""One press of a button of the mouse, and what it does."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum

from PySide6.QtCore import QPointF, Qt

from qovr_app.state.looking_intents import Picking
from qovr_app.view3d.interaction.mouse_schemes import Motion
from qovr_app.view3d.interaction.picking import points_under
from qovr_app.view3d.scene.camera import Size
from qovr_app.view3d.scene.measuring import Spot
from qovr_app.view3d.scene.picture import Picture
from qovr_app.view3d.scene.probing import parameters_under
from qovr_app.view3d.scene.triad import view_under
from qovr_core.arrays import Array
from qovr_core.document import NetIndex


class Doing(StrEnum):
    """What a press does."""

    MOVE = "move points"
    LOOK = "move the camera"
    SELECT = "draw a rectangle"
    WAIT = "wait for the release"


@dataclass
class Press:
    """One press, from the button going down to its release.

    Parameters
    ----------
    button, at : which button, and the pixel where it went down
    doing : what the press does
    motion, pivot : how it moves the camera, and about which point (3,) of the unit space an orbit turns
    point : the control point that a click without a move means
    picking : what it does to the selection
    asks : what a click without a move asks for: the name of a view, or a place to measure from or to; None for nothing
    has_moved : whether it has become a drag
    """

    button: Qt.MouseButton
    at: QPointF
    doing: Doing
    motion: Motion | None = None
    pivot: Array | None = None
    point: NetIndex | None = None
    picking: Picking = Picking.REPLACE
    asks: str | Spot | None = None
    has_moved: bool = False


def picking_of(modifiers: Qt.KeyboardModifier) -> Picking:
    """Return what points do to the selection that are picked with modifiers held."""
    if modifiers & Qt.KeyboardModifier.ShiftModifier:
        return Picking.ADD
    return Picking.TOGGLE if modifiers & Qt.KeyboardModifier.ControlModifier else Picking.REPLACE


def press_to_look(at: QPointF, picture: Picture, size: Size) -> Press | None:
    """Return what a press of the left button begins that changes nothing: on the axes in the corner, or to measure."""
    x, y = at.x(), at.y()
    view = view_under(picture.settings, picture.camera, size, x, y)
    if not view and not picture.tools.measures:
        return None
    return Press(Qt.MouseButton.LeftButton, at, Doing.LOOK, Motion.ORBIT, asks=view or _spot_under(picture, size, x, y))


def _spot_under(picture: Picture, size: Size, x: float, y: float) -> Spot:
    """Return what is measured from at a pixel: a control point, or the surface; nothing beside both."""
    points = points_under(picture, size, x, y)
    if points:
        return Spot(index=points[0])
    is_seen = picture.settings.surface
    return Spot(parameters=parameters_under(picture.scene, picture.camera, size, x, y) if is_seen else None)
