"""A line edit that shows a number on a cell: what the number is, and what there is to say of it."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QRect, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QEnterEvent, QFocusEvent, QMoveEvent, QPainter, QPaintEvent, QResizeEvent
from PySide6.QtWidgets import QLineEdit, QSizePolicy, QWidget

from qovr_app.style.fonts import number_font
from qovr_app.style.palette import see_through, theme_in_force
from qovr_app.widgets.cell import Marks, paint_cell
from qovr_app.widgets.plain import plain_tip
from qovr_core.number_texts import MORE_DIGITS, fitted_text

_PADDING = 4
_HEIGHT_BEYOND_TEXT = 4
_FIRST_TEXT, _LEAST_TEXT = "-0.0000", f"-1{MORE_DIGITS}e{MORE_DIGITS}"
"""What a field has room for at first, and at least: a sign, and the digits that say how large a number is."""

_CURSOR = 3
"""Room for the cursor behind the last digit, or the line edit scrolls the first one away."""


class NumberCell(QLineEdit):
    """Shows a number with as many digits as fit, and paints its state behind it.

    Text that differs from that of the number is the field's own.
    """

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._value, self._shown = 0.0, ""
        self._error = self._warning = self._tip = ""
        self._is_unset = self._is_idle = self._is_marked = False
        self._width: int | None = None
        self._cell = self.geometry()
        self._is_growing = False
        self.setFrame(False)
        self.setAcceptDrops(False)  # a file dropped here is meant for the window
        self.setAlignment(Qt.AlignmentFlag.AlignRight)
        self.setTextMargins(_PADDING - 2, 0, _PADDING - 2, 0)
        self.setPalette(see_through(self.palette()))
        self.setFont(number_font(self.font()))
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)

    # The number

    @property
    def value(self) -> float:
        """The number that was shown last, whatever is typed over it."""
        return self._value

    @property
    def has_own_text(self) -> bool:
        """Whether the field holds text that is not its number."""
        return self.text() != self._shown

    @property
    def is_pending(self) -> bool:
        """Whether what the field holds is not set."""
        return self._is_unset or self.has_own_text

    @property
    def error(self) -> str:
        """Why the field's own text was refused; empty where it was not."""
        return self._error

    # Marks

    @property
    def is_marked(self) -> bool:
        """Whether the number belongs to what is selected elsewhere."""
        return self._is_marked

    def set_width(self, width: int) -> None:
        """Give the field a width of its own; without, it fills what it is given."""
        self._width = width
        self.setSizePolicy(QSizePolicy.Policy.Fixed, QSizePolicy.Policy.Fixed)

    def set_tip(self, text: str) -> None:
        """Say what the number means."""
        self._tip = text
        self._refresh()

    def set_warning(self, text: str) -> None:
        """Mark a number that is allowed but will surprise; empty takes the mark away."""
        if text != self._warning:
            self._warning = text
            self._refresh()

    def set_idle(self, is_idle: bool) -> None:
        """Dim a number that has no effect now."""
        if is_idle != self._is_idle:
            self._is_idle = is_idle
            self._refresh()

    def set_marked(self, is_marked: bool) -> None:
        """Frame a number that belongs to what is selected elsewhere."""
        if is_marked != self._is_marked:
            self._is_marked = is_marked
            self.update()

    def _refresh(self) -> None:
        parts = [self._error, self._warning, self._tip]
        if self.is_pending and not self._error:
            parts.insert(0, "Not set yet: Set writes it, Get brings the active value back.")
        said = [part for part in parts if part]
        self.setToolTip(plain_tip("\n".join([self.text(), *said])))
        self.setAccessibleDescription("\n".join(said))
        self._fit()
        self.update()

    # Looks

    def sizeHint(self) -> QSize:
        return self._size_of(_FIRST_TEXT)

    def minimumSizeHint(self) -> QSize:
        return self._size_of(_LEAST_TEXT)

    def _size_of(self, text: str) -> QSize:
        metrics = self.fontMetrics()
        width = metrics.horizontalAdvance(text) + 2 * _PADDING + 2 if self._width is None else self._width
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
            self._fit()

    def focusInEvent(self, event: QFocusEvent) -> None:
        super().focusInEvent(event)
        self._fit()

    def focusOutEvent(self, event: QFocusEvent) -> None:
        super().focusOutEvent(event)
        self._fit()

    def _fit(self) -> None:
        """Lie over the neighbours, to the left first, while the text has the keyboard and more digits than room."""
        wanted, whole = QRect(self._cell), self.parentWidget()
        needed = self.fontMetrics().horizontalAdvance(self.text()) + 2 * _PADDING + _CURSOR
        if self.hasFocus() and needed > wanted.width() and whole is not None:
            wanted.setLeft(max(0, wanted.right() - needed + 1))
            wanted.setWidth(min(needed, whole.width() - wanted.left()))
            self.raise_()
        if wanted != self.geometry():
            self._is_growing = True
            self.setGeometry(wanted)
            self._is_growing = False

    def enterEvent(self, event: QEnterEvent) -> None:
        super().enterEvent(event)
        self.update()

    def leaveEvent(self, event: QEvent) -> None:
        super().leaveEvent(event)
        self.update()

    def paintEvent(self, event: QPaintEvent) -> None:
        painter = QPainter(self)
        paint_cell(painter, QRectF(self.rect()), self._marks())
        painter.end()
        if self.hasFocus():
            super().paintEvent(event)
        else:
            self._paint_text()

    def _marks(self) -> Marks:
        return Marks(
            is_pending=self.is_pending,
            is_bad=bool(self._error),
            is_warned=bool(self._warning),
            is_marked=self._is_marked,
            has_focus=self.hasFocus(),
            is_hovered=self.underMouse(),
        )

    def _paint_text(self) -> None:
        colours, painter = theme_in_force(), QPainter(self)
        room = self.width() - 2 * _PADDING
        metrics = self.fontMetrics()
        text = self.text()
        if not self.has_own_text:
            text = fitted_text(self._value, lambda wanted: metrics.horizontalAdvance(wanted) <= room)
        if metrics.horizontalAdvance(text) > room:
            text = metrics.elidedText(text, Qt.TextElideMode.ElideRight, room)
        painter.setFont(self.font())
        painter.setPen(QColor(*(colours.idle_ink if self._is_idle and not self.is_pending else colours.ink)))
        painter.drawText(
            self.rect().adjusted(_PADDING, 0, -_PADDING, 0),
            Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter,
            text,
        )
