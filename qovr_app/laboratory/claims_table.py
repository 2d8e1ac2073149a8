"""The table of claims: one row each, one column for every formulation, two lines a cell."""

from __future__ import annotations

from PySide6.QtCore import QModelIndex, QPersistentModelIndex, QRect, QSize, Qt, Signal
from PySide6.QtGui import QColor, QFont, QKeyEvent, QPainter
from PySide6.QtWidgets import (
    QAbstractItemView,
    QHeaderView,
    QStyle,
    QStyledItemDelegate,
    QStyleOptionViewItem,
    QTableWidget,
    QWidget,
)

from qovr_app.style.fonts import small_number_font
from qovr_app.style.palette import theme_in_force
from qovr_app.style.spacing import SPACE
from qovr_app.widgets.clipboard import Rows
from qovr_app.widgets.quiet_table import QuietTable
from qovr_core import FORMULATIONS, Formulation
from qovr_core.laboratory.claims import CLAIMS, Claim
from qovr_core.laboratory.verify import Finding, Verdict
from qovr_core.number_texts import short_text

MARKS = {Verdict.TRUE: "✓", Verdict.TRUE_IF: "◐", Verdict.FALSE: "✗"}
"""Read without colour: a tick, a half, a cross."""

_FIRST, _SECOND, _IS_OLD, _FINDING = (Qt.ItemDataRole.UserRole + k for k in range(4))
_LINES = 2
_COLUMN_WIDTH = 112
_OLD_OPACITY = 0.4


class ClaimsTable(QuietTable):
    """Shows findings as they come.

    Signals
    -------
    finding_changed : the Finding of the current cell, None where there is none yet
    opening_requested : Enter or a double click on a cell
    """

    finding_changed = Signal(object)
    opening_requested = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        shape, spoken = (len(CLAIMS), 1 + len(FORMULATIONS)), "The paper's claims and the verdict for every formulation"
        super().__init__(shape, "laboratory.claims.table", spoken, parent)
        self._claims, self._formulations = list(CLAIMS.values()), list(FORMULATIONS.values())
        self._of_document = self._formulations[0]
        self.setItemDelegate(_TwoLines(self))
        self.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)
        self.setVerticalScrollMode(QAbstractItemView.ScrollMode.ScrollPerPixel)
        self.setHorizontalScrollMode(QAbstractItemView.ScrollMode.ScrollPerPixel)
        self.setWordWrap(False)
        self._arrange_headers()
        for row, claim in enumerate(CLAIMS.values()):
            self._fill_row(row, claim)
        self.setCurrentCell(0, 1)
        self.currentItemChanged.connect(lambda _now, _before: self.finding_changed.emit(self.current_finding()))
        self.itemDoubleClicked.connect(lambda _item: self.opening_requested.emit())

    def show_formulation(self, formulation: Formulation) -> None:
        """Set the document's own formulation apart."""
        self._of_document = formulation
        for column, shown in enumerate(self._formulations, start=1):
            font = QFont(self.font())
            font.setBold(shown == formulation)
            self.horizontalHeaderItem(column).setFont(font)
            is_own = " (the document's)" if shown == formulation else ""
            self.horizontalHeaderItem(column).setToolTip(f"Formulation {shown}{is_own}")

    def show_finding(self, finding: Finding) -> None:
        """Show a finding in its cell."""
        item = self.item(self._claims.index(finding.claim), 1 + self._formulations.index(finding.formulation))
        here = "holds" if finding.here.holds else "fails"
        item.setData(_FIRST, f"{MARKS[finding.verdict]} {finding.verdict}")
        item.setData(_SECOND, f"here {here} {short_text(finding.here.value)}")
        item.setData(_IS_OLD, False)
        item.setData(_FINDING, finding)
        spoken = f"{finding.claim.name}, {finding.formulation}: {finding.verdict}"
        spoken += f" {finding.condition}" if finding.condition else ""
        item.setData(Qt.ItemDataRole.AccessibleTextRole, f"{spoken}; on this document it {here}")
        if finding is self.current_finding():
            self.finding_changed.emit(finding)

    def set_old(self) -> None:
        """Mark everything shown as found for the document before."""
        for row in range(len(CLAIMS)):
            for column in range(1, self.columnCount()):
                item = self.item(row, column)
                item.setData(_IS_OLD, item.data(_FINDING) is not None)

    def current_finding(self) -> Finding | None:
        """Return the finding of the current cell; a claim's own cell stands for the document's formulation."""
        column = self.currentColumn() or 1 + self._formulations.index(self._of_document)
        finding = self.item(self.currentRow(), column).data(_FINDING)
        return finding if isinstance(finding, Finding) else None

    def rows_to_copy(self) -> Rows:
        """Return all claims and what was found, under the names of the formulations."""
        cells = [[self.item(row, column) for column in range(self.columnCount())] for row in range(self.rowCount())]
        return [
            ["claim", *map(str, self._formulations)],
            *(["; ".join(filter(None, map(item.data, (_FIRST, _SECOND)))) for item in row] for row in cells),
        ]

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter):
            self.opening_requested.emit()
            return
        super().keyPressEvent(event)

    def style_headers(self) -> None:
        self.horizontalHeader().setStyleSheet(
            f"QHeaderView::section {{ border: none; background: palette(button); padding: {SPACE}px {2 * SPACE}px; }}"
        )

    def _arrange_headers(self) -> None:
        self.setHorizontalHeaderLabels(["claim", *map(str, self._formulations)])
        across, down = self.horizontalHeader(), self.verticalHeader()
        across.setHighlightSections(False)
        across.setSectionsClickable(False)
        across.setDefaultAlignment(Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter)
        across.setSectionResizeMode(0, QHeaderView.ResizeMode.Stretch)
        for column in range(1, self.columnCount()):
            across.setSectionResizeMode(column, QHeaderView.ResizeMode.Fixed)
            across.resizeSection(column, _COLUMN_WIDTH)
        down.setVisible(False)
        down.setSectionResizeMode(QHeaderView.ResizeMode.Fixed)
        down.setDefaultSectionSize(self.itemDelegate().sizeHint(QStyleOptionViewItem(), QModelIndex()).height())

    def _fill_row(self, row: int, claim: Claim) -> None:
        name = self.item(row, 0)
        name.setData(_FIRST, claim.name)
        name.setData(_SECOND, claim.text)
        name.setData(Qt.ItemDataRole.AccessibleTextRole, f"{claim.name}: {claim.text}, {claim.where}")
        name.setToolTip(f"{claim.text}\n{claim.where}")


class _TwoLines(QStyledItemDelegate):
    """Paints a verdict over the number below it, and a claim over its text."""

    def __init__(self, table: QTableWidget) -> None:
        super().__init__(table)
        self._height = _LINES * table.fontMetrics().height() + 2 * SPACE
        self._strong = QFont(table.font())
        self._strong.setBold(True)
        self._small = small_number_font(table.font())

    def sizeHint(self, _option: QStyleOptionViewItem, _index: QModelIndex | QPersistentModelIndex) -> QSize:
        return QSize(_COLUMN_WIDTH, self._height)

    def paint(
        self, painter: QPainter, option: QStyleOptionViewItem, index: QModelIndex | QPersistentModelIndex
    ) -> None:
        painter.save()
        if option.state & QStyle.StateFlag.State_Selected:
            painter.fillRect(option.rect, QColor(*theme_in_force().accent_cell))
            if option.widget.hasFocus():
                painter.setPen(QColor(*theme_in_force().accent))
                painter.drawRect(option.rect.adjusted(0, 0, -1, -1))
        area = option.rect.adjusted(2 * SPACE, SPACE, -SPACE, -SPACE)
        half = area.height() // _LINES
        if index.data(_IS_OLD):
            painter.setOpacity(_OLD_OPACITY)
        finding = index.data(_FINDING)
        ink = QColor(*theme_in_force().ink) if finding is None else _ink(finding.verdict)
        self._write(painter, QRect(area.topLeft(), QSize(area.width(), half)), self._strong, ink, index.data(_FIRST))
        below = QRect(area.left(), area.top() + half, area.width(), area.height() - half)
        self._write(painter, below, self._small, QColor(*theme_in_force().idle_ink), index.data(_SECOND))
        painter.restore()

    @staticmethod
    def _write(painter: QPainter, area: QRect, font: QFont, ink: QColor, text: str | None) -> None:
        painter.setFont(font)
        painter.setPen(ink)
        elided = painter.fontMetrics().elidedText(text or "", Qt.TextElideMode.ElideRight, area.width())
        painter.drawText(area, Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter, elided)


def _ink(verdict: Verdict) -> QColor:
    theme = theme_in_force()
    return QColor(*{Verdict.TRUE: theme.ink, Verdict.TRUE_IF: theme.warn, Verdict.FALSE: theme.bad}[verdict])
