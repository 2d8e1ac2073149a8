"""A small table of computed numbers that can be selected and copied in full."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import QSize, Qt
from PySide6.QtGui import QGuiApplication, QKeyEvent, QKeySequence, QPalette
from PySide6.QtWidgets import QAbstractItemView, QFrame, QHeaderView, QTableWidget, QTableWidgetItem, QWidget

from qovr_app.panels.look import number_font, see_through
from qovr_app.panels.numbers import block_text, number_text
from qovr_core.arrays import Array

_SHOWN_DIGITS = 6
_ROW_BEYOND_TEXT = 4
_PLAIN_HEADERS = """
QHeaderView { background: transparent; }
QHeaderView::section, QTableCornerButton::section { border: none; background: transparent; }
QHeaderView::section { color: palette(placeholder-text); }
"""


class NumberTable(QTableWidget):
    """Rows and columns of numbers, read only; what is copied has every digit.

    Parameters
    ----------
    rows, columns : what the headers say; no row headers where ``rows`` is a number
    """

    def __init__(
        self, name: str, spoken: str, rows: list[str] | int, columns: list[str] | int, parent: QWidget | None = None
    ) -> None:
        counts = [len(part) if isinstance(part, list) else part for part in (rows, columns)]
        super().__init__(*counts, parent)
        self.setObjectName(name)
        self.setAccessibleName(spoken)
        self._numbers = np.full(counts, np.nan)
        self.setFont(number_font(self.font()))
        self.setPalette(see_through(self.palette()))
        self.setStyleSheet(_PLAIN_HEADERS)
        self.setFrameShape(QFrame.Shape.NoFrame)
        self.setShowGrid(False)
        self.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self.setTabKeyNavigation(False)
        self.setVerticalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self._set_headers(rows, columns)
        for r in range(counts[0]):
            for c in range(counts[1]):
                item = QTableWidgetItem()
                item.setTextAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
                self.setItem(r, c, item)
        height = self._content_height()
        self.setFixedHeight(height)

    def show_numbers(self, numbers: Array) -> None:
        """Show an array of the table's shape."""
        for (r, c), value in np.ndenumerate(numbers):
            if value != self._numbers[r, c]:
                item = self.item(r, c)
                item.setText(f"{value:.{_SHOWN_DIGITS}g}")
                item.setToolTip(number_text(value))
        self._numbers = np.array(numbers)

    def set_quiet(self, is_quiet: bool) -> None:
        """Dim numbers that are no longer true."""
        role = QPalette.ColorRole.PlaceholderText if is_quiet else QPalette.ColorRole.Text
        for r in range(self.rowCount()):
            for c in range(self.columnCount()):
                self.item(r, c).setForeground(self.palette().brush(role))

    def copy(self) -> None:
        """Copy what is selected, or all, as a spreadsheet takes it."""
        chosen = {(index.row(), index.column()) for index in self.selectedIndexes()}
        rows = sorted({r for r, _ in chosen}) or range(self.rowCount())
        columns = sorted({c for _, c in chosen}) or range(self.columnCount())
        QGuiApplication.clipboard().setText(block_text([[self._numbers[r, c] for c in columns] for r in rows]))

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.matches(QKeySequence.StandardKey.Copy):
            self.copy()
        else:
            super().keyPressEvent(event)

    def minimumSizeHint(self) -> QSize:
        return QSize(160, self._content_height())

    def _content_height(self) -> int:
        header = 0 if self.horizontalHeader().isHidden() else self._row_height()
        return header + self.rowCount() * self._row_height()

    def _row_height(self) -> int:
        return self.fontMetrics().height() + _ROW_BEYOND_TEXT

    def _set_headers(self, rows: list[str] | int, columns: list[str] | int) -> None:
        across, down = self.horizontalHeader(), self.verticalHeader()
        for header, titles in ((across, columns), (down, rows)):
            header.setVisible(isinstance(titles, list))
            header.setMinimumSectionSize(8)
            header.setSectionsClickable(False)
            header.setHighlightSections(False)
            header.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        across.setSectionResizeMode(QHeaderView.ResizeMode.Stretch)
        across.setDefaultAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
        across.setFixedHeight(self._row_height())
        down.setSectionResizeMode(QHeaderView.ResizeMode.Fixed)
        down.setDefaultSectionSize(self._row_height())
        if isinstance(columns, list):
            self.setHorizontalHeaderLabels(columns)
        if isinstance(rows, list):
            self.setVerticalHeaderLabels(rows)
