"""Dragging a number sideways, on whatever widget stands for it."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import QEvent, QObject, Qt, Signal
from PySide6.QtGui import QFocusEvent, QKeyEvent, QMouseEvent
from PySide6.QtWidgets import QApplication, QWidget

from qovr_app.state.gestures import next_gesture
from qovr_app.state.scrubbing import Scrub

_START = 4.0
"""Pixels the mouse moves sideways before a press becomes a drag, which edits: a click must not."""

_ENDING = {
    QEvent.Type.FocusOut,
    QEvent.Type.Hide,
    QEvent.Type.UngrabMouse,
    QEvent.Type.WindowDeactivate,
}
"""What takes the mouse or the keyboard away."""


class Scrubbing(QObject):
    """Lets a number be dragged sideways on a widget; Escape, the right button and a lost focus put it back.

    Shift is fine, Ctrl snaps. What takes the keyboard is dragged by a press that gives it the keyboard: once it has it,
    its text is edited. What was dragged is not edited yet, and can be dragged again.

    Parameters
    ----------
    take : returns the number as it is now, with what a pixel means
    snaps : whether a number snaps without Ctrl, and is freed by it

    Signals
    -------
    begun, ended, cancelled : the gesture number
    scrubbed : the number, and the gesture number
    clicked : the button was let go where it was pressed
    """

    begun = Signal(int)
    scrubbed = Signal(float, int)
    ended = Signal(int)
    cancelled = Signal(int)
    clicked = Signal()

    def __init__(self, widget: QWidget, take: Callable[[], Scrub], snaps: Callable[[], bool] = lambda: False) -> None:
        super().__init__(widget)
        self._widget, self._take, self._snaps = widget, take, snaps
        self._pressed_at: float | None = None
        self._scrub: Scrub | None = None
        self._value = 0.0
        self._gesture = 0
        self._with_keys: QWidget | None = None
        self._waits = self._is_edited = False
        widget.installEventFilter(self)
        self._show_way()

    @property
    def is_scrubbing(self) -> bool:
        """Whether the number is in the hand."""
        return self._scrub is not None

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        kind = event.type()
        if isinstance(event, QKeyEvent):
            return self._on_key(kind, event)
        if watched is not self._widget:
            if kind == QEvent.Type.FocusOut:
                self._let_go()
            return False
        if isinstance(event, QMouseEvent):
            return self._on_mouse(kind, event)
        if kind in _ENDING:
            self._let_go()
        if isinstance(event, QFocusEvent):
            self._is_edited = kind == QEvent.Type.FocusIn and event.reason() != Qt.FocusReason.MouseFocusReason
            self._show_way()
        is_busy = self.is_scrubbing or self._waits
        return is_busy and kind in (QEvent.Type.ContextMenu, QEvent.Type.Wheel)

    def _on_mouse(self, kind: QEvent.Type, event: QMouseEvent) -> bool:
        is_left = event.button() == Qt.MouseButton.LeftButton
        if kind == QEvent.Type.MouseButtonPress and is_left:
            self._waits = False
            self._pressed_at = None if self._is_edited or event.modifiers() else event.globalPosition().x()
        elif kind == QEvent.Type.MouseButtonPress and self.is_scrubbing:
            self._cancel()
            return True
        elif kind == QEvent.Type.MouseMove:
            return self._move(event)
        elif kind == QEvent.Type.MouseButtonRelease:
            return self._release() if is_left else self._waits
        elif kind == QEvent.Type.MouseButtonDblClick:
            self._edit()
        return False

    def _move(self, event: QMouseEvent) -> bool:
        at = event.globalPosition().x()
        if self._waits or self._pressed_at is None or not event.buttons() & Qt.MouseButton.LeftButton:
            return self._waits
        if self._scrub is None:
            if abs(at - self._pressed_at) <= _START:
                return True  # no text is selected on the way
            self._begin(self._pressed_at)
        self._follow(at, event.modifiers())
        return True

    def _begin(self, at: float) -> None:
        scrub = self._take()
        self._scrub, self._value = scrub.gone_on(at, scrub.start, is_fine=False), scrub.start
        self._gesture = next_gesture()
        if not self._widget.hasFocus():
            self._with_keys = QApplication.focusWidget() or self._widget.window()
            self._with_keys.installEventFilter(self)  # Escape is for what the mouse holds
        self.begun.emit(self._gesture)

    def _follow(self, at: float, modifiers: Qt.KeyboardModifier) -> None:
        is_fine = bool(modifiers & Qt.KeyboardModifier.ShiftModifier)
        if self._scrub is None:
            return
        if is_fine is not self._scrub.is_fine:
            self._scrub = self._scrub.gone_on(at, self._value, is_fine=is_fine)
        snaps = self._snaps() is not bool(modifiers & Qt.KeyboardModifier.ControlModifier)
        value = self._scrub.value(at, snaps=snaps)
        if value != self._value:
            self._value = value
            self.scrubbed.emit(value, self._gesture)

    def _release(self) -> bool:
        waited, was_pressed = self._waits, self._pressed_at is not None
        self._waits, self._pressed_at = False, None
        if self.is_scrubbing:
            self._end()
            self.ended.emit(self._gesture)
        elif was_pressed and not waited:
            self._edit()
            self.clicked.emit()
        return False

    def _on_key(self, kind: QEvent.Type, event: QKeyEvent) -> bool:
        if not self.is_scrubbing:
            if kind == QEvent.Type.KeyPress and not self._waits:
                self._edit()
            return False
        if kind == QEvent.Type.ShortcutOverride:
            event.accept()  # no command of the window comes between
        elif kind == QEvent.Type.KeyPress and event.key() == Qt.Key.Key_Escape:
            self._cancel()
        return True

    def _let_go(self) -> None:
        if self.is_scrubbing:
            self._cancel()
        self._pressed_at = None

    def _cancel(self) -> None:
        """Have the number put back; the mouse is not followed until its button is released."""
        self._waits = True
        self._end()
        self.cancelled.emit(self._gesture)

    def _end(self) -> None:
        self._scrub = None
        if self._with_keys is not None:
            self._with_keys.removeEventFilter(self)
        self._with_keys = None

    def _edit(self) -> None:
        """Leave the widget's presses to it from now on, if it has the keyboard."""
        self._is_edited = self._widget.hasFocus()
        self._show_way()

    def _show_way(self) -> None:
        self._widget.setCursor(Qt.CursorShape.IBeamCursor if self._is_edited else Qt.CursorShape.SizeHorCursor)
