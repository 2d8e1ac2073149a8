"""Between which two values the colours of the surface are spread."""

from __future__ import annotations

import math

from PySide6.QtWidgets import QDialog, QDialogButtonBox, QFormLayout, QLineEdit, QWidget

from qovr_app.dialogs.buttons import allow, without_icons
from qovr_app.state.typed_numbers import typed_value
from qovr_app.widgets.parts import named
from qovr_app.widgets.plain import plain_label
from qovr_core import DocumentError, QovrError
from qovr_core.checks import described
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
        self._first = limits
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
        ends = ("The lower end", self._low, self._first[0]), ("The upper end", self._high, self._first[1])
        low, high = (typed_value(field.text(), name, _checked_end, first) for name, field, first in ends)
        if not low < high:
            raise QovrError("The upper end has to lie above the lower one")
        return low, high

    def _check(self) -> None:
        """Say what is wrong with the fields, and let nothing wrong be accepted."""
        allow(self._ok, self._note, lambda: self.limits)


def _checked_end(value: object, name: str) -> float:
    if not (isinstance(value, float) and math.isfinite(value)):
        raise DocumentError(name, described(value), "a number as 0.35 or -2e-4")
    return value
