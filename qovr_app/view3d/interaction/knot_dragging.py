"""Dragging a knot along its chord."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import QPointF, Signal
from PySide6.QtWidgets import QWidget

from qovr_app.state.intents import GestureBegun
from qovr_app.state.knot_intents import KnotsSet
from qovr_app.state.looking_intents import FieldFocused
from qovr_app.view3d.interaction.dragger import FINE, Dragger
from qovr_app.view3d.interaction.picking import handle_under
from qovr_app.view3d.scene.camera import Size
from qovr_app.view3d.scene.grip import ALONG_WAY, Grip, rounded
from qovr_app.view3d.scene.hand import RESET, KnotMarks
from qovr_app.view3d.scene.knot_handles import KnotHandle
from qovr_app.view3d.scene.picture import Picture

STEP = 0.05
"""Drags that snap keep a knot to multiples of this."""

LEAST = 0.001
"""How near to 0 and 1 a hand brings a knot: a knot lies strictly between, and nearer ones swing out of sight."""

_MAGNET = 4.0
"""Pixels between the handles of u and s within which the one in the hand goes to where the other is."""


class KnotDragger(Dragger):
    """Moves the knot that is held in a widget; s goes with u while the two are one number and Ctrl is up.

    Signals
    -------
    wanted : an intent
    """

    wanted = Signal(object)

    def __init__(self, widget: QWidget) -> None:
        super().__init__(widget)
        self._held: KnotHandle | None = None

    @property
    def is_pressed(self) -> bool:
        """Whether the mouse holds a knot."""
        return self._held is not None

    @property
    def marks(self) -> KnotMarks | None:
        """What is seen of the drag; None where nothing moves."""
        held = self._held
        if held is None or not self.is_dragging:
            return None
        is_possible = not self._typed.text or self._typed_knot is not None
        return KnotMarks(held.place, held, self._typed.text, is_possible=is_possible)

    def take(self, picture: Picture, size: Size, at: QPointF) -> KnotHandle | None:
        """Take hold of the knot under the mouse, and return it; None where there is none."""
        handle = handle_under(picture, size, at.x(), at.y())
        if handle is not None:
            self._held, self._picture, self._size = handle, picture, size
            self._press_at(at)
            self._value = handle.value
            self._take_again()
            self.wanted.emit(FieldFocused(handle.place))
        return handle

    def _begin(self) -> None:
        self.wanted.emit(GestureBegun(self._gesture))

    def _take_again(self) -> None:
        if self._held is None:
            return
        at, fineness = (self._at.x(), self._at.y()), FINE if self._is_fine else 1.0
        frame, camera = self._picture.scene.frame, self._picture.camera
        self._kept, start = self._value, self._held.at(self._value)
        self._grip = Grip(frame, camera, self._size, start, self._held.way, at, ALONG_WAY, fineness)

    def _let_go(self) -> None:
        self._held = None

    def _report(self) -> None:
        if self._held is None:
            return
        typed = self._typed_knot
        if typed is not None:
            self._value = typed
        elif not self._typed.text:
            self._value = self._pointed(self._held)
        takes_s = self._held.takes_s and not self._has_control
        self.wanted.emit(set_knot(self._held, self._value, self._gesture, takes_s=takes_s))
        self.changed.emit()

    @property
    def _typed_knot(self) -> float | None:
        """The number that is typed, where it can be a knot."""
        value = self._typed.value
        return value if value is not None and 0 < value < 1 else None

    def _pointed(self, held: KnotHandle) -> float:
        """Return the knot that the mouse means, no finer than a pixel is."""
        scale = self._picture.scene.frame.scale
        way, move = held.way * scale, self._grip.moved(self._at.x(), self._at.y()) * scale
        length = np.linalg.norm(way)
        value = self._kept + float(move @ way / length**2)
        pixel = self._grip.pixel[:1] * scale[:1] / length
        other = self._other(held)
        if other is not None and not self._is_fine and abs(value - other) < _MAGNET * float(pixel[0]):
            return other
        knot = float(rounded(np.array([value]), pixel, STEP if self._snaps(held) else None)[0])
        return min(max(knot, LEAST), 1 - LEAST)

    def _snaps(self, held: KnotHandle) -> bool:
        """Whether the knot keeps to the step; where s goes with u, Ctrl means another thing."""
        return self._picture.tools.snaps is not (self._has_control and not held.takes_s)

    def _other(self, held: KnotHandle) -> float | None:
        """Return the knot on the same chord, to which this one may come home."""
        return next(
            (
                handle.value
                for handle in self._picture.knot_handles
                if handle.place != held.place and np.array_equal(handle.ends, held.ends)
            ),
            None,
        )


def set_knot(handle: KnotHandle, value: float, gesture: int = 0, *, takes_s: bool) -> KnotsSet:
    """Return what sets the knot of a handle."""
    place = handle.place
    return KnotsSet(
        place.direction, place.curve, handle.window, place.name, value, gesture, takes_s=takes_s, in_view=True
    )


def reset_knot(handle: KnotHandle) -> KnotsSet:
    """Return what puts the knot of a handle into the middle, and s with u where they are one."""
    return set_knot(handle, RESET, takes_s=handle.takes_s)
