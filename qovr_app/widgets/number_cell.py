"""A line edit that shows a number on a cell: what the number is, and what there is to say of it."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QRectF, Qt
from PySide6.QtGui import QColor, QEnterEvent, QPainter, QPaintEvent
from PySide6.QtWidgets import QWidget

from qovr_app.style.digits import digits_in_force
from qovr_app.style.palette import see_through, theme_in_force
from qovr_app.style.symbols import symbols_in_plain
from qovr_app.widgets.bubble import say_at
from qovr_app.widgets.cell import Marks, paint_cell
from qovr_app.widgets.growing_line import LEAST_PADDING, PADDING, GrowingLine
from qovr_app.widgets.plain import plain_tip
from qovr_core.number_texts import fitted_text


class NumberCell(GrowingLine):
    """Shows a number with as many digits as fit, and paints its state behind it.

    Text that differs from that of the number is the field's own.
    """

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._value, self._shown = 0.0, ""
        self._error = self._said = self._warning = self._tip = ""
        self._is_unset = self._is_idle = self._is_marked = False
        self.setAcceptDrops(False)  # a file dropped here is meant for the window
        self.setPalette(see_through(self.palette()))

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
        if self._is_unset and not self._error:
            parts.insert(0, "Not set yet: Set writes it, Get brings the active value back.")
        elif self.has_own_text and not self._error:
            parts.insert(0, f"Not taken yet: Enter takes it, Esc brings {self._shown} back.")
        said = [part for part in parts if part]
        self.setToolTip(plain_tip(symbols_in_plain("\n".join([self.text(), *said]))))
        self.setAccessibleDescription("\n".join(said))
        self.fit()
        self.update()
        if self._error != self._said:
            self._say_error()

    def _say_error(self) -> None:
        """Say at the field what is wrong with it; once it is mended, at another one that is not."""
        self._said = self._error
        say_at(self, self._error)
        parent = self.parentWidget()
        if parent is not None and not self._error:
            for other in (cell for cell in parent.findChildren(NumberCell) if cell.error):
                say_at(other, other.error)

    # Looks

    def enterEvent(self, event: QEnterEvent) -> None:
        super().enterEvent(event)
        self.update()
        if self._error:
            say_at(self, self._error)

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
        metrics, text = self.fontMetrics(), self.text()
        padding = PADDING if metrics.horizontalAdvance(text) <= self.width() - 2 * PADDING else LEAST_PADDING
        room = self.width() - 2 * padding
        if not self.has_own_text:
            text = fitted_text(self._value, lambda wanted: metrics.horizontalAdvance(wanted) <= room, digits_in_force())
        if metrics.horizontalAdvance(text) > room:
            text = metrics.elidedText(text, Qt.TextElideMode.ElideRight, room)
        painter.setFont(self.font())
        painter.setPen(QColor(*(colours.idle_ink if self._is_idle and not self.is_pending else colours.ink)))
        painter.drawText(
            self.rect().adjusted(padding, 0, -padding, 0),
            Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter,
            text,
        )
