"""The paper's claims and the verdicts on them, current for the document, found beside the work."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from PySide6.QtCore import Qt
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QProgressBar, QTextBrowser, QVBoxLayout, QWidget

from qovr_app.laboratory.claims_details import details_html
from qovr_app.laboratory.claims_table import ClaimsTable
from qovr_app.laboratory.panel import WorkingPanel
from qovr_app.state.editor_state import EditorState
from qovr_app.state.looking_intents import Selected, WindowFocused
from qovr_app.state.requests import DocumentAsked
from qovr_app.store import Store
from qovr_app.style.spacing import SPACE
from qovr_app.widgets.parts import CompactButton, named
from qovr_app.widgets.plain import plain_label, plain_tip
from qovr_app.widgets.splitter import LineSplitter
from qovr_app.work.job import Job
from qovr_app.work.worker import Worker
from qovr_core import FORMULATIONS, Document, QovrError
from qovr_core.document import Window
from qovr_core.laboratory.claims import CLAIMS
from qovr_core.laboratory.trials import SAMPLES
from qovr_core.laboratory.verify import Finding, Ground, verify

_WIDE = 900
"""From this width on what is behind a verdict stands beside the table, else below it: statements are never cut."""

_SHARES = (300, 90)

_NO_COUNTEREXAMPLE = {
    Ground.PROVED: "the claim is proved",
    Ground.TRIALS: "the claim holds on everything that was tried",
    Ground.DOCUMENT: "the claim holds on this document",
}
"""By how a claim that is not false is known."""

Shown = Callable[[Finding], Document | None]
"""Which document of a finding a button opens."""


class ClaimsPanel(WorkingPanel):
    """A table of verdicts, what is behind the current one, and the documents that show it.

    The worker decides while nothing changes. A change of the document stops that at once; until there are new verdicts
    the old ones are shown as old.
    """

    def __init__(self, store: Store, worker: Worker, parent: QWidget | None = None) -> None:
        super().__init__(store, worker, self._begin, self._is_behind, parent)
        self._document: Document | None = None
        self._window: Window = (0, 0)
        self._all = len(CLAIMS) * len(FORMULATIONS)
        self._found = 0
        self._row: list[Finding] = []
        self._table = ClaimsTable(self)
        self._table.finding_changed.connect(self._show_finding)
        self._table.opening_requested.connect(self._open_first)
        self._details = named(QTextBrowser(self), "laboratory.claims.details", "What is behind the verdict")
        self._details.setFrameShape(QTextBrowser.Shape.NoFrame)
        self._details.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self._counterexample = self._button(
            "counterexample", "Open a document on which the claim fails", lambda finding: finding.counterexample
        )
        self._example = self._button(
            "example", "Open a document that shows what was found", lambda finding: finding.example
        )
        self._place = CompactButton(
            "Show place", "laboratory.claims.place", "Select the control point nearest to the joint's worst place", self
        )
        self._place.clicked.connect(lambda _checked: self._show_place())
        self._place.setVisible(False)
        self._state = named(plain_label("", self), "laboratory.claims.state")
        self._progress = named(QProgressBar(self), "laboratory.claims.progress", "Verdicts found")
        self._progress.setRange(0, self._all)
        self._splitter = LineSplitter("laboratory.claims.splitter", Qt.Orientation.Horizontal, self)
        self._arrange()

    @property
    def is_current(self) -> bool:
        """Whether every verdict shown is the document's."""
        return self._found == self._all

    def _is_behind(self) -> bool:
        return self._document is not None and not self.is_current

    def show_state(self, before: EditorState | None, after: EditorState) -> None:
        if before is None or before.display.theme != after.display.theme:
            self._table.viewport().update()
        document = after.shown_document
        if document is not None and after.differs(before, "shown_document", "window"):
            self._table.show_formulation(document.formulation)
            self._look_again(document, after.window)

    def _look_again(self, document: Document, window: Window) -> None:
        """Look again, unless only formulation or samples have changed: all formulations are shown anyway."""
        samples = max(SAMPLES[0], document.windows[1] + 1), max(SAMPLES[1], document.windows[0] + 1)
        document = replace(document, formulation=next(iter(FORMULATIONS.values())), samples=samples)
        if (document, window) == (self._document, self._window):
            return
        changed = "window in focus" if document == self._document else "document"
        self._document, self._window, self._found = document, window, 0
        self.offer_again(is_offered=False)
        self._table.set_old()
        self._show_progress(f"The {changed} has changed: verdicts in grey are of the one before.")
        self.work.restart()

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        is_wide = self.width() >= _WIDE
        shape = Qt.Orientation.Horizontal if is_wide else Qt.Orientation.Vertical
        if shape is not self._splitter.orientation():
            self._splitter.setOrientation(shape)
            self._splitter.setSizes(_SHARES)

    # Looking for verdicts

    def _begin(self) -> Job:
        self._found, self._row = 0, []
        self.offer_again(is_offered=False)
        return self.worker.run(
            verify,
            self._document,
            self._window,
            on_progress=self._on_found,
            on_failed=self._on_failed,
        )

    def _on_failed(self, error: QovrError) -> None:
        self._show_progress(f"No verdicts: {error}.")
        self.offer_again(is_offered=True)

    def _on_found(self, finding: Finding) -> None:
        self._found += 1
        self._row.append(finding)
        if len(self._row) == len(FORMULATIONS):  # whole rows: each repaint makes the window put itself together anew
            self._show_row()

    def _show_row(self) -> None:
        for finding in self._row:
            self._table.show_finding(finding)
        self._row = []
        self._show_progress(f"Deciding: {self._found} of {self._all}")
        if self.is_current:
            self._show_progress(f"Every claim is decided{self._about_net()}")

    def _about_net(self) -> str:
        """Return where the claims were measured, on a net of several windows."""
        if self._document is None or self._document.is_one_window:
            return ""
        return ": about neighbours at every joint, others on window ({}, {})".format(*self._window)

    def _show_progress(self, text: str) -> None:
        self._state.setText(text)
        self._state.setToolTip(plain_tip(text))
        self._progress.setValue(self._found)
        self._progress.setVisible(not self.is_current)

    # What is behind a verdict

    def _show_finding(self, finding: Finding | None) -> None:
        self._details.setHtml("" if finding is None else details_html(finding))
        self._counterexample.setVisible(finding is not None and finding.counterexample is not None)
        self._example.setVisible(finding is not None and finding.example is not None)
        self._place.setVisible(finding is not None and finding.here.place is not None)

    def _open_first(self) -> None:
        """Open what the current verdict offers: a counterexample before an example."""
        for button in (self._counterexample, self._example):
            if not button.isHidden():
                button.click()
                return
        finding = self._table.current_finding()
        if finding is not None:
            self.tell(f"There is no counterexample: {_NO_COUNTEREXAMPLE[finding.ground]}.")

    def _open(self, kind: str, shown_by: Shown) -> None:
        finding = self._table.current_finding()
        if finding is not None and (document := shown_by(finding)) is not None:
            title = f"{kind.capitalize()} to {finding.claim.name}, {finding.formulation}"
            self.store.dispatch(DocumentAsked(document, title))

    def _show_place(self) -> None:
        """Bring the joint at which the difference is largest into focus."""
        finding = self._table.current_finding()
        if finding is not None and (place := finding.here.place) is not None:
            self.store.dispatch(WindowFocused(place.window))
            self.store.dispatch(Selected(place.nearest_point))

    def _button(self, kind: str, tip: str, shown_by: Shown) -> CompactButton:
        button = CompactButton(f"Open {kind}", f"laboratory.claims.{kind}", tip, self)
        button.clicked.connect(lambda _checked: self._open(kind, shown_by))
        button.setVisible(False)
        return button

    def _arrange(self) -> None:
        splitter = self._splitter
        splitter.setChildrenCollapsible(False)
        splitter.addWidget(self._table)
        splitter.addWidget(self._details)
        splitter.setStretchFactor(0, 3)
        splitter.setStretchFactor(1, 2)
        self._progress.setTextVisible(False)
        self._progress.setFixedHeight(SPACE)
        policy = self._progress.sizePolicy()
        policy.setRetainSizeWhenHidden(True)
        self._progress.setSizePolicy(policy)
        self._state.setContentsMargins(2 * SPACE, 0, 2 * SPACE, 0)
        self._state.setWordWrap(True)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, SPACE)
        layout.setSpacing(SPACE)
        layout.addWidget(splitter, 1)
        layout.addWidget(self._progress)
        below = self.with_again(self._state, "laboratory.claims")
        below.setContentsMargins(0, 0, 2 * SPACE, 0)
        below.addWidget(self._place)
        below.addWidget(self._counterexample)
        below.addWidget(self._example)
        layout.addLayout(below)
