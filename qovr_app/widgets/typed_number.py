"""A number that is typed while the mouse holds something."""

from __future__ import annotations

from PySide6.QtCore import Qt
from PySide6.QtGui import QKeyEvent

from qovr_app.state.typed_numbers import typed_number

_SIGNS = "0123456789.,-"
_LONGEST = 20


class TypedNumber:
    """What has been typed so far; as long as there is something, it and not the mouse says the value."""

    def __init__(self) -> None:
        self.text = ""

    @property
    def value(self) -> float | None:
        """The number that stands there; None where it is none yet."""
        number = typed_number(self.text)
        return number if isinstance(number, float) else None

    def take(self, event: QKeyEvent) -> bool:
        """Take a key; return whether the text has changed."""
        before = self.text
        if event.key() == Qt.Key.Key_Backspace:
            self.text = self.text[:-1]
        elif event.text() and event.text() in _SIGNS and len(self.text) < _LONGEST:
            self.text += event.text()
        return self.text != before
