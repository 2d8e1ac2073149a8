"""A bar over the work that offers something and waits, without standing in the way."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtGui import QColor, QPainter, QPaintEvent
from PySide6.QtWidgets import QFrame, QHBoxLayout, QWidget

from qovr_app.style.palette import theme_in_force
from qovr_app.style.spacing import SPACE
from qovr_app.widgets.parts import CompactButton, words


class Notice(QFrame):
    """One sentence and its answers; hidden until it has something to say."""

    def __init__(self, name: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName(name)
        self._text = words(f"{name}.text", self)
        self._buttons: list[CompactButton] = []
        self._layout = QHBoxLayout(self)
        self._layout.setContentsMargins(3 * SPACE, SPACE, 2 * SPACE, SPACE)
        self._layout.addWidget(self._text, 1)
        self.setVisible(False)

    def add_answer(self, name: str, text: str, tip: str, call: Callable[[], object]) -> None:
        """Add a button."""
        button = CompactButton(text, f"{self.objectName()}.{name}", tip, self)
        button.clicked.connect(lambda _checked: call())
        self._buttons.append(button)
        self._layout.addWidget(button)

    def ask(self, text: str) -> None:
        """Show the sentence and the answers."""
        self._text.setText(text)
        self.setAccessibleName(text)
        self.setVisible(True)

    def paintEvent(self, event: QPaintEvent) -> None:
        QPainter(self).fillRect(self.rect(), QColor(*theme_in_force().accent_cell))
        super().paintEvent(event)
