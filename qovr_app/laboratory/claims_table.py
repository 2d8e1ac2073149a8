"""The table of claims: one row each, one column for every formulation, and in a cell the verdict and how it is here."""

from __future__ import annotations

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QFont, QFontMetrics, QKeyEvent, QResizeEvent
from PySide6.QtWidgets import QAbstractItemView, QHeaderView, QWidget

from qovr_app.laboratory.claims_cells import BLOCKS, IS_OLD, BlockDelegate, Style
from qovr_app.style.spacing import SPACE
from qovr_app.widgets.quiet_table import QuietTable
from qovr_core import FORMULATIONS, Formulation
from qovr_core.laboratory.claims import CLAIMS, Claim
from qovr_core.laboratory.claims_report import standing
from qovr_core.laboratory.verify import Finding, Ground, Verdict
from qovr_core.number_texts import short_text

_MARKS = {Verdict.TRUE: "✓", Verdict.TRUE_IF: "◐", Verdict.FALSE: "✗"}
_UNDECIDED = "○"
"""Read without colour: a tick, a half, a cross, and a ring for what is only not refuted."""

_FINDING = Qt.ItemDataRole.UserRole + 2

_SHARE = 5
"""A column of verdicts takes this part of the table's width, the statements the rest."""

_WIDEST_VERDICT, _LEAST_STATEMENT = 220, 110
_WRITTEN = (Ground.PROVED, Ground.DOCUMENT)
"""Grounds that stand in a cell; a counterexample can be opened, and trials are in the verdict's words."""

_STYLES = {Verdict.TRUE: Style.TRUE, Verdict.TRUE_IF: Style.TRUE_IF, Verdict.FALSE: Style.FALSE}
_SORTED = {Verdict.FALSE: 0.0, Verdict.TRUE_IF: 1.0, Verdict.TRUE: 2.0}
_DOUBT = 0.5
"""False claims first: they are what one looks for. What is only not refuted comes before what is proved."""


def marked_verdict(finding: Finding) -> str:
    """Return a verdict in words, with its mark."""
    return f"{_UNDECIDED if finding.ground is Ground.TRIALS else _MARKS[finding.verdict]} {finding.words}"


def statement(claim: Claim) -> str:
    """Return what the paper says, as a sentence."""
    return f"{claim.text[0].upper()}{claim.text[1:]}."


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
        self.setItemDelegate(BlockDelegate(self))
        self.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)
        self.setVerticalScrollMode(QAbstractItemView.ScrollMode.ScrollPerPixel)
        self.setHorizontalScrollMode(QAbstractItemView.ScrollMode.ScrollPerPixel)
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
        verdict, here = _verdict_text(finding), _here_text(finding)
        condition = [(finding.condition, Style.SMALL)] if finding.condition else []
        ground = [(str(finding.ground), Style.SMALL)] if finding.ground in _WRITTEN else []
        word = marked_verdict(finding), _STYLES[finding.verdict]
        item.setData(BLOCKS, [word, *condition, *ground, (here, Style.QUIET)])
        item.setData(IS_OLD, False)
        item.setData(_FINDING, finding)
        spoken = f"{finding.claim.name}, {finding.formulation}: {verdict}; {here}"
        item.setData(Qt.ItemDataRole.AccessibleTextRole, spoken)
        self.fit_rows()
        self.order.refresh()
        if finding is self.current_finding():
            self.finding_changed.emit(finding)

    def set_old(self) -> None:
        """Mark everything shown as found for the document before."""
        for row in range(len(CLAIMS)):
            for column in range(1, self.columnCount()):
                item = self.item(row, column)
                item.setData(IS_OLD, item.data(_FINDING) is not None)

    def current_finding(self) -> Finding | None:
        """Return the finding of the current cell; a claim's own cell stands for the document's formulation."""
        column = self.currentColumn() or 1 + self._formulations.index(self._of_document)
        finding = self.item(self.currentRow(), column).data(_FINDING)
        return finding if isinstance(finding, Finding) else None

    def copied_cell(self, row: int, column: int) -> str:
        if not column:
            claim = self._claims[row]
            return f"{statement(claim)} ({claim.name}: {claim.where})"
        finding = self.item(row, column).data(_FINDING)
        if not isinstance(finding, Finding):
            return ""
        return f"{_verdict_text(finding)}; {_here_text(finding)}"

    def sort_key(self, row: int, column: int) -> float | str | None:
        if not column:
            return self._claims[row].text
        finding = self.item(row, column).data(_FINDING)
        if not isinstance(finding, Finding):
            return None
        return _SORTED[finding.verdict] - _DOUBT * (finding.ground is Ground.TRIALS)

    def fit_rows(self) -> None:
        """Give every row the height that its texts need."""
        self.resizeRowsToContents()

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        room, verdicts = self.viewport().width(), range(1, self.columnCount())
        for column in verdicts:
            metrics = QFontMetrics(self.horizontalHeaderItem(column).font())
            heading = metrics.horizontalAdvance(self.horizontalHeaderItem(column).text()) + 3 * SPACE + 1
            self.setColumnWidth(column, min(max(room // _SHARE, heading), _WIDEST_VERDICT))
        self.setColumnWidth(0, max(room - sum(map(self.columnWidth, verdicts)), _LEAST_STATEMENT))
        self.fit_rows()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter):
            self.opening_requested.emit()
            return
        super().keyPressEvent(event)

    def style_headers(self) -> None:
        padding = f"{SPACE}px 0 {SPACE}px {2 * SPACE}px"
        self.horizontalHeader().setStyleSheet(
            f"QHeaderView::section {{ border: none; background: palette(button); padding: {padding}; }}"
        )

    def _arrange_headers(self) -> None:
        self.setHorizontalHeaderLabels(["claim", *map(str, self._formulations)])
        across, down = self.horizontalHeader(), self.verticalHeader()
        across.setHighlightSections(False)
        across.setDefaultAlignment(Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter)
        across.setSectionResizeMode(QHeaderView.ResizeMode.Fixed)
        down.setVisible(False)
        self.order.let_sort()

    def _fill_row(self, row: int, claim: Claim) -> None:
        name = self.item(row, 0)
        name.setData(BLOCKS, [(statement(claim), Style.PLAIN), (f"{claim.name}: {claim.where}", Style.QUIET)])
        name.setData(Qt.ItemDataRole.AccessibleTextRole, f"{claim.name}: {claim.text}, {claim.where}")
        name.setToolTip(f"{claim.text}\n{claim.where}")


def _verdict_text(finding: Finding) -> str:
    verdict = f"{finding.words} {finding.condition}".strip()
    return verdict if finding.ground is Ground.TRIALS else f"{verdict}, {finding.ground}"


def _here_text(finding: Finding) -> str:
    return f"here: {standing(finding.verdict, finding.here).words}, {short_text(finding.here.value)}"
