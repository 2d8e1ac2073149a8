"""The classical surfaces of the same net: in the view over or beside QOVR, and measured in a table."""

from __future__ import annotations

from PySide6.QtGui import QAction, QGuiApplication, QHideEvent, QShowEvent
from PySide6.QtWidgets import QVBoxLayout, QWidget

from qovr_app.laboratory.comparison_bar import ComparisonBar
from qovr_app.laboratory.comparison_table import ComparisonTable
from qovr_app.laboratory.panel import Focus, LaboratoryPanel
from qovr_app.state.display import Placement
from qovr_app.style.spacing import SPACE
from qovr_app.style.symbols import symbol_html
from qovr_app.style.theme import Theme
from qovr_app.view3d.scene.comparison import ComparisonView
from qovr_app.widgets.parts import symbol
from qovr_app.work.job import Job
from qovr_app.work.quiet import QuietJob
from qovr_app.work.worker import Worker
from qovr_core import Document, QovrError
from qovr_core.laboratory.comparison import (
    DEFAULT_POINT,
    Comparison,
    ComparisonInput,
    Measures,
    compare,
    compared_names,
)
from qovr_core.laboratory.comparison_report import copied_text
from qovr_core.laboratory.comparison_surfaces import ComparisonSurface

Seen = tuple[ComparisonSurface, Placement, tuple[int, int], float] | None
"""What the view shows besides QOVR: a surface, where, the weighted point and its weight."""


class ComparisonPanel(LaboratoryPanel):
    """Follows the document and the selected point.

    The worker measures while nothing changes; a change stops that at once, and until there are new measures the old are
    shown pale. The other surface is in the view while the panel is shown.
    """

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._document: Document | None = None
        self._point = DEFAULT_POINT
        self._input: ComparisonInput | None = None
        self._measures: dict[str, Measures] = {}
        self._seen: Seen = None
        self._work = QuietJob(self._begin, self)
        self._bar = ComparisonBar(self)
        self._bar.view_changed.connect(self._show_in_view)
        self._bar.weight_changed.connect(self._on_weight_changed)
        self._bar.copy_requested.connect(self._copy)
        self._bar.refused.connect(lambda reason: self.told.emit(reason, True))
        self._bar.show_point(*self._point)
        self._bar.set_copyable(False)
        self._state = symbol("", quiet=True, parent=self)
        self._state.setObjectName("laboratory.comparison.state")
        self._state.setWordWrap(True)
        self._table = ComparisonTable(self)
        self._arrange()

    @property
    def is_current(self) -> bool:
        """Whether every measure shown is the document's."""
        return len(self._measures) == len(compared_names())

    def use_commands(self, commands: dict[str, QAction]) -> None:
        self._bar.distances.use(commands["colour_by_distance"])

    def use_worker(self, worker: Worker) -> None:
        self._worker = worker

    def show_document(self, document: Document) -> None:
        """Measure again when nothing has changed for a while."""
        if document != self._document:
            self._document = document
            self._restart()

    def show_focus(self, focus: Focus) -> None:
        """Move the point that has come into focus; a knot in focus changes nothing."""
        if isinstance(focus, tuple) and focus != self._point:
            self._point = focus
            self._bar.show_point(*focus)
            self._show_in_view()
            self._restart()

    def show_theme(self, _theme: Theme) -> None:
        self._table.refresh_colours()

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self._show_in_view()
        if self._document is not None and not self.is_current:
            self._work.restart()

    def hideEvent(self, event: QHideEvent) -> None:
        super().hideEvent(event)
        if not event.spontaneous():  # a minimised window comes back as it was
            self._work.stop()
            self._bar.distances.restore()
            self._see(None)

    # In the view

    def _show_in_view(self) -> None:
        placement = self._bar.placement
        if placement is None:
            self._see(None)
        else:
            self._see((self._bar.surface, placement, self._point, self._bar.weight))

    def _see(self, wanted: Seen) -> None:
        """Ask for what the view is to show besides QOVR, if that is something else."""
        if wanted == self._seen:
            return
        self._seen = wanted
        self._table.show_compared(wanted and wanted[0].name)
        self.comparison_requested.emit(wanted and ComparisonView(*wanted))

    # Measuring

    def _on_weight_changed(self) -> None:
        self._show_in_view()
        self._restart()

    def _restart(self) -> None:
        self._measures = {}
        self._table.set_old()
        self._bar.set_copyable(False)
        self._work.restart()

    def _begin(self) -> Job | None:
        self._measures = {}
        try:
            self._input = ComparisonInput(self._document, self._point, self._bar.weight)
        except QovrError as error:
            self._refuse(error)
            return None
        self._state.setText(f"{_motion_html(self._input)} Measuring …")
        values = (self._input.document, self._input.point, self._input.weight)
        return self._worker.run(compare, *values, on_progress=self._on_found, on_failed=self._refuse)

    def _on_found(self, name: str, measures: Measures) -> None:
        self._measures[name] = measures
        self._table.show_measures(name, measures, self._input.document.net_size)
        if self.is_current:
            self._state.setText(f"{_motion_html(self._input)} Lengths are in the net's units.")
            self._bar.set_copyable(True)

    def _refuse(self, error: QovrError) -> None:
        self._table.clear_measures()
        self._state.setText(f"Nothing to measure: {error}.")

    def _copy(self) -> None:
        QGuiApplication.clipboard().setText(copied_text(Comparison(self._input, self._measures)))
        self.told.emit("Copied the comparison", False)

    def _arrange(self) -> None:
        layout = QVBoxLayout(self)
        layout.setContentsMargins(2 * SPACE, SPACE, 2 * SPACE, SPACE)
        layout.setSpacing(SPACE)
        layout.addWidget(self._bar)
        layout.addWidget(self._state)
        layout.addWidget(self._table, 1)


def _motion_html(of: ComparisonInput) -> str:
    point = symbol_html("P", "{},{}".format(*of.point))
    return f"{point} moves by {of.step:.4g} along <i>z</i>, a tenth of the net's size."
