"""One curve of the surface with all its parts: the paper's Figure 1, live."""

from __future__ import annotations

from PySide6.QtWidgets import QVBoxLayout, QWidget

from qovr_app.laboratory.curve_bar import CurveBar
from qovr_app.laboratory.curve_drawings import CurveDrawing
from qovr_app.laboratory.curve_plots import CurvePlots
from qovr_app.laboratory.panel import LaboratoryPanel
from qovr_app.state.editor_state import EditorState
from qovr_app.state.focus import focus_in_window, focused_document
from qovr_app.state.looking_intents import DisplayChosen
from qovr_app.state.requests import DrawingAsked
from qovr_app.store import Store
from qovr_app.style.theme import theme_of
from qovr_app.work.worker import Worker
from qovr_core import QovrError
from qovr_core.laboratory.one_curve import OneCurve, curve_of


class CurvePanel(LaboratoryPanel):
    """Shows one of the ten curves of the window in focus: that of the knot in focus, or a chosen one."""

    def __init__(self, store: Store, worker: Worker, parent: QWidget | None = None) -> None:
        super().__init__(store, worker, parent)
        self._bar = CurveBar(self)
        self._plots = CurvePlots(store, self)
        self._bar.choice_changed.connect(lambda: self._show_curve(self.store.shown))
        self._bar.comb.toggled.connect(lambda _is_wanted: self._show_comb(self.store.shown))
        self._bar.comb.scaled.connect(lambda scale: store.dispatch(DisplayChosen("comb_scale", scale)))
        self._bar.scales_linked.connect(self._plots.set_equal_scales)
        self._bar.figure_requested.connect(self._save_figure)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(0)
        layout.addWidget(self._bar)
        layout.addWidget(self._plots, 1)

    @property
    def curve(self) -> OneCurve | None:
        """The curve that is shown."""
        return self._plots.curve

    def show_state(self, before: EditorState | None, after: EditorState) -> None:
        if before is None or before.display.theme != after.display.theme:
            self._plots.show_theme(theme_of(after.display.theme))
        if before is None or before.display.comb_scale != after.display.comb_scale:
            self._show_comb(after)
        if before is None or before.focus != after.focus:
            self._bar.follow(focus_in_window(after))
        if after.differs(before, "shown_document", "window"):
            self._show_curve(after)

    def _show_comb(self, state: EditorState) -> None:
        self._bar.comb.show_scale(state.display.comb_scale)
        self._plots.show_comb(state.display.comb_scale if self._bar.comb.is_wanted else None)

    def _show_curve(self, state: EditorState) -> None:
        document = focused_document(state)
        if document is None:
            return
        try:
            curve = curve_of(document, *self._bar.curve)
        except QovrError as error:
            self.tell(f"{error}.", is_refusal=True)
            return
        self._plots.show_curve(curve, document.formulation, self._bar.view)

    def _save_figure(self) -> None:
        document = focused_document(self.store.shown)
        if (curve := self.curve) is not None and document is not None:
            bar = self._bar
            drawing = CurveDrawing(bar.drawing, curve, document, bar.view, bar.has_equal_scales)
            self.store.dispatch(DrawingAsked(drawing.name, drawing.write))
