"""A line edit that gives its text room while it has the keyboard, over its neighbours where it must."""

from __future__ import annotations

from PySide6.QtCore import QRect, QSize, Qt
from PySide6.QtGui import QFocusEvent, QMoveEvent, QResizeEvent
from PySide6.QtWidgets import QLineEdit, QSizePolicy, QWidget

from qovr_app.style.fonts import number_font
from qovr_core.number_texts import MORE_DIGITS

PADDING, LEAST_PADDING = 4, 1
"""Between the text and the edges of its cell, in logical pixels; the least one where digits have to be left out."""

_HEIGHT_BEYOND_TEXT = 4
_TALLER = 1.7
"""How far a field may grow where there is more height than the fields of a zone need."""

_FIRST_TEXT, _LEAST_TEXT = "0.0000", f"-0.0{MORE_DIGITS}"
"""What a field has room for at first, and at least: a sign, and the digits that say how large a number is."""

_CURSOR = 3
"""Room for the cursor behind the last digit, or the line edit scrolls the first one away."""


class GrowingLine(QLineEdit):
    """A line of digits at the right of its cell, which grows to the left while it has the keyboard."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._width: int | None = None
        self._least_text = _LEAST_TEXT
        self._cell = self.geometry()
        self._is_growing = False
        self.setFrame(False)
        self.setAlignment(Qt.AlignmentFlag.AlignRight)
        self.setTextMargins(PADDING - 2, 0, PADDING - 2, 0)
        self.setFont(number_font(self.font()))
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self.set_tallest(_TALLER)

    def set_tallest(self, part: float) -> None:
        """Grow at most to this multiple of what a line of text needs."""
        self.setMaximumHeight(round(part * self.sizeHint().height()))

    def set_width(self, width: int) -> None:
        """Give the field a width of its own; without, it fills what it is given."""
        self._width = width
        self.setSizePolicy(QSizePolicy.Policy.Fixed, QSizePolicy.Policy.Fixed)

    def sizeHint(self) -> QSize:
        return self._size_of(_FIRST_TEXT, PADDING + 1)

    def minimumSizeHint(self) -> QSize:
        return self._size_of(self._least_text, LEAST_PADDING + 1)

    def set_least_text(self, text: str) -> None:
        """Have room for at least this text; for a few digits where it is empty."""
        self._least_text = text or _LEAST_TEXT
        self.updateGeometry()

    def _size_of(self, text: str, padding: int) -> QSize:
        metrics = self.fontMetrics()
        width = metrics.horizontalAdvance(text) + 2 * padding if self._width is None else self._width
        return QSize(width, metrics.height() + _HEIGHT_BEYOND_TEXT)

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._on_placed()

    def moveEvent(self, event: QMoveEvent) -> None:
        super().moveEvent(event)
        self._on_placed()

    def _on_placed(self) -> None:
        if not self._is_growing:
            self._cell = self.geometry()
            self.fit()

    def focusInEvent(self, event: QFocusEvent) -> None:
        super().focusInEvent(event)
        self.fit()

    def focusOutEvent(self, event: QFocusEvent) -> None:
        super().focusOutEvent(event)
        self.fit()

    def fit(self) -> None:
        """Lie over the neighbours, to the left first, while the text has the keyboard and more digits than room."""
        wanted, whole = QRect(self._cell), self.parentWidget()
        needed = self.fontMetrics().horizontalAdvance(self.text()) + 2 * PADDING + _CURSOR
        if self.hasFocus() and needed > wanted.width() and whole is not None:
            wanted.setLeft(max(0, wanted.right() - needed + 1))
            wanted.setWidth(min(needed, whole.width() - wanted.left()))
            self.raise_()
        if wanted != self.geometry():
            self._is_growing = True
            self.setGeometry(wanted)
            self._is_growing = False
