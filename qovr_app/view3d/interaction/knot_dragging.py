"""Dragging a knot along its chord."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import QPointF
from PySide6.QtWidgets import QWidget

from qovr_app.state.gestures import FINE
from qovr_app.view3d.interaction.picking import handle_under
from qovr_app.view3d.scene.camera import Size
from qovr_app.view3d.scene.grip import ALONG_WAY, Grip
from qovr_app.view3d.scene.hand import KnotMarks
from qovr_app.view3d.scene.knot_handles import KnotHandle
from qovr_app.view3d.scene.picture import Picture
from qovr_app.widgets.knot_hand import KnotHand


class KnotDragger(KnotHand):
    """Moves the knot that is held in a viewport."""

    def __init__(self, widget: QWidget) -> None:
        super().__init__(widget, in_view=True)

    @property
    def marks(self) -> KnotMarks | None:
        """What is seen of the drag; None where nothing moves."""
        if not (self.is_pressed and self.is_dragging):
            return None
        return KnotMarks(self._handle.knot.place, self._handle, self.typed, self.is_possible, self.is_new)

    def take(self, picture: Picture, size: Size, at: QPointF) -> KnotHandle | None:
        """Take hold of the knot under the mouse, and return its handle; None where there is none."""
        handle = handle_under(picture, size, at.x(), at.y())
        if handle is not None:
            self._handle, self._picture, self._size = handle, picture, size
            self.hold(handle.knot, at, snaps=picture.tools.snaps)
        return handle

    def _take_again(self) -> None:
        super()._take_again()
        at, fineness = (self._at.x(), self._at.y()), FINE if self._is_fine else 1.0
        frame, camera, handle = self._picture.scene.frame, self._picture.camera, self._handle
        self._grip = Grip(frame, camera, self._size, handle.at(self._value), handle.way, at, ALONG_WAY, fineness)
        self._chord = handle.way * frame.scale

    def _gone(self) -> float:
        move = self._grip.moved(self._at.x(), self._at.y()) * self._picture.scene.frame.scale
        return float(move @ self._chord / (self._chord @ self._chord))

    def _pixel(self) -> float:
        along = self._grip.pixel * self._picture.scene.frame.scale  # the same along every axis
        return float(along[0] / np.linalg.norm(self._chord))
