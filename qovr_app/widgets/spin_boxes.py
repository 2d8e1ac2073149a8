"""Fields with arrows for the dialogs, which take and show numbers as all other fields of the program do."""

from __future__ import annotations

from PySide6.QtGui import QValidator
from PySide6.QtWidgets import QDoubleSpinBox, QSpinBox, QWidget

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
        value = typed_number(text)
        return value if isinstance(value, float) else self.value()

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
        value = typed_number(text)
        return round(value) if isinstance(value, float) else self.value()

    def validate(self, text: str, position: int) -> tuple[QValidator.State, str, int]:
        value = typed_number(text)
        if isinstance(value, float) and not value.is_integer():
            return QValidator.State.Intermediate, text, position
        return _state_of(text, self.minimum(), self.maximum()), text, position


def _state_of(text: str, least: float, most: float) -> QValidator.State:
    """Return whether a text is a number of a range; what is none yet may be on the way to one."""
    value = typed_number(text)
    is_good = isinstance(value, float) and least <= value <= most
    return QValidator.State.Acceptable if is_good else QValidator.State.Intermediate
