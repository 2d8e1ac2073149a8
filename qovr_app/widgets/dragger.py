"""A drag, from the press of the mouse to its release, whatever is dragged."""

from __future__ import annotations

from abc import abstractmethod

from PySide6.QtCore import QObject, QPointF, Qt, QTimer, Signal, SignalInstance
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import QWidget

from qovr_app.state.gestures import next_gesture
from qovr_app.widgets.typed_number import TypedNumber

DRAG_START = 3.0
"""Pixels the mouse moves before a press becomes a drag: a click selects and must not edit."""

_NEW_MILLISECONDS = 1000
"""So long after its begin a drag shows what else a hand can do."""


class Dragger(QObject):
    """Follows the mouse with what is held in a widget; what that is, and where it belongs, its kinds know.

    Signals
    -------
    finished, cancelled : the gesture number
    changed : the drag looks different
    """

    finished = Signal(int)
    cancelled = Signal(int)
    changed = Signal()

    def __init__(self, widget: QWidget) -> None:
        super().__init__(widget)
        self._widget = widget
        self._gesture = 0
        self._is_fine = self._has_control = False
        self._at = self._pressed_at = QPointF()
        self._typed = TypedNumber()
        self._new = QTimer(self, singleShot=True, interval=_NEW_MILLISECONDS)
        self._new.timeout.connect(self.changed)

    @property
    def is_new(self) -> bool:
        """Whether a drag has only just begun."""
        return self._new.isActive()

    @property
    @abstractmethod
    def is_pressed(self) -> bool:
        """Whether the mouse holds something."""

    @property
    def is_dragging(self) -> bool:
        """Whether what is held has begun to move."""
        return self._gesture != 0

    def move_to(self, at: QPointF, *, is_fine: bool, has_control: bool) -> None:
        """Move what is held to where it belongs under the mouse, or a tenth of its way."""
        if not self.is_pressed:
            return
        if is_fine is not self._is_fine:
            self._is_fine = is_fine
            self._take_again()
        self._at, self._has_control = at, has_control
        if not self.is_dragging:
            if (at - self._pressed_at).manhattanLength() < DRAG_START:
                return
            self._gesture = next_gesture()
            self._new.start()
            self._widget.setCursor(Qt.CursorShape.ClosedHandCursor)
            self._begin()
        self._report()

    def lock(self, axis: int, *, plane: bool) -> None:
        """Keep to a line along an axis, or to the plane that it stands on, where that is possible."""

    def type(self, event: QKeyEvent) -> None:
        """Take a key of a number; while one stands there, the mouse is not followed."""
        if self.is_dragging and self._has_one_number and self._typed.take(event):
            self._report()

    def finish(self) -> None:
        """End a drag, if there is one, where things are now."""
        self._end(self.finished)

    def cancel(self) -> None:
        """End a drag, if there is one; all goes back."""
        self._end(self.cancelled)

    def drop(self) -> None:
        """Let go, without a word."""
        was_pressed, self._gesture = self.is_pressed, 0
        self._let_go()
        if was_pressed:
            self.changed.emit()

    def _end(self, ended: SignalInstance) -> None:
        gesture, self._gesture = self._gesture, 0
        self._let_go()
        if gesture:
            ended.emit(gesture)
        self.changed.emit()

    def _press_at(self, at: QPointF) -> None:
        """Begin to follow the mouse."""
        self._pressed_at = self._at = at
        self._is_fine = self._has_control = False
        self._typed = TypedNumber()

    # What is dragged

    @property
    def _has_one_number(self) -> bool:
        """Whether a typed number has a meaning."""
        return True

    def _begin(self) -> None:
        """Say that a drag begins."""

    @abstractmethod
    def _take_again(self) -> None:
        """Go on from where things are now: with another fineness the mouse's way means another."""

    @abstractmethod
    def _let_go(self) -> None:
        """Hold nothing any more."""

    @abstractmethod
    def _report(self) -> None:
        """Say where things belong now."""
