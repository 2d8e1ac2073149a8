"""A small table of computed numbers that can be selected and copied in full."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import QModelIndex, QPersistentModelIndex, QSize, Qt
from PySide6.QtGui import QPalette
from PySide6.QtWidgets import (
    QAbstractButton,
    QHeaderView,
    QLabel,
    QSizePolicy,
    QStyledItemDelegate,
    QStyleOptionViewItem,
    QWidget,
)

from qovr_app.style.digits import digits_in_force
from qovr_app.style.fonts import number_font
from qovr_app.style.palette import see_through
from qovr_app.widgets.clipboard import Rows
from qovr_app.widgets.quiet_table import RIGHT, QuietTable
from qovr_core.arrays import Array
from qovr_core.number_texts import ALL_DIGITS, USUAL_DIGITS, fitted_text, number_text

_FEWEST_DIGITS = 3
_ROW_BEYOND_TEXT = 4
_TALLER = 1.2
"""How far a table may grow where there is more height than it needs: rows farther apart are read one by one."""

_ITEM_PADDING = 6
_ROW_HEADER_WIDTH = 28
_PLAIN_HEADERS = """
QHeaderView { background: transparent; }
QHeaderView::section, QTableCornerButton::section { border: none; background: transparent; }
QHeaderView::section { color: palette(placeholder-text); }
"""


class _FittingDelegate(QStyledItemDelegate):
    """Writes a number with as many digits as are shown and the column has room for; dimmed where it is true no more."""

    is_quiet = False

    def initStyleOption(self, option: QStyleOptionViewItem, index: QModelIndex | QPersistentModelIndex) -> None:
        super().initStyleOption(option, index)
        if self.is_quiet:
            option.palette.setBrush(QPalette.ColorRole.Text, option.palette.placeholderText())
        value = index.data(Qt.ItemDataRole.UserRole)
        room = option.rect.width() - _ITEM_PADDING
        for digits in range(digits_in_force(), _FEWEST_DIGITS - 1, -1):
            option.text = f"{value:.{digits}g}" if digits < ALL_DIGITS else number_text(value)
            if option.fontMetrics.horizontalAdvance(option.text) <= room:
                return
        option.text = fitted_text(value, lambda text: option.fontMetrics.horizontalAdvance(text) <= room)


class NumberTable(QuietTable):
    """Rows and columns of numbers, read only; what is copied has every digit.

    Parameters
    ----------
    corner : what stands above the row headers
    rows, columns : what the headers say
    """

    def __init__(
        self,
        name: str,
        spoken: str,
        *,
        corner: str,
        rows: list[str],
        columns: list[str],
        parent: QWidget | None = None,
    ) -> None:
        super().__init__((len(rows), len(columns)), name, spoken, parent)
        self._numbers = np.full((len(rows), len(columns)), np.nan)
        self.setFont(number_font(self.font()))
        self.setPalette(see_through(self.palette()))
        self._delegate = _FittingDelegate(self)
        self.setItemDelegate(self._delegate)
        self.setCornerButtonEnabled(False)
        self.setVerticalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self._set_headers(rows, columns)
        self._fill()
        self._corner = QLabel(corner, self)
        self._corner.setTextFormat(Qt.TextFormat.RichText)
        self._corner.setGeometry(0, 0, _ROW_HEADER_WIDTH, self._row_height())
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self.setMaximumHeight(round(_TALLER * self._content_height()))

    def show_numbers(self, numbers: Array) -> None:
        """Show an array of the table's shape."""
        for (r, c), value in np.ndenumerate(numbers):
            if value != self._numbers[r, c]:
                item = self.item(r, c)
                item.setData(Qt.ItemDataRole.UserRole, float(value))
                item.setText(f"{value:.{USUAL_DIGITS}g}")
                item.setToolTip(number_text(value))
        self._numbers = np.array(numbers)

    def set_quiet(self, is_quiet: bool) -> None:
        """Dim numbers that are no longer true."""
        if is_quiet != self._delegate.is_quiet:
            self._delegate.is_quiet = is_quiet
            self.viewport().update()

    def rows_to_copy(self) -> Rows:
        """Return what is selected, or all, with every digit."""
        chosen = {(index.row(), index.column()) for index in self.selectedIndexes()}
        rows = sorted({r for r, _ in chosen}) or range(self.rowCount())
        columns = sorted({c for _, c in chosen}) or range(self.columnCount())
        return [[float(self._numbers[r, c]) for c in columns] for r in rows]

    def sizeHint(self) -> QSize:
        return self.minimumSizeHint()

    def minimumSizeHint(self) -> QSize:
        return QSize(160, self._content_height())

    def style_headers(self) -> None:
        """Style the headers alone: a style sheet of the table's own would keep its numbers from the theme."""
        for part in (self.horizontalHeader(), self.verticalHeader(), *self.findChildren(QAbstractButton)):
            part.setStyleSheet(_PLAIN_HEADERS)

    def _content_height(self) -> int:
        return (self.rowCount() + 1) * self._row_height()

    def _row_height(self) -> int:
        return self.fontMetrics().height() + _ROW_BEYOND_TEXT

    def _fill(self) -> None:
        for r in range(self.rowCount()):
            for c in range(self.columnCount()):
                item = self.item(r, c)
                item.setTextAlignment(RIGHT)
                item.setData(Qt.ItemDataRole.UserRole, float("nan"))

    def _set_headers(self, rows: list[str], columns: list[str]) -> None:
        across, down = self.horizontalHeader(), self.verticalHeader()
        for header in (across, down):
            header.setMinimumSectionSize(8)
            header.setSectionsClickable(False)
            header.setHighlightSections(False)
            header.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        across.setSectionResizeMode(QHeaderView.ResizeMode.Stretch)
        across.setDefaultAlignment(RIGHT)
        across.setFixedHeight(self._row_height())
        down.setSectionResizeMode(QHeaderView.ResizeMode.Stretch)
        down.setFixedWidth(_ROW_HEADER_WIDTH)
        self.setHorizontalHeaderLabels(columns)
        self.setVerticalHeaderLabels(rows)
