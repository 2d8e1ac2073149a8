"""Between which two values the colours of the surface are spread."""

from __future__ import annotations

import math

from PySide6.QtWidgets import QDialog, QDialogButtonBox, QFormLayout, QLineEdit, QWidget

from qovr_app.dialogs.buttons import without_icons
from qovr_app.state.typed_numbers import typed_number
from qovr_app.widgets.parts import named
from qovr_app.widgets.plain import plain_label
from qovr_core import QovrError
from qovr_core.fields import Range
from qovr_core.number_texts import number_text


class RangeDialog(QDialog):
    """Asks for a lower and an upper end; ``limits`` holds them once the dialog was accepted.

    Parameters
    ----------
    title : what the values are
    limits : what the fields begin with
    """

    def __init__(self, title: str, limits: Range, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWindowTitle("Fixed Colour Range")
        self.setObjectName("colour_range")
        self._low, self._high = (self._end(name, value) for name, value in zip(("low", "high"), limits, strict=True))
        self._note = named(plain_label("", self), "colour_range.note")
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Ok | QDialogButtonBox.StandardButton.Cancel)
        buttons.accepted.connect(self.accept)
        buttons.rejected.connect(self.reject)
        self._ok = buttons.button(QDialogButtonBox.StandardButton.Ok)
        form = QFormLayout(self)
        form.addRow(plain_label(title, self))
        form.addRow("&From", self._low)
        form.addRow("&To", self._high)
        form.addRow(self._note)
        form.addRow(without_icons(buttons))
        for field in (self._low, self._high):
            field.textChanged.connect(self._check)
        self._low.selectAll()
        self._check()

    def _end(self, name: str, value: float) -> QLineEdit:
        return named(QLineEdit(number_text(value), self), f"colour_range.{name}", f"Colours, {name} end")

    @property
    def limits(self) -> Range:
        """The ends as they are typed.

        Raises
        ------
        QovrError : one is no number, or the upper one does not lie above the lower one
        """
        low, high = _end_typed("lower", self._low.text()), _end_typed("upper", self._high.text())
        if not low < high:
            raise QovrError("The upper end has to lie above the lower one.")
        return low, high

    def _check(self) -> None:
        """Say what is wrong with the fields, and let nothing wrong be accepted."""
        reason = ""
        try:
            _ = self.limits
        except QovrError as error:
            reason = str(error)
        self._note.setText(reason)
        self._ok.setEnabled(not reason)


def _end_typed(name: str, text: str) -> float:
    end = typed_number(text)
    if not isinstance(end, float) or not math.isfinite(end):
        raise QovrError(f"The {name} end is no number; expected one as 0.35 or -2e-4.")
    return end
