"""Dragging a control point, from the press of the mouse to its release."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from PySide6.QtCore import QObject, QPointF, Qt, Signal, SignalInstance
from PySide6.QtWidgets import QWidget

from qovr_app.state.gestures import next_gesture
from qovr_app.view3d.scene.camera import Camera, Size
from qovr_app.view3d.scene.scene import Scene
from qovr_core.arrays import Array, read_only
from qovr_core.document import NetIndex

_DRAG_START = 3.0
"""Pixels the mouse moves before a press becomes a drag: a click selects and must not edit."""

_PARALLEL = 0.12
"""Sine of the angle between the line of sight and an axis below which a pixel would mean a leap along the
axis."""

_ROUNDING = 1e-9
"""Unit lengths; a coordinate that moves by less is not meant to move, as z seen from above."""


@dataclass(frozen=True, eq=False)
class PressedPoint:
    """A control point as it was when the mouse went down on it; every target is computed from here.

    Parameters
    ----------
    scene, camera, size : as they were then
    index : which point
    x, y : the pixel where the mouse went down
    """

    scene: Scene
    camera: Camera
    size: Size
    index: NetIndex
    x: float
    y: float

    def target(self, x: float, y: float, axis: int | None) -> Array | None:
        """Return where the point belongs when the mouse is at a pixel.

        Parameters
        ----------
        axis : 0, 1, 2 keeps to a line along X, Y, Z; None moves in the plane of the view

        Returns
        -------
        (3,) float64 in the document's units, read-only; None where the axis points at the viewer
        """
        start = self.scene.points[self.index]
        seen = self.camera.project(start[None], self.size)[0]
        goal = np.array([seen[0] + x - self.x, seen[1] + y - self.y, seen[2]])
        if axis is None:
            move = self.camera.unproject(goal[None], self.size)[0] - start
        else:
            along = self._along(axis, start, goal)
            if along is None:
                return None
            move = np.zeros(3)
            move[axis] = along
        move[np.abs(move) < _ROUNDING] = 0.0
        return read_only(self.scene.document.control_points[self.index] + move / self.scene.frame.scale)

    def _along(self, axis: int, start: Array, goal: Array) -> float | None:
        """Return how far along an axis its line comes closest to the line of sight through a pixel."""
        origin, sight = self.camera.ray(goal[0], goal[1], self.size)
        across = 1 - sight[axis] ** 2
        if across < _PARALLEL**2:
            return None
        offset = start - origin
        return float((sight[axis] * (sight @ offset) - offset[axis]) / across)


class PointDragger(QObject):
    """Moves the control point that is pressed in a widget, in the view's plane or along the axes that are held.

    Signals
    -------
    dragged : i, j, the wanted coordinates (3,), and the drag's gesture number
    finished, cancelled : the gesture number
    """

    dragged = Signal(int, int, object, int)
    finished = Signal(int)
    cancelled = Signal(int)

    def __init__(self, widget: QWidget) -> None:
        super().__init__(widget)
        self._widget = widget
        self._pressed: PressedPoint | None = None
        self._at = QPointF()
        self._gesture = 0
        self._axes: list[int] = []

    @property
    def is_pressed(self) -> bool:
        """Whether the mouse is down on a control point."""
        return self._pressed is not None

    @property
    def is_dragging(self) -> bool:
        """Whether the point has begun to move."""
        return self._gesture != 0

    def holds_axis(self, axis: int) -> bool:
        """Return whether moves keep to a line along this axis."""
        return axis in self._axes

    def press(self, pressed: PressedPoint) -> None:
        """Take hold of a point."""
        self._pressed, self._at = pressed, QPointF(pressed.x, pressed.y)

    def move_to(self, at: QPointF) -> None:
        """Move the point that is pressed to where it belongs under the mouse."""
        self._at = at
        if self._pressed is None:
            return
        if not self.is_dragging:
            if (at - QPointF(self._pressed.x, self._pressed.y)).manhattanLength() < _DRAG_START:
                return
            self._gesture = next_gesture()
        target = self._pressed.target(at.x(), at.y(), self._axes[-1] if self._axes else None)
        shape = Qt.CursorShape.ForbiddenCursor if target is None else Qt.CursorShape.ClosedHandCursor
        self._widget.setCursor(shape)
        if target is not None:
            self.dragged.emit(*self._pressed.index, target, self._gesture)

    def hold_axis(self, axis: int) -> None:
        """Keep to a line along this axis from now on."""
        self._axes.append(axis)
        self._follow_axes()

    def let_axis_go(self, axis: int) -> None:
        """Keep to a line along this axis no longer."""
        self._axes.remove(axis)
        self._follow_axes()

    def let_axes_go(self) -> None:
        """Keep to no line any more, from the next move on."""
        self._axes.clear()

    def finish(self) -> None:
        """End a drag, if there is one, where the point is now."""
        self._end(self.finished)

    def cancel(self) -> None:
        """End a drag, if there is one; the point goes back."""
        self._end(self.cancelled)

    def drop(self) -> None:
        """Let go of the point, without a word."""
        self._gesture, self._pressed = 0, None

    def _follow_axes(self) -> None:
        if self.is_dragging:
            self.move_to(self._at)

    def _end(self, ended: SignalInstance) -> None:
        gesture, self._gesture, self._pressed = self._gesture, 0, None
        if gesture:
            ended.emit(gesture)
