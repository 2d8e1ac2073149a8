"""Dragging control points."""

from __future__ import annotations

from dataclasses import dataclass
from decimal import Decimal

import numpy as np
from PySide6.QtCore import QPointF, Signal
from PySide6.QtWidgets import QWidget

from qovr_app.state.gestures import FINE
from qovr_app.state.tools import Way
from qovr_app.view3d.scene.camera import Size
from qovr_app.view3d.scene.grip import ALONG_WAY, IN_VIEW, Freedom, Grip, across, along, rounded
from qovr_app.view3d.scene.hand import DragMarks
from qovr_app.view3d.scene.picture import Picture
from qovr_app.widgets.dragger import Dragger
from qovr_app.widgets.typed_number import TypedNumber
from qovr_core.arrays import Array, read_only
from qovr_core.document import NetIndex
from qovr_core.geometry.closest import closest_points

_STILL = 1e-9
"""Unit lengths; a coordinate that moves by less is not meant to move, as z seen from above."""


_NO_NORMAL = 0.5
"""A normal has length 1, but for rounding; where the surface has none, its length is 0 or no number."""

FREEDOMS = {Way.Z: along(2), Way.VIEW: IN_VIEW, Way.NORMAL: ALONG_WAY}
"""What may change of a point that is itself dragged."""


@dataclass(frozen=True, eq=False)
class HeldPoints:
    """Control points as they were when the mouse went down on one of them.

    Parameters
    ----------
    picture, size : what was seen then
    indices : the points that move, the one in the hand first
    freedom : what may change at first
    is_difference : whether a typed number is the way, and not a coordinate
    """

    picture: Picture
    size: Size
    indices: tuple[NetIndex, ...]
    freedom: Freedom
    is_difference: bool

    @property
    def points(self) -> Array:
        """Where the points were, (k, 3) in the document's units."""
        i, j = np.array(self.indices).T
        points: Array = self.picture.scene.document.control_points[i, j]
        return points

    def normals(self) -> Array:
        """Return the surface's normal at its place nearest to each point, (k, 3); z where it has none."""
        surface = self.picture.scene.surface
        feet = closest_points(surface, self.points)
        places = zip(feet.u.tolist(), feet.v.tolist(), strict=True)
        normals = np.array([surface.normals([u], [v])[0, 0] for u, v in places])
        has_normal = np.linalg.norm(normals, axis=1, keepdims=True) > _NO_NORMAL
        return np.where(has_normal, normals, [0.0, 0.0, 1.0])


class PointDragger(Dragger):
    """Moves the control points that are held in a widget.

    Signals
    -------
    dragged : the points (i, j), the one in the hand first, how far each is from where it was when the drag began,
        (k, 3) in the document's units, and the drag's gesture number
    """

    dragged = Signal(object, object, int)

    def __init__(self, widget: QWidget) -> None:
        super().__init__(widget)
        self._held: HeldPoints | None = None

    @property
    def is_pressed(self) -> bool:
        """Whether the mouse holds control points."""
        return self._held is not None

    @property
    def marks(self) -> DragMarks | None:
        """What is seen of the drag; None where nothing moves."""
        held = self._held
        if held is None or not self.is_dragging:
            return None
        ways = np.empty((0, 3)) if len(self._grip.freedom.axes) == 3 else self._grip.ways
        typed, is_difference = self._typed.text, self._is_difference
        return DragMarks(held.indices, held.points, ways, self._grip.freedom, typed, is_difference, self.is_new)

    def press(self, held: HeldPoints, at: QPointF) -> None:
        """Take hold of points."""
        self._held = held
        self._press_at(at)
        self._begun = held.points
        self._kept, self._moved = np.zeros_like(self._begun), np.zeros_like(self._begun)
        self._normals = held.normals() if held.freedom == ALONG_WAY else np.zeros_like(self._begun)
        self._grip = self._grip_of(held, held.freedom)

    def lock(self, axis: int, *, plane: bool) -> None:
        """Keep to a line along an axis, or to the plane that it stands on; the same again frees the points."""
        if self._held is None:
            return
        wanted = across(axis) if plane else along(axis)
        self._typed = TypedNumber()
        self._take_again(self._held.freedom if self._grip.freedom == wanted else wanted)
        self.changed.emit()

    @property
    def _step(self) -> float | None:
        """What the points' coordinates are multiples of; None where they are free."""
        if self._held is None or self._held.picture.tools.snaps is self._has_control:
            return None
        return self._held.picture.tools.snap_step

    @property
    def _has_one_number(self) -> bool:
        return self._grip.freedom.axis is not None or self._grip.freedom.along_way

    @property
    def _is_difference(self) -> bool:
        held = self._held
        return held is not None and (held.is_difference or len(held.indices) > 1 or self._grip.freedom.along_way)

    def _grip_of(self, held: HeldPoints, freedom: Freedom) -> Grip:
        return Grip(
            held.picture.scene.frame,
            held.picture.camera,
            held.size,
            self._begun[0] + self._moved[0],
            self._normals[0],
            (self._at.x(), self._at.y()),
            freedom,
            FINE if self._is_fine else 1.0,
        )

    def _take_again(self, freedom: Freedom | None = None) -> None:
        """Go on from where the points are now: with another fineness or freedom, the mouse's way means another."""
        if self._held is not None:
            self._kept = self._moved
            self._grip = self._grip_of(self._held, freedom or self._grip.freedom)

    def _let_go(self) -> None:
        self._held = None

    def _report(self) -> None:
        """Say where the points belong now."""
        if self._held is None:
            return
        if self._typed.text:
            self._move_as_typed()
        else:
            self._move_as_pointed()
        self.dragged.emit(self._held.indices, read_only(self._moved.copy()), self._gesture)
        self.changed.emit()

    def _move_as_typed(self) -> None:
        value, axis = self._typed.value, self._grip.freedom.axis
        if value is None:
            return
        moved = self._kept.copy()
        if axis is None:
            moved = self._kept + value * self._normals
        else:
            moved[:, axis] = value if self._is_difference else _apart(value, self._begun[0, axis])
        self._moved = moved

    def _move_as_pointed(self) -> None:
        """Follow the mouse, in numbers no finer than what a pixel means."""
        grip = self._grip
        step, move = self._step, grip.moved(self._at.x(), self._at.y())
        if grip.freedom.along_way:
            length = rounded(np.array([move @ grip.way]), grip.pixel.min(keepdims=True), step)
            self._moved = self._kept + length * self._normals
            return
        is_still = np.abs(move * grip.frame.scale) < _STILL
        target = rounded(grip.point + move, grip.pixel, step)
        lead = np.array([_apart(*pair) for pair in zip(target.tolist(), self._begun[0].tolist(), strict=True)])
        moved = self._kept + (lead - self._kept[0])
        self._moved = np.where(is_still, self._kept, moved)


def _apart(value: float, origin: float) -> float:
    """Return the difference of two numbers as their decimals say it: 0.3 and 0.1 are 0.2 apart."""
    return float(Decimal(repr(float(value))) - Decimal(repr(float(origin))))
