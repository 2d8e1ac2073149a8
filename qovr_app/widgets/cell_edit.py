"""A field that paints its own cell: what is marked is seen behind the text, and said in its tool tip."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QRectF, QSize, Qt, Signal
from PySide6.QtGui import QColor, QFocusEvent, QFontMetrics, QMouseEvent, QPainter, QPaintEvent
from PySide6.QtWidgets import QLineEdit, QSizePolicy, QWidget

from qovr_app.style.canvas import painting
from qovr_app.style.fonts import number_font
from qovr_app.style.palette import see_through, theme_in_force
from qovr_app.widgets.cell import Marks, paint_cell

_PADDING = 4
_HEIGHT_BEYOND_TEXT = 4


class CellEdit(QLineEdit):
    """A line edit over a cell; the first press of the mouse takes the whole text, as the keyboard does.

    Signals
    -------
    focused : the field has the keyboard now
    """

    focused = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._error = self._warning = self._tip = ""
        self._is_idle = self._is_marked = self._selects_on_release = False
        self.setFrame(False)
        self.setAcceptDrops(False)  # a file dropped here is meant for the window
        self.setAlignment(Qt.AlignmentFlag.AlignRight)
        self.setTextMargins(_PADDING - 2, 0, _PADDING - 2, 0)
        self.setPalette(see_through(self.palette()))
        self.setFont(number_font(self.font()))
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)

    # What its kinds say

    @property
    def is_pending(self) -> bool:
        """Whether what the field holds is not set."""
        return False

    def painted_text(self, room: int) -> str:
        """Return what is painted while the field has no focus, in so many pixels."""
        return self.fontMetrics().elidedText(self.text(), Qt.TextElideMode.ElideRight, room)

    # Marks

    @property
    def error(self) -> str:
        """Why the field's own text was refused; empty where it was not."""
        return self._error

    @property
    def is_marked(self) -> bool:
        """Whether the field belongs to what is selected elsewhere."""
        return self._is_marked

    def set_error(self, text: str) -> None:
        """Mark a text that was refused; empty takes the mark away."""
        self._error = text
        self.refresh()

    def set_tip(self, text: str) -> None:
        """Say what the field means."""
        self._tip = text
        self.refresh()

    def set_warning(self, text: str) -> None:
        """Mark what is allowed but will surprise; empty takes the mark away."""
        if text != self._warning:
            self._warning = text
            self.refresh()

    def set_idle(self, is_idle: bool) -> None:
        """Dim what has no effect now."""
        if is_idle != self._is_idle:
            self._is_idle = is_idle
            self.refresh()

    def set_marked(self, is_marked: bool) -> None:
        """Frame what belongs to what is selected elsewhere."""
        if is_marked != self._is_marked:
            self._is_marked = is_marked
            self.update()

    def refresh(self) -> None:
        """Say and paint what holds now."""
        parts = [self._error, self._warning, self._tip]
        if self.is_pending and not self._error:
            parts.insert(0, "Not set yet: Set writes it, Get brings the active value back.")
        self.setToolTip("\n".join(part for part in parts if part))
        self.setAccessibleDescription(self.toolTip())
        self.update()

    # Mouse and focus

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        super().mouseReleaseEvent(event)
        if self._selects_on_release and not self.hasSelectedText():
            self.selectAll()
        self._selects_on_release = False

    def focusInEvent(self, event: QFocusEvent) -> None:
        super().focusInEvent(event)
        self._selects_on_release = event.reason() == Qt.FocusReason.MouseFocusReason
        self.focused.emit()

    def focusOutEvent(self, event: QFocusEvent) -> None:
        super().focusOutEvent(event)
        self.deselect()
        self.setCursorPosition(0)

    # Looks

    def sizeHint(self) -> QSize:
        return _size(self.fontMetrics(), "0.0000")

    def minimumSizeHint(self) -> QSize:
        return _size(self.fontMetrics(), "0.00")

    def event(self, event: QEvent) -> bool:
        if event.type() in (QEvent.Type.Enter, QEvent.Type.Leave):
            self.update()
        return super().event(event)

    def paintEvent(self, event: QPaintEvent) -> None:
        marks = Marks(
            is_pending=self.is_pending,
            is_bad=bool(self._error),
            is_warned=bool(self._warning),
            is_marked=self._is_marked,
            has_focus=self.hasFocus(),
            is_hovered=self.underMouse(),
        )
        with painting(self) as painter:
            paint_cell(painter, QRectF(self.rect()), marks)
        if self.hasFocus():
            super().paintEvent(event)
        else:
            self._paint_text()

    def _paint_text(self) -> None:
        colours, painter = theme_in_force(), QPainter(self)
        painter.setFont(self.font())
        painter.setPen(QColor(*(colours.idle_ink if self._is_idle and not self.is_pending else colours.ink)))
        painter.drawText(
            self.rect().adjusted(_PADDING, 0, -_PADDING, 0),
            Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter,
            self.painted_text(self.width() - 2 * _PADDING),
        )


def _size(metrics: QFontMetrics, text: str) -> QSize:
    return QSize(metrics.horizontalAdvance(text) + 2 * _PADDING + 2, metrics.height() + _HEIGHT_BEYOND_TEXT)
