"""The classical surfaces of the same net: in the view over or beside QOVR, and measured in a table."""

from __future__ import annotations

import html
from functools import partial

from PySide6.QtWidgets import QVBoxLayout, QWidget

from qovr_app.laboratory.comparison_bar import ComparisonBar
from qovr_app.laboratory.comparison_table import ComparisonTable
from qovr_app.laboratory.panel import WorkingPanel
from qovr_app.state.editor_state import EditorState
from qovr_app.state.focus import focused_document, measured_in_window, point_in_window
from qovr_app.store import Store
from qovr_app.style.spacing import SPACE
from qovr_app.style.symbols import symbol_html
from qovr_app.widgets.clipboard import copy_table
from qovr_app.widgets.parts import named, symbol
from qovr_app.work.job import Job
from qovr_app.work.worker import Worker
from qovr_core import Document, QovrError
from qovr_core.document import NetIndex, Window
from qovr_core.laboratory.comparison import Comparison, ComparisonInput, Measures, compare, compared_names
from qovr_core.laboratory.comparison_report import copied_rows


class ComparisonPanel(WorkingPanel):
    """Follows the window in focus and the selected point.

    The worker measures while nothing changes; a change stops that at once, and until there are new measures the old are
    shown pale. The other surface is in the view while the panel is shown.
    """

    def __init__(self, store: Store, worker: Worker, parent: QWidget | None = None) -> None:
        super().__init__(store, worker, self._begin, self._is_behind, parent)
        self._wanted: tuple[Document, NetIndex, float] | None = None
        self._window: Window = (0, 0)
        self._measures: dict[str, Measures] = {}
        self._bar = ComparisonBar(store.dispatch, self)
        self._bar.copy_requested.connect(self._copy)
        self._bar.refused.connect(self.refuse)
        self._bar.set_copyable(False)
        self._state = named(symbol("", quiet=True, parent=self), "laboratory.comparison.state")
        self._state.setWordWrap(True)
        self._table = ComparisonTable(self)
        self._arrange()

    @property
    def is_current(self) -> bool:
        """Whether every measure shown is the document's."""
        return len(self._measures) == len(compared_names())

    def _is_behind(self) -> bool:
        return self._wanted is not None and not self.is_current

    def show_state(self, before: EditorState | None, after: EditorState) -> None:
        if before is None or before.display.theme != after.display.theme:
            self._table.refresh_colours()
        self._bar.show_state(after)
        self._table.show_compared(after.shown_comparison.surface if after.shown_comparison else None)
        document = focused_document(after)
        if document is None:
            return
        wanted = (document, measured_in_window(after), after.comparison.weight)
        if wanted != self._wanted or after.window != self._window:
            self._wanted, self._window = wanted, after.window
            self._restart()

    def _restart(self) -> None:
        self._measures = {}
        self._table.set_old()
        self._bar.set_copyable(False)
        self.work.restart()

    def _begin(self) -> Job | None:
        self._measures = {}
        self.offer_again(is_offered=False)
        if self._wanted is None:
            return None
        try:
            compared = ComparisonInput(*self._wanted)
        except QovrError as error:
            self._refuse(error)
            return None
        self._state.setText(f"{self._motion_html(compared)} Measuring …")
        on_found = partial(self._on_found, compared)
        return self.worker.run(compare, *self._wanted, on_progress=on_found, on_failed=self._on_failed)

    def _on_found(self, compared: ComparisonInput, name: str, measures: Measures) -> None:
        self._measures[name] = measures
        self._table.show_measures(name, measures, compared.document.net_size)
        if self.is_current:
            moved = self._motion_html(compared)
            self._state.setText(f"{moved} Lengths are in the net's units. <b>Bold</b>: best; <i>italic</i>: worst.")
            self._bar.set_copyable(True)

    def _on_failed(self, error: QovrError) -> None:
        self._refuse(error)
        self.offer_again(is_offered=True)

    def _refuse(self, error: QovrError) -> None:
        self._table.clear_measures()
        self._state.setText(html.escape(f"Nothing to measure: {error}."))

    def _copy(self) -> None:
        if self._wanted is not None:
            comparison = Comparison(ComparisonInput(*self._wanted), self._measures)
            copy_table(copied_rows(comparison))
            self.tell("Copied the comparison")

    def _arrange(self) -> None:
        layout = QVBoxLayout(self)
        layout.setContentsMargins(SPACE, SPACE, SPACE, SPACE)
        layout.setSpacing(SPACE)
        layout.addWidget(self._bar)
        layout.addLayout(self.with_again(self._state, "laboratory.comparison"))
        layout.addWidget(self._table, 1)

    def _motion_html(self, of: ComparisonInput) -> str:
        i, j = point_in_window(of.point, self._window)
        return f"{symbol_html('P', f'{i},{j}')} moves by {of.step:.4g} along <i>z</i>, a tenth of the net's size."
