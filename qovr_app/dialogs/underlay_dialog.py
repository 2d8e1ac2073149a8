"""Where the reference picture lies under the net, and how clearly it is seen."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

from PySide6.QtWidgets import QDialog, QDialogButtonBox, QFormLayout, QLineEdit, QWidget

from qovr_app.dialogs.buttons import without_icons
from qovr_app.state.display import Underlay
from qovr_app.state.typed_numbers import typed_number
from qovr_app.widgets.parts import named
from qovr_app.widgets.plain import plain_label
from qovr_core import QovrError
from qovr_core.checks import LARGEST_MAGNITUDE
from qovr_core.number_texts import number_text

_FIELDS = {
    "left": ("&Left edge, x", "Left edge"),
    "bottom": ("&Lower edge, y", "Lower edge"),
    "width": ("&Width", "Width"),
    "height": ("&Height", "Height"),
    "opacity": ("&Opacity", "Opacity"),
}
"""By the fields of an ``Underlay``: what stands before each, and what it is called in a sentence."""


class UnderlayDialog(QDialog):
    """Asks for the place of a picture; ``underlay`` holds it once the dialog was accepted.

    Parameters
    ----------
    first : what the fields begin with
    """

    def __init__(self, first: Underlay, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWindowTitle("Reference Picture")
        self.setObjectName("underlay")
        self._first = first
        self._note = named(plain_label("", self), "underlay.note")
        form = QFormLayout(self)
        form.addRow(plain_label("Where it lies, in the document's units, and its opacity from 0 to 1", self))
        self._fields: dict[str, QLineEdit] = {}
        for name, (label, spoken) in _FIELDS.items():
            field = named(QLineEdit(number_text(getattr(first, name)), self), f"underlay.{name}", spoken)
            field.textChanged.connect(self._check)
            self._fields[name] = field
            form.addRow(label, field)
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Ok | QDialogButtonBox.StandardButton.Cancel)
        buttons.accepted.connect(self.accept)
        buttons.rejected.connect(self.reject)
        self._ok = buttons.button(QDialogButtonBox.StandardButton.Ok)
        form.addRow(self._note)
        form.addRow(without_icons(buttons))

    @property
    def underlay(self) -> Underlay:
        """The picture where it is typed to lie.

        Raises
        ------
        QovrError : something is no number, or no size or opacity
        """
        values = {name: _typed(name, field.text()) for name, field in self._fields.items()}
        for name in ("width", "height"):
            if values[name] <= 0:
                raise QovrError(f"The {name} is {values[name]:g}; expected a number above 0.")
        if not 0 < values["opacity"] <= 1:
            raise QovrError(f"The opacity is {values['opacity']:g}; expected a number above 0, up to 1.")
        changes: dict[str, Any] = {**values}
        return replace(self._first, **changes)

    def _check(self) -> None:
        """Say what is wrong with the fields, and let nothing wrong be accepted."""
        reason = ""
        try:
            _ = self.underlay
        except QovrError as error:
            reason = str(error)
        self._note.setText(reason)
        self._ok.setEnabled(not reason)


def _typed(name: str, text: str) -> float:
    value = typed_number(text)
    if not isinstance(value, float) or not math.isfinite(value) or abs(value) > LARGEST_MAGNITUDE:
        raise QovrError(f"{_FIELDS[name][1]} is no number; expected one as 0.35 or -2.")
    return value
