"""Where the reference picture lies under the net, and how clearly it is seen."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from PySide6.QtWidgets import QDialog, QDialogButtonBox, QFormLayout, QLineEdit, QWidget

from qovr_app.dialogs.buttons import allow, without_icons
from qovr_app.state.display import Underlay
from qovr_app.state.tools import checked_size
from qovr_app.state.typed_numbers import typed_value
from qovr_app.widgets.parts import named
from qovr_app.widgets.plain import plain_label
from qovr_core import DocumentError
from qovr_core.checks import checked_number, described
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
        changes: dict[str, Any] = {
            name: typed_value(
                field.text(), _FIELDS[name][1], _CHECKS.get(name, checked_number), getattr(self._first, name)
            )
            for name, field in self._fields.items()
        }
        return replace(self._first, **changes)

    def _check(self) -> None:
        """Say what is wrong with the fields, and let nothing wrong be accepted."""
        allow(self._ok, self._note, lambda: self.underlay)


def _checked_opacity(value: object, name: str) -> float:
    if not (isinstance(value, float) and 0 < value <= 1):
        raise DocumentError(name, described(value), "a number above 0, up to 1")
    return value


_CHECKS = {"width": checked_size, "height": checked_size, "opacity": _checked_opacity}
"""What may be typed into a field that is no coordinate."""
