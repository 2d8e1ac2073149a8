"""The zone that runs the pipeline: formulation, samples, Configure, boxes and T, and the ways out."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import QSignalBlocker, Qt
from PySide6.QtWidgets import QComboBox, QFrame, QHBoxLayout, QLabel, QScrollArea, QVBoxLayout, QWidget

from qovr_app.state.editor_state import EditorState
from qovr_app.state.focus import is_net
from qovr_app.state.intents import Configured, FormulationChosen, Intent, SamplesChosen
from qovr_app.state.looking_intents import MessageOutdated, MessageShown
from qovr_app.state.requests import ExportAsked, FigureAsked
from qovr_app.store import Store
from qovr_app.style.spacing import SPACE
from qovr_app.style.symbols import symbol_html
from qovr_app.widgets.number_table import NumberTable
from qovr_app.widgets.parts import MARGINS, CompactButton, Note, symbol, title_html
from qovr_app.widgets.wheel import guard_from_wheels
from qovr_app.zones.gestures import dispatch_gestures
from qovr_app.zones.net_facts import net_note, structure_of
from qovr_app.zones.samples_field import SamplesField
from qovr_core import FORMULATIONS, Document, Evaluation

_NUMBERS_FIRST = 100
"""How much more of the height that is left goes to boxes and T than under them, until they are as high as they may be.
"""


class SurfaceZone(QFrame):
    """Shows the configured surface's numbers, and dispatches what to do with it."""

    def __init__(self, store: Store, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._store = store
        self._has_reported = False  # then a control shows what it has asked for, which may be undone in the same turn
        self.setObjectName("zone.surface")
        self.setAccessibleName("Surface")
        self._formulation = QComboBox(self)
        guard_from_wheels(self._formulation)
        self._formulation.setObjectName("surface.formulation")
        self._samples = (self._samples_field("u"), self._samples_field("v"))
        self._configure = CompactButton(
            "Configure QOVR Surface", "surface.configure", "Compute raw surface, boxes, T and transformed surface", self
        )
        self._export = CompactButton("Export Data…", "surface.export", "", self)
        self._figure = CompactButton("Save Figure…", "surface.figure", "Write what the view shows as a picture", self)
        self._state = QLabel(self)
        self._state.setObjectName("surface.state")
        self._net = Note("surface.net", self)
        self._boxes = NumberTable(
            "surface.boxes",
            "Bounding boxes of the control points and of the raw surface",
            corner="Box",
            rows=["x", "y", "z"],
            columns=["P min", "P max", "raw min", "raw max"],
            parent=self,
        )
        axes = ["x", "y", "z", "h"]
        self._matrix = NumberTable(
            "surface.matrix", "Transformation matrix T", corner="<i>T</i>", rows=axes, columns=axes, parent=self
        )
        self._fill_formulations()
        for button, intent in (
            (self._configure, Configured()),
            (self._export, ExportAsked()),
            (self._figure, FigureAsked()),
        ):
            button.clicked.connect(lambda _checked, intent=intent: store.dispatch(intent))
        self._arrange()

    def show_state(self, before: EditorState | None, after: EditorState) -> None:
        """Show what the document asks for, and the numbers of the surface configured last."""
        if before is not None and before.file.opening != after.file.opening:
            for field in self._samples:
                field.revert()
        document, structure = after.document, structure_of(after.document)
        is_same = before is not None and structure == structure_of(before.document)
        if before is None or not is_same or document.samples != before.document.samples or self._has_reported:
            self._has_reported = False
            self._show_document(document)
        if not is_same or after.differs(before, "window"):
            self._net.say(net_note(document, after.window) * is_net(after))
        if after.differs(before, "document", "evaluation"):
            self._show_numbers(after.evaluation)
            self._show_stale(after.evaluation, is_stale=after.is_stale)

    def _show_document(self, document: Document) -> None:
        with QSignalBlocker(self._formulation):
            self._formulation.setCurrentIndex(self._formulation.findText(document.formulation.name))
        self._formulation.setToolTip(document.formulation.description)
        for field, count in zip(self._samples, document.samples, strict=True):
            field.show_count(count)

    def focus_first(self) -> None:
        """Bring the keyboard to the first control."""
        self._formulation.setFocus()

    def _show_numbers(self, evaluation: Evaluation | None) -> None:
        if evaluation is None:
            self._boxes.show_numbers(np.full((3, 4), np.nan))
            self._matrix.show_numbers(np.full((4, 4), np.nan))
            return
        self._boxes.show_numbers(np.hstack([evaluation.control_box, evaluation.raw_box]))
        self._matrix.show_numbers(evaluation.matrix)

    def _show_stale(self, evaluation: Evaluation | None, *, is_stale: bool) -> None:
        self._configure.set_due(is_stale)
        self._export.setEnabled(not is_stale)
        self._export.setToolTip(
            "Configure the surface first: what was set since is not in it"
            if is_stale
            else "Write the configured surface as a workbook, table, arrays or mesh"
        )
        for table in (self._boxes, self._matrix):
            table.set_quiet(is_stale)
        flat = ", ".join(evaluation.flat_axes) if evaluation is not None else ""
        if is_stale:
            self._say("older than what is set", "View and numbers are of the surface configured last.")
        elif flat:
            self._say(f"flat along {flat}", f"The raw surface has no extent along {flat}: there T only moves it.")
        else:
            self._say("", "")

    def _say(self, text: str, why: str) -> None:
        if text != self._state.text():
            self._state.setText(text)
            self._state.setToolTip(why)
            self._state.setAccessibleDescription(why)

    def _samples_field(self, parameter: str) -> SamplesField:
        field = SamplesField(parameter, self)
        field.count_edited.connect(lambda _count, gesture: self._on_samples_edited(gesture))
        dispatch_gestures(field, self._store.dispatch)
        field.refused.connect(self._on_refused)
        return field

    def _on_samples_edited(self, gesture: int) -> None:
        along_u, along_v = (field.count for field in self._samples)
        self._dispatch(SamplesChosen((along_u, along_v), gesture))

    def _on_refused(self, reason: str) -> None:
        refusal = MessageShown(f"{reason}.", is_refusal=True)
        self._dispatch(refusal if reason else MessageOutdated(only_refusals=True))

    def _dispatch(self, intent: Intent) -> None:
        """Dispatch a choice; where it is refused, show what is so."""
        self._has_reported = True
        if self._store.dispatch(intent) is not None:
            self._show_document(self._store.state.document)

    def _fill_formulations(self) -> None:
        self._formulation.setAccessibleName("Formulation")
        for name, formulation in FORMULATIONS.items():
            self._formulation.addItem(name)
            tip = Qt.ItemDataRole.ToolTipRole
            self._formulation.setItemData(self._formulation.count() - 1, formulation.description, tip)
        self._formulation.currentTextChanged.connect(lambda name: self._dispatch(FormulationChosen(name)))

    def _arrange(self) -> None:
        choices = QHBoxLayout()
        choices.setSpacing(SPACE)
        choices.addWidget(self._formulation)
        choices.addStretch(1)
        choices.addWidget(symbol("Samples", parent=self))
        choices.addWidget(self._samples[0])
        choices.addWidget(symbol("×", parent=self))
        choices.addWidget(self._samples[1])
        buttons = QHBoxLayout()
        buttons.setSpacing(SPACE)
        buttons.addWidget(self._export)
        buttons.addWidget(self._figure)
        buttons.addStretch(1)
        configure = QHBoxLayout()
        configure.setSpacing(2 * SPACE)
        configure.addWidget(self._configure)
        configure.addWidget(self._state, 1)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(*MARGINS)
        layout.setSpacing(SPACE)
        layout.addWidget(symbol(title_html("Surface", f"{symbol_html('QOVR', '')}(<i>u</i>, <i>v</i>)"), parent=self))
        layout.addLayout(choices)
        layout.addWidget(self._net)
        layout.addLayout(configure)
        layout.addWidget(self._numbers(), _NUMBERS_FIRST)
        layout.addLayout(buttons)
        layout.addStretch(1)

    def _numbers(self) -> QScrollArea:
        """Return boxes and T, which scroll where the window is low."""
        inside = QWidget(self)
        tables = QVBoxLayout(inside)
        tables.setContentsMargins(0, 0, 0, 0)
        tables.setSpacing(SPACE)
        for table in (self._boxes, self._matrix):
            tables.addWidget(table, table.rowCount() + 1)
        area = QScrollArea(self)
        area.setFrameShape(QFrame.Shape.NoFrame)
        area.setWidgetResizable(True)
        area.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        area.setWidget(inside)
        area.setMaximumHeight(tables.maximumSize().height())
        return area
