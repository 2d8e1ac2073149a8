"""The table of the comparison: one row a measure, one column a surface; the best is bold, the worst in italics."""

from __future__ import annotations

from math import isfinite

from PySide6.QtCore import QRect, QSize, Qt
from PySide6.QtGui import QColor, QFont, QFontMetrics, QResizeEvent
from PySide6.QtWidgets import QAbstractItemView, QHeaderView, QWidget

from qovr_app.state.html_tables import Shown
from qovr_app.style.fonts import number_font
from qovr_app.style.palette import theme_in_force
from qovr_app.style.spacing import SPACE
from qovr_app.widgets.quiet_table import RIGHT, QuietTable
from qovr_core.laboratory.comparison import Measures, compared_names
from qovr_core.laboratory.comparison_report import ROWS, surface_descriptions, surface_titles

_ROW_BEYOND_TEXT = 2
_CELL_ROOM = 2 * SPACE
"""Of a cell's width, what the style keeps free beside its text."""

_NUMBER_ROOM = 6
_USUAL_NUMBER = "0.01234"
"""For what columns have room before anything is measured, so that none moves when it is."""

_VALUE = Qt.ItemDataRole.UserRole
"""Where a cell has its number in full."""


class ComparisonTable(QuietTable):
    """Shows measures as they come; those of the document before are pale until then."""

    def __init__(self, parent: QWidget | None = None) -> None:
        self._names, self._titles = compared_names(), surface_titles()
        shape = len(ROWS), 1 + len(self._names)
        spoken = "Measures of the QOVR surface and of the classical surfaces of its net"
        super().__init__(shape, "laboratory.comparison.table", spoken, parent)
        self._new: set[str] = set()
        self.setFont(number_font(self.font()))
        self.setAlternatingRowColors(True)
        self.setWordWrap(False)
        self.setSelectionMode(QAbstractItemView.SelectionMode.ContiguousSelection)
        self.setVerticalScrollMode(QAbstractItemView.ScrollMode.ScrollPerPixel)
        self.setHorizontalScrollMode(QAbstractItemView.ScrollMode.ScrollPerPixel)
        self._fill()
        self._arrange_headers()
        self.refresh_colours()

    def show_compared(self, shown: str | None) -> None:
        """Set apart the surface that the view shows besides QOVR, if any, by its name."""
        for column, name in enumerate(self._names, start=1):
            font = QFont(self.font())
            font.setBold(name == shown)
            self.horizontalHeaderItem(column).setFont(font)

    def show_measures(self, name: str, measures: Measures, net_size: float) -> None:
        """Show the measures of one surface."""
        self._new.add(name)
        for row, measure in enumerate(ROWS):
            text = measure.text(measures, net_size)
            item = self.item(row, 1 + self._names.index(name))
            item.setText(text)
            value = measure.value(measures)
            has_number = value is not None and isfinite(value)
            item.setData(_VALUE, value if has_number else None)
            item.setToolTip(f"{value!r}\n{measure.explanation}" if has_number else measure.explanation)
            spoken = f"{measure.label}, {self._titles[name]}: {text}"
            item.setData(Qt.ItemDataRole.AccessibleTextRole, spoken)
        self.order.refresh()
        self.refresh_colours()
        self._fit_measures()

    def set_old(self) -> None:
        """Mark everything shown as measured on the document before."""
        if self._new:
            self._new.clear()
            self.refresh_colours()

    def clear_measures(self) -> None:
        """Take all numbers away."""
        for row in range(len(ROWS)):
            for column in range(1, self.columnCount()):
                self.item(row, column).setText("")
                self.item(row, column).setData(_VALUE, None)

    def refresh_colours(self) -> None:
        """Take the colours of the theme in force."""
        ink, idle_ink = QColor(*theme_in_force().ink), QColor(*theme_in_force().idle_ink)
        for row in range(len(ROWS)):
            self.item(row, 0).setForeground(ink)
            for column, name in enumerate(self._names, start=1):
                self.item(row, column).setForeground(ink if name in self._new else idle_ink)
            self._mark_row(row)

    def copied_cell(self, row: int, column: int) -> str | Shown:
        text, value = self.item(row, column).text(), self.item(row, column).data(_VALUE)
        return text if value is None else Shown(text, value)

    def sort_key(self, row: int, column: int) -> float | str | None:
        value: float | None = self.item(row, column).data(_VALUE)
        return value if column else self.item(row, 0).text()

    def _mark_row(self, row: int) -> None:
        """Set apart the best and the worst of a measure, once all are there and where one is better than another."""
        items = [self.item(row, column) for column in range(1, self.columnCount())]
        found = {item.text(): value for item in items if (value := item.data(_VALUE)) is not None}
        is_judged = ROWS[row].is_better_small and self._new == set(self._names) and len(found) > 1
        best, worst = (min(found, key=found.__getitem__), max(found, key=found.__getitem__)) if is_judged else ("", "")
        for item in items:
            font = QFont(self.font())
            font.setBold(item.text() == best)
            font.setItalic(item.text() == worst)
            item.setFont(font)
            if font.italic():
                item.setForeground(QColor(*theme_in_force().bad))

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._fit_measures()

    def _fit_measures(self) -> None:
        """Give the names of the measures what the numbers leave; where that is too little, break names and headings."""
        room, columns = self.viewport().width(), range(1, self.columnCount())
        number = self.fontMetrics().horizontalAdvance(_USUAL_NUMBER) + _NUMBER_ROOM
        needed = [max(self.sizeHintForColumn(column), number) for column in columns]
        headings = [self._heading_width(column) for column in columns]
        whole = list(map(max, needed, headings))
        names = self.sizeHintForColumn(0) + SPACE
        is_broken = names + sum(whole) > room
        if is_broken:
            names = min(names, self._longest_word() + _CELL_ROOM)
            whole = needed
        for column, width in zip(columns, whole, strict=True):
            self.setColumnWidth(column, width)
        self.setColumnWidth(0, max(names, room - sum(whole)))
        self._break_lines(is_broken=is_broken)

    def _heading_width(self, column: int) -> int:
        """Return what a whole heading needs, whether it is broken now or not."""
        metrics = QFontMetrics(self.horizontalHeaderItem(column).font())
        return metrics.horizontalAdvance(self._titles[self._names[column - 1]]) + _CELL_ROOM

    def _longest_word(self) -> int:
        words = [word for measure in ROWS for word in measure.label.split()]
        return max(map(self.fontMetrics().horizontalAdvance, words))

    def _break_lines(self, *, is_broken: bool) -> None:
        """Write names and headings in as many lines as they need, or each in one."""
        wrap = Qt.TextFlag.TextWordWrap if is_broken else Qt.TextFlag.TextSingleLine
        for column, name in enumerate(self._names, start=1):
            title = self._titles[name]
            self.horizontalHeaderItem(column).setText(title.replace("-", "-\n") if is_broken else title)
        for row, measure in enumerate(ROWS):
            room = QRect(0, 0, self.columnWidth(0) - _CELL_ROOM, 0)
            height = self.fontMetrics().boundingRect(room, wrap, measure.label).height()
            self.setRowHeight(row, height + _ROW_BEYOND_TEXT)
        self.setWordWrap(is_broken)

    def sizeHint(self) -> QSize:
        down = self.verticalHeader().defaultSectionSize()
        return QSize(super().sizeHint().width(), self.horizontalHeader().sizeHint().height() + down * len(ROWS))

    def _fill(self) -> None:
        for row, measure in enumerate(ROWS):
            for column in range(self.columnCount()):
                item = self.item(row, column)
                item.setToolTip(measure.explanation)
                if column:
                    item.setTextAlignment(RIGHT)
                else:
                    item.setText(measure.label)

    def style_headers(self) -> None:
        self.horizontalHeader().setStyleSheet(
            f"QHeaderView::section {{ border: none; background: palette(button); padding: {SPACE}px {SPACE // 2}px; }}"
        )

    def _arrange_headers(self) -> None:
        self.setHorizontalHeaderLabels(["measure", *(self._titles[name] for name in self._names)])
        self.horizontalHeaderItem(0).setTextAlignment(Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter)
        across, down = self.horizontalHeader(), self.verticalHeader()
        across.setHighlightSections(False)
        self.order.let_sort()
        across.setSectionResizeMode(0, QHeaderView.ResizeMode.Fixed)
        across.setMinimumSectionSize(8)
        for column, name in enumerate(self._names, start=1):
            header = self.horizontalHeaderItem(column)
            header.setTextAlignment(RIGHT)
            header.setToolTip(surface_descriptions()[name])
            across.setSectionResizeMode(column, QHeaderView.ResizeMode.Fixed)
        down.setVisible(False)
        down.setSectionResizeMode(QHeaderView.ResizeMode.Fixed)
        down.setDefaultSectionSize(self.fontMetrics().height() + _ROW_BEYOND_TEXT)
