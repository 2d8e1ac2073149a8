"""A record for a gesture, and what it needs of the window beside the hand."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np
from PySide6.QtCore import QPointF, Qt
from PySide6.QtTest import QTest

from qovr_app.state.looking_intents import Selected
from qovr_app.view3d.interaction.camera_motion import TURN_MILLISECONDS
from qovr_app.view3d.scene.gizmo import gizmo_at
from qovr_app.view3d.scene.probing import parameters_under
from support.hand import Hand
from support.pictures import picture_of


@dataclass(frozen=True)
class Gesture:
    """One gesture.

    Parameters
    ----------
    name : what is done, and what comes of it, as a user would say it
    run : does it with a hand, shows its middle, and asserts what has to be so
    """

    name: str
    run: Callable[[GestureHand], None]


@dataclass
class Table:
    """The gestures of one kind."""

    gestures: list[Gesture] = field(default_factory=list)

    def __call__(self, name):
        """Return a decorator that adds a function as the gesture of this name."""

        def add(run):
            self.gestures.append(Gesture(name, run))
            return run

        return add


class GestureHand(Hand):
    """A hand that can be looked at, with what the window says of its document.

    Parameters
    ----------
    picture : where the picture of the gesture's middle is kept; None to keep none
    """

    def __init__(self, editor, picture=None):
        super().__init__(editor)
        self._picture, self.shown = picture, 0

    def show(self, at=None):
        """Take the gesture's picture, the mouse being here or at a global place."""
        self.shown += 1
        if self._picture is not None:
            at = self.widget.mapToGlobal(self.at) if at is None else at
            path = self._picture.with_stem(
                f"{self._picture.stem} {self.shown}" if self.shown > 1 else self._picture.stem
            )
            assert picture_of(self.editor.window, at).save(str(path))

    @property
    def state(self):
        return self.editor.window.store.state

    @property
    def net(self):
        """The control points as they stand now."""
        return self.editor.document.control_points.copy()

    @property
    def selected(self):
        return set(self.state.selection.points)

    @property
    def picked_last(self):
        return self.state.selection.last

    @property
    def steps(self):
        """What can be undone, the oldest first."""
        history = self.state.history
        return [step.text for step in history.steps[: history.index]]

    @property
    def camera(self):
        return self.view.camera

    @property
    def beside(self):
        """A pixel beside surface and net, and beside the axes."""
        return QPointF(6, 6)

    def on_surface(self):
        """Return a pixel of the surface that is far from every point."""
        places = np.array([[(p := self.place(i, j)).x(), p.y()] for i, j in np.ndindex(self.net.shape[:2])])
        x, y = places.mean(axis=0).round()
        around = np.array([(x + dx, y + dy) for dx in range(-150, 151, 15) for dy in range(-90, 91, 15)])
        free = np.linalg.norm(around[:, None] - places, axis=-1).min(axis=1)
        scene, size = self.view.picture().scene, self.view.viewports[0].logical_size
        ordered = around[np.argsort(-free)].tolist()
        return QPointF(*next(at for at in ordered if parameters_under(scene, self.camera, size, *at) is not None))

    def around(self, *indices):
        """Return two corners of a rectangle that holds these points; beside the points, not over one."""
        places = [self.place(*index) for index in indices]
        x, y = ([getattr(at, letter)() for at in places] for letter in "xy")
        room = 14
        return QPointF(min(x) - room, min(y) - room), QPointF(max(x) + room, max(y) + room)

    def arrow(self, axis):
        """Return a pixel of the gizmo's arrow along an axis."""
        start, end = self._gizmo().arrows[axis]
        return QPointF(*(start + 0.75 * (end - start)))

    def square(self, axis):
        """Return a pixel of the gizmo's square on which an axis stands."""
        return QPointF(*self._gizmo().squares[axis].mean(axis=0))

    def _gizmo(self):
        picture = self.view.picture()
        return gizmo_at(picture.scene.points[self.picked_last], self.camera, self.view.viewports[0].logical_size)

    def select(self, *indices):
        """Click on points one after the other, Shift held after the first."""
        self.click(self.place(*indices[0]))
        self.hold(Qt.Key.Key_Shift)
        for index in indices[1:]:
            self.click(self.place(*index))
        self.let_go(Qt.Key.Key_Shift)
        assert self.selected == set(indices)

    def stack(self):
        """Bring three points of the first row to one place."""
        for j in (1, 2, 3):
            for axis, value in zip("xyz", ("1", "0", "0.6"), strict=True):
                self.editor.type_into(f"control_points.P_0_{j}.{axis}", value)
        self.editor.window.store.dispatch(Selected(None))
        self.editor.settle()

    def rest(self):
        """Wait until the camera has come to where a command leads it."""
        QTest.qWait(TURN_MILLISECONDS)
        before = None
        while before != self.camera:
            before = self.camera
            QTest.qWait(40)
