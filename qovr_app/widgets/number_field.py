"""One number of the document as a field."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QFocusEvent, QKeyEvent, QKeySequence, QMouseEvent, QWheelEvent
from PySide6.QtWidgets import QWidget

from qovr_app.state.scrubbing import Scrub
from qovr_app.widgets.bursts import Bursts
from qovr_app.widgets.scrubbing import Scrubbing
from qovr_app.widgets.typed_field import TypedField
from qovr_core import QovrError
from qovr_core.number_texts import stepped

_NOTCH = 120
"""What Qt counts for one notch of a wheel; trackpads and fine wheels send parts of it."""

PIXEL = 0.5
"""Part of a key's step that a pixel of the mouse means: a hand moves some hundred of them with ease."""

_STEPS: dict[int, float] = {
    Qt.Key.Key_Up: 1.0,
    Qt.Key.Key_Down: -1.0,
    Qt.Key.Key_PageUp: 10.0,
    Qt.Key.Key_PageDown: -10.0,
}


@dataclass(frozen=True)
class Snapping:
    """Of what a dragged number is a multiple while Ctrl is held, or while it is not where it is on."""

    step: Callable[[], float]
    is_on: Callable[[], bool] = lambda: False


class NumberField(TypedField):
    """A number that is typed, stepped by keys and wheel, and dragged sideways.

    Parameters
    ----------
    name, check : as for every field that is typed into
    step : by how much an arrow key changes a number, which may depend on how large it is
    least : the least change that means something; 0 for none
    snapping : of what a dragged number is a multiple; without, of the step while Ctrl is held

    Signals
    -------
    gesture_begun, gesture_ended, gesture_cancelled : the number is dragged, with its gesture
    focused : the field has the keyboard now
    """

    gesture_begun = Signal(int)
    gesture_ended = Signal(int)
    gesture_cancelled = Signal(int)
    focused = Signal()

    def __init__(
        self,
        name: str,
        check: Callable[[object, str], float],
        step: Callable[[float], float],
        parent: QWidget | None = None,
        *,
        least: float = 0.0,
        snapping: Snapping | None = None,
    ) -> None:
        super().__init__(name, check, parent)
        self._step_size = step
        self._least = least
        self.snapping = snapping or Snapping(lambda: self.step_size)
        self._start, self._text_before = 0.0, ""
        self._scrubbing = Scrubbing(self, self._taken, self.snapping.is_on)
        self._scrubbing.begun.connect(self.gesture_begun)
        self._scrubbing.scrubbed.connect(self._on_scrubbed)
        self._scrubbing.ended.connect(self.gesture_ended)
        self._scrubbing.ended.connect(self.selectAll)  # what is typed next replaces it
        self._scrubbing.cancelled.connect(self._on_scrub_cancelled)
        self._bursts = Bursts(self)
        self._turned = 0
        self._selects_on_release = False

    @property
    def step_size(self) -> float:
        """By how much an arrow key changes the number."""
        return self._step_size(self._value)

    def turn_to(self, name: str, tip: str, value: float, text: str | None) -> None:
        self._bursts.end()
        super().turn_to(name, tip, value, text)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() in _STEPS and not event.modifiers() & ~Qt.KeyboardModifier.KeypadModifier:
            self._step(_STEPS[event.key()])
        elif event.key() == Qt.Key.Key_Escape and self.has_own_text:
            self.revert()
            self.selectAll()
        elif event.matches(QKeySequence.StandardKey.Paste):
            self.paste()
        else:
            super().keyPressEvent(event)

    def _step(self, count: float) -> None:
        try:
            before = self.typed()
            value = self._check(stepped(before, count, self._step_size(before)), self._name)
        except QovrError as error:
            self.refused.emit(str(error))
            return
        self._put(value)
        self.selectAll()
        self.value_edited.emit(value, self._bursts.step())

    def wheelEvent(self, event: QWheelEvent) -> None:
        """Step while the field has the keyboard; else the wheel is for what scrolls around it."""
        if not self.hasFocus() or event.modifiers():
            event.ignore()
            return
        self._turned += event.angleDelta().y()
        count = int(self._turned / _NOTCH)
        self._turned -= count * _NOTCH
        if count:
            self._step(count)

    def _taken(self) -> Scrub:
        """Return the number as the mouse takes it, what is typed over it forgotten until it is put back."""
        self._text_before = self.text() if self.has_own_text else ""
        self._start = self._value
        self._put(self._value)
        return Scrub(self._value, max(self.step_size * PIXEL, self._least), self.snapping.step(), self.may_be)

    def may_be(self, value: float) -> bool:
        """Return whether a number is one that the field may hold."""
        try:
            self._check(value, self._name)
        except QovrError:
            return False
        return True

    def _on_scrubbed(self, value: float, gesture: int) -> None:
        self._put(value)
        self.value_edited.emit(value, gesture)

    def _on_scrub_cancelled(self, gesture: int) -> None:
        self._put(self._start)
        self.gesture_cancelled.emit(gesture)
        if self._text_before:
            self.setText(self._text_before)

    def mouseDoubleClickEvent(self, _event: QMouseEvent) -> None:
        self.selectAll()  # Qt would take a word, and a number is several of them

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        super().mouseReleaseEvent(event)
        if self._selects_on_release and not self.hasSelectedText():
            self.selectAll()
        self._selects_on_release = False

    def focusInEvent(self, event: QFocusEvent) -> None:
        super().focusInEvent(event)
        self._selects_on_release = event.reason() == Qt.FocusReason.MouseFocusReason
        if event.reason() != Qt.FocusReason.PopupFocusReason:  # a menu that closes brings nothing new
            self.focused.emit()

    def focusOutEvent(self, event: QFocusEvent) -> None:
        super().focusOutEvent(event)
        self._bursts.end()
        self.deselect()
        self.setCursorPosition(0)
