"""Rows in another order: only where they are shown changes, so that a row keeps its number."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Protocol

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QHeaderView, QMenu

Key = float | str | None


class _Table(Protocol):
    def rowCount(self) -> int: ...
    def horizontalHeader(self) -> QHeaderView: ...
    def verticalHeader(self) -> QHeaderView: ...
    def sort_key(self, row: int, column: int) -> Key: ...


class RowOrder:
    """Sorts a table's rows by a column whose heading is clicked: upwards, downwards, and back to their own order."""

    def __init__(self, table: _Table) -> None:
        self._table = table
        self._column: int | None = None
        self._order = Qt.SortOrder.AscendingOrder

    def let_sort(self) -> None:
        """Take clicks on headings."""
        across = self._table.horizontalHeader()
        across.setSectionsClickable(True)
        across.setSortIndicatorClearable(True)
        across.sectionClicked.connect(self._on_clicked)

    def rows(self) -> list[int]:
        """Return the numbers of the rows from top to bottom."""
        down = self._table.verticalHeader()
        return [down.logicalIndex(place) for place in range(self._table.rowCount())]

    def sort(self, column: int | None, order: Qt.SortOrder = Qt.SortOrder.AscendingOrder) -> None:
        """Sort by a column; None brings back the rows' own order."""
        self._column, self._order = column, order
        across = self._table.horizontalHeader()
        across.setSortIndicatorShown(column is not None)
        if column is not None:
            across.setSortIndicator(column, order)
        self.refresh()

    def refresh(self) -> None:
        """Sort again, by what stands in the table now."""
        down = self._table.verticalHeader()
        for place, row in enumerate(self._wanted()):
            down.moveSection(down.visualIndex(row), place)

    def add_actions(self, menu: QMenu) -> None:
        """Add to a context menu the way back to the rows' own order, where they are sorted."""
        if self._column is not None:
            menu.addSeparator()
            menu.addAction("Rows in Their &Own Order", self._restore)

    def _restore(self) -> None:
        self.sort(None)

    def _on_clicked(self, column: int) -> None:
        if column != self._column:
            self.sort(column)
        elif self._order is Qt.SortOrder.AscendingOrder:
            self.sort(column, Qt.SortOrder.DescendingOrder)
        else:
            self.sort(None)

    def _wanted(self) -> list[int]:
        rows = list(range(self._table.rowCount()))
        column = self._column
        if column is None:
            return rows
        keys = {row: self._table.sort_key(row, column) for row in rows}
        numbers, words = (
            sorted((row for row in rows if isinstance(keys[row], kind)), key=_by(keys)) for kind in (float, str)
        )
        if self._order is Qt.SortOrder.DescendingOrder:
            numbers, words = numbers[::-1], words[::-1]
        return [*numbers, *words, *(row for row in rows if keys[row] is None)]


def _by(keys: dict[int, Key]) -> Callable[[int], Any]:
    return keys.__getitem__
