"""The formats to choose from, by name and suffix."""

from __future__ import annotations

from PySide6.QtCore import QSize, Qt
from PySide6.QtWidgets import QTreeWidget, QTreeWidgetItem, QWidget

from qovr_core.files import FORMATS, Format

_ROW_BEYOND_TEXT = 10
_COLUMN_GAP = 16
_FEWEST_ROWS = 4
_LEAST_SUFFIX_WIDTH = 64
_LONGEST_SUFFIX = ".qovr"


class FormatList(QTreeWidget):
    """One line for every format; one of them is chosen."""

    def __init__(self, name: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName(name)
        self.setAccessibleName("Format")
        self.setHeaderHidden(True)
        self.setColumnCount(2)
        self.setRootIsDecorated(False)
        self.setAllColumnsShowFocus(True)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self._suffixes = tuple(FORMATS)
        row_height = self.fontMetrics().height() + _ROW_BEYOND_TEXT
        for entry in FORMATS.values():
            item = QTreeWidgetItem([entry.name, entry.suffix])
            item.setSizeHint(1, QSize(0, row_height))
            self.addTopLevelItem(item)
        self.resizeColumnToContents(0)
        self.setColumnWidth(0, self.columnWidth(0) + _COLUMN_GAP)
        suffix_width = (
            self.fontMetrics().horizontalAdvance(_LONGEST_SUFFIX) + self.verticalScrollBar().sizeHint().width()
        )
        self.setFixedWidth(self.columnWidth(0) + max(_LEAST_SUFFIX_WIDTH, suffix_width + _COLUMN_GAP))
        self._rows_height = len(FORMATS) * row_height + 2 * self.frameWidth()
        self.setMinimumHeight(min(self._rows_height, _FEWEST_ROWS * row_height))

    def sizeHint(self) -> QSize:
        """Return the size of all formats; where the screen is low, they scroll."""
        return QSize(super().sizeHint().width(), self._rows_height)

    @property
    def entry(self) -> Format:
        """The chosen format."""
        return FORMATS[self._suffixes[self.currentIndex().row()]]

    def choose(self, suffix: str) -> None:
        """Choose the format of a suffix."""
        self.setCurrentIndex(self.model().index(self._suffixes.index(suffix), 0))
