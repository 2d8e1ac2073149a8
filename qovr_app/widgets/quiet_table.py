"""What all tables of the program are: read only, without frame and grid, and an item in every cell."""

from __future__ import annotations

from PySide6.QtCore import QEvent, Qt
from PySide6.QtGui import QKeyEvent, QKeySequence
from PySide6.QtWidgets import QAbstractItemView, QFrame, QTableWidget, QTableWidgetItem, QWidget

from qovr_app.widgets.clipboard import Rows, copy_table

RIGHT = Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter
"""Where numbers stand in a cell."""


class QuietTable(QTableWidget):
    """A table in which items and headings are there as soon as they are asked for.

    Parameters
    ----------
    shape : how many rows and columns
    name, spoken : the object name, and the accessible one
    """

    def __init__(self, shape: tuple[int, int], name: str, spoken: str, parent: QWidget | None = None) -> None:
        super().__init__(*shape, parent)
        self.setObjectName(name)
        self.setAccessibleName(spoken)
        self.setFrameShape(QFrame.Shape.NoFrame)
        self.setShowGrid(False)
        self.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self.setTabKeyNavigation(False)
        self.style_headers()

    def item(self, row: int, column: int) -> QTableWidgetItem:
        item = super().item(row, column)
        if item is None:
            item = QTableWidgetItem()
            self.setItem(row, column, item)
        return item

    def horizontalHeaderItem(self, column: int) -> QTableWidgetItem:
        item = super().horizontalHeaderItem(column)
        if item is None:
            item = QTableWidgetItem()
            self.setHorizontalHeaderItem(column, item)
        return item

    def rows_to_copy(self) -> Rows:
        """Return what is copied of what is selected; nothing where nothing can be."""
        return []

    def copy(self) -> None:
        """Copy what is selected."""
        if rows := self.rows_to_copy():
            copy_table(rows)

    def style_headers(self) -> None:
        """Style the headers in the theme in force; what a style sheet has drawn once keeps its colours."""

    def event(self, event: QEvent) -> bool:
        if event.type() == QEvent.Type.ShortcutOverride and isinstance(event, QKeyEvent) and _is_own(event):
            event.accept()  # a table that has the keyboard is what is meant, not the window's commands
        return super().event(event)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.matches(QKeySequence.StandardKey.Copy):
            self.copy()
        else:
            super().keyPressEvent(event)

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.PaletteChange:
            self.style_headers()


def _is_own(event: QKeyEvent) -> bool:
    return any(event.matches(key) for key in (QKeySequence.StandardKey.Copy, QKeySequence.StandardKey.SelectAll))
