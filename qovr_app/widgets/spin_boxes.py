"""Fields with arrows for the dialogs, which take and show numbers as all other fields of the program do."""

from __future__ import annotations

from PySide6.QtGui import QValidator
from PySide6.QtWidgets import QDoubleSpinBox, QSpinBox, QWidget

from qovr_app.state.calculation import worked_out
from qovr_app.state.typed_numbers import typed_number
from qovr_app.widgets.wheel import guard_from_wheels
from qovr_core.number_texts import number_text


class NumberBox(QDoubleSpinBox):
    """A number with a decimal point or comma, whatever the system's language is, and no group separators."""

    def __init__(self, least: float, most: float, decimals: int, value: float, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        guard_from_wheels(self)
        self.editingFinished.connect(lambda: self.lineEdit().setText(self.textFromValue(self.value())))
        self.setDecimals(decimals)
        self.setRange(least, most)
        self.setValue(value)

    def fixup(self, text: str) -> str:
        return text  # Qt would take group separators away

    def textFromValue(self, value: float) -> str:
        return number_text(round(value, self.decimals()))

    def valueFromText(self, text: str) -> float:
        value = _number(text)
        return self.value() if value is None else value

    def validate(self, text: str, position: int) -> tuple[QValidator.State, str, int]:
        return _state_of(text, self.minimum(), self.maximum()), text, position


class CountBox(QSpinBox):
    """A whole number without group separators."""

    def __init__(self, least: int, most: int, value: int, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        guard_from_wheels(self)
        self.editingFinished.connect(lambda: self.lineEdit().setText(self.textFromValue(self.value())))
        self.setRange(least, most)
        self.setValue(value)

    def fixup(self, text: str) -> str:
        return text  # Qt would take group separators away

    def textFromValue(self, value: int) -> str:
        return str(value)

    def valueFromText(self, text: str) -> int:
        value = _number(text)
        return self.value() if value is None else round(value)

    def validate(self, text: str, position: int) -> tuple[QValidator.State, str, int]:
        value = _number(text)
        if value is not None and not value.is_integer():
            return QValidator.State.Intermediate, text, position
        return _state_of(text, self.minimum(), self.maximum()), text, position


def _number(text: str) -> float | None:
    """Return the number that a text says, or that is worked out in it; None where it says none.

    Nothing goes on from the present number, which follows every key that is typed.
    """
    value = typed_number(text)
    if isinstance(value, float):
        return value
    return None if text.strip()[:1] in _GOING_ON else worked_out(text, 0.0)


_GOING_ON = ("", "+", "*", "/")


def _state_of(text: str, least: float, most: float) -> QValidator.State:
    """Return whether a text is a number of a range; what is none yet may be on the way to one."""
    value = _number(text)
    is_good = value is not None and least <= value <= most
    return QValidator.State.Acceptable if is_good else QValidator.State.Intermediate
