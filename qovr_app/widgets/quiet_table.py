"""What all tables of the program are: read only, without frame and grid, and an item in every cell."""

from __future__ import annotations

from PySide6.QtCore import QEvent, Qt
from PySide6.QtGui import QContextMenuEvent, QKeyEvent, QKeySequence
from PySide6.QtWidgets import QAbstractItemView, QFrame, QMenu, QTableWidget, QTableWidgetItem, QWidget

from qovr_app.state.html_tables import Shown
from qovr_app.widgets.clipboard import Rows, copy_latex, copy_table
from qovr_app.widgets.row_order import RowOrder

RIGHT = Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter
"""Where numbers stand in a cell."""

LATEX_KEYS = QKeySequence("Ctrl+Alt+L")


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
        self.order = RowOrder(self)
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

    def whole_table(self) -> Rows:
        """Return the whole table in the order that is shown, its headings first."""
        texts = (self.horizontalHeaderItem(column).text() for column in range(self.columnCount()))
        heads = [text.replace("\n", "") for text in texts]  # a narrow table breaks them
        body = [[self.copied_cell(row, column) for column in range(self.columnCount())] for row in self.shown_rows()]
        return body if self.horizontalHeader().isHidden() else [heads, *body]

    def copied_cell(self, row: int, column: int) -> str | Shown:
        """Return what is copied of a cell."""
        return self.item(row, column).text()

    def rows_to_copy(self) -> Rows:
        """Return what Copy copies: the cells that are selected, or the whole table where none can be."""
        selected = {(index.row(), index.column()) for index in self.selectedIndexes()}
        if not selected or self.selectionMode() is QAbstractItemView.SelectionMode.SingleSelection:
            return self.whole_table()
        cells = {row: sorted(column for r, column in selected if r == row) for row in self.shown_rows()}
        return [[self.copied_cell(row, column) for column in columns] for row, columns in cells.items() if columns]

    def copy(self) -> None:
        """Copy what is selected."""
        copy_table(self.rows_to_copy())

    def copy_latex(self) -> None:
        """Copy the whole table for LaTeX."""
        copy_latex(self.whole_table())

    def shown_rows(self) -> list[int]:
        """Return the numbers of the rows from top to bottom."""
        return self.order.rows()

    def sort_key(self, row: int, column: int) -> float | str | None:
        """Return what rows are sorted by; those with None come last."""
        return self.item(row, column).text()

    def contextMenuEvent(self, event: QContextMenuEvent) -> None:
        menu = QMenu(self)
        menu.setObjectName(f"{self.objectName()}.menu")
        menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        for text, keys, act in (
            ("&Copy", QKeySequence(QKeySequence.StandardKey.Copy), self.copy),
            ("Copy Table", QKeySequence(), lambda: copy_table(self.whole_table())),
            ("Copy Table as &LaTeX", LATEX_KEYS, self.copy_latex),
        ):
            menu.addAction(text, keys, act)
        self.order.add_actions(menu)
        menu.popup(event.globalPos())

    def style_headers(self) -> None:
        """Style the headers in the theme in force; what a style sheet has drawn once keeps its colours."""

    def event(self, event: QEvent) -> bool:
        if event.type() == QEvent.Type.ShortcutOverride and isinstance(event, QKeyEvent) and _is_own(event):
            event.accept()  # a table that has the keyboard is what is meant, not the window's commands
        return super().event(event)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.matches(QKeySequence.StandardKey.Copy):
            self.copy()
        elif _is_for_latex(event):
            self.copy_latex()
        else:
            super().keyPressEvent(event)

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.PaletteChange:
            self.style_headers()


def _is_for_latex(event: QKeyEvent) -> bool:
    return QKeySequence(event.keyCombination()) == LATEX_KEYS


def _is_own(event: QKeyEvent) -> bool:
    keys = QKeySequence.StandardKey.Copy, QKeySequence.StandardKey.SelectAll
    return _is_for_latex(event) or any(event.matches(key) for key in keys)
