"""A cell in which a number can be typed."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import suppress

from PySide6.QtCore import QEvent, Signal
from PySide6.QtGui import QKeyEvent, QKeySequence
from PySide6.QtWidgets import QWidget

from qovr_app.state.typed import is_block
from qovr_app.state.typed_numbers import trimmed, typed_value
from qovr_app.widgets.clipboard import pasted_cells
from qovr_app.widgets.number_cell import NumberCell
from qovr_core import QovrError
from qovr_core.number_texts import number_text


class TypedField(NumberCell):
    """Shows a number exactly and lets another be typed.

    Its text is the shortest that reads back as the number. Text that differs from the shown number is the field's own:
    it stays until it is committed, reverted, or the number itself changes.

    Parameters
    ----------
    name : what messages call the field
    check : returns a typed value as the number it is, or raises a QovrError; its arguments are value and name

    Signals
    -------
    value_edited : a valid number and its gesture, 0 for none
    refused : why the text is no number for this field; empty when a refusal no longer holds
    text_owned : whether the field has text of its own has changed
    block_pasted : several cells are on the clipboard, and were pasted here
    """

    value_edited = Signal(float, int)
    refused = Signal(str)
    text_owned = Signal()
    block_pasted = Signal()

    def __init__(self, name: str, check: Callable[[object, str], float], parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._name, self._check = name, check
        self.textChanged.connect(self._on_text_changed)
        self.editingFinished.connect(self.commit)

    def show_value(self, value: float, *, is_unset: bool = False) -> None:
        """Show a number; the field's own text stays where the number is the one it had."""
        if value != self._value or not self._shown:
            self._put(value)
        if is_unset != self._is_unset:
            self._is_unset = is_unset
            self._refresh()

    def turn_to(self, name: str, tip: str, value: float, text: str | None) -> None:
        """Stand for another number, with its name and what it means, over which a text may be typed; silently."""
        self.blockSignals(True)
        self._name, self._tip = name, tip
        self._put(value)
        if text is not None:
            self.setText(text)
            with suppress(QovrError):
                self.typed()
            self._refresh()
        self.blockSignals(False)
        if self.hasFocus():
            self.selectAll()

    def revert(self) -> None:
        """Drop the field's own text."""
        self._put(self._value)

    def typed(self) -> float:
        """Return the number that the text says.

        Raises
        ------
        QovrError : it says none that the field may hold; the field is marked
        """
        if not self.has_own_text:
            return self._value
        try:
            return typed_value(self.text(), self._name, self._check, self._value)
        except QovrError as error:
            self._error = str(error)
            self._refresh()
            raise

    def commit(self) -> None:
        """Report the field's own text as an edit, or why it is none."""
        if not self.has_own_text:
            return
        try:
            value = self.typed()
        except QovrError as error:
            self.refused.emit(str(error))
            return
        self._put(value)
        self.value_edited.emit(value, 0)

    def refuse(self, value: float, reason: str) -> None:
        """Hold the text as the field's own again, whose number was refused; ``value`` is the number that stays."""
        self._value, self._shown, self._error = value, number_text(value), reason
        self._refresh()
        self.text_owned.emit()

    def accept(self) -> None:
        """Take the field's own text, which is a valid number, for the number it shows."""
        self._put(self.typed())

    def _put(self, value: float) -> None:
        had_error, own_text = bool(self._error), self.text() if self.has_own_text else None
        self._value, self._shown, self._error = value, number_text(value), ""
        was_blocked = self.blockSignals(True)  # the field is brought up to date once, below
        self.setText(self._shown)
        self.blockSignals(was_blocked)
        self.setModified(False)
        if not self.hasFocus():
            self.setCursorPosition(0)
        self._refresh()
        if own_text not in (None, self._shown):
            self.text_owned.emit()
        if had_error:
            self.refused.emit("")

    def _on_text_changed(self) -> None:
        if self._error:
            self._error = ""
            self.refused.emit("")
        self._refresh()
        self.text_owned.emit()

    def event(self, event: QEvent) -> bool:
        if event.type() == QEvent.Type.ShortcutOverride and isinstance(event, QKeyEvent):
            is_history = event.matches(QKeySequence.StandardKey.Undo) or event.matches(QKeySequence.StandardKey.Redo)
            if is_history and not self.has_own_text:
                # The line edit would keep these keys for itself; with nothing typed they are the document's.
                event.ignore()
                return False
        return super().event(event)

    def paste(self) -> None:
        """Paste a number in full, whatever of it the table shows; several cells are for whoever has their places."""
        try:
            cells = pasted_cells()
        except QovrError as error:
            self.refused.emit(str(error))
            return
        if is_block(cells):
            self.block_pasted.emit()
        elif cells and cells[0]:
            cell = cells[0][0]
            self.insert(trimmed(cell) if isinstance(cell, str) else number_text(cell))
