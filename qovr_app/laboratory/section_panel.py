"""Where a plane cuts the surface: the curve in its plane, with lengths, and its points for other programs."""

from __future__ import annotations

import numpy as np
from PySide6.QtWidgets import QVBoxLayout, QWidget

from qovr_app.laboratory.panel import LaboratoryPanel
from qovr_app.laboratory.section_bar import SectionBar, pair_of
from qovr_app.laboratory.section_plot import SectionPlot
from qovr_app.laboratory.wording import value_text
from qovr_app.state.display import LayerChoice, SectionChoice
from qovr_app.state.editor_state import EditorState
from qovr_app.state.looking_intents import DisplayChosen
from qovr_app.state.sections import plane_of_choice
from qovr_app.store import Store
from qovr_app.style.spacing import SPACE
from qovr_app.style.theme import theme_of
from qovr_app.widgets.clipboard import Rows, copy_table
from qovr_app.widgets.parts import words
from qovr_app.work.worker import Worker
from qovr_core.arrays import Array
from qovr_core.geometry.section import CuttingPlane, SectionCurve, section
from qovr_core.layer import Layer

_NAME = "laboratory.section"
_LEAST_PLOT = 200
_SAMPLES = 65
"""Places each way from which it is told between where the plane meets the surface."""


class SectionPanel(LaboratoryPanel):
    """Follows the document, the layer that is shown, and the plane."""

    def __init__(self, store: Store, worker: Worker, parent: QWidget | None = None) -> None:
        super().__init__(store, worker, parent)
        self._plane: CuttingPlane | None = None
        self.pieces: tuple[SectionCurve, ...] = ()
        self._bar = SectionBar(self)
        self._plot = SectionPlot(f"{_NAME}.plot", self)
        self._plot.setMinimumHeight(_LEAST_PLOT)
        self._words = words(f"{_NAME}.words", self)
        self._bar.chosen.connect(self._choose)
        self._bar.two_points_wanted.connect(self._choose_points)
        self._bar.scales_linked.connect(self._plot.setAspectLocked)
        self._bar.copy_requested.connect(self._copy)
        self._bar.refused.connect(self.refuse)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(2 * SPACE, SPACE, 2 * SPACE, SPACE)
        layout.setSpacing(SPACE)
        layout.addWidget(self._bar)
        layout.addWidget(self._words)
        layout.addWidget(self._plot, 1)

    def show_state(self, before: EditorState | None, after: EditorState) -> None:
        if before is None or before.display.theme != after.display.theme:
            self._plot.show_theme(theme_of(after.display.theme))
        is_same = before is not None and (before.display.section, before.display.layer) == (
            after.display.section,
            after.display.layer,
        )
        if not is_same or after.differs(before, "evaluation", "shown_document"):
            self._show(after)

    def _show(self, state: EditorState) -> None:
        evaluation, document = state.evaluation, state.shown_document
        if evaluation is None or document is None:
            return
        choice = state.display.section or SectionChoice()
        self._plane, self.pieces = plane_of_choice(choice, document), ()
        layer = _layer(state)
        if self._plane is not None:
            surface = evaluation.layer_patch(layer)
            offset, self.pieces = section(surface, self._plane)
            u, v = (np.linspace(*ends, _SAMPLES) for ends in surface.domain)
            heights: Array = surface.points(u, v) @ self._plane.normal
            self._bar.show_choice(choice, offset, (float(heights.min()), float(heights.max())))
        else:
            self._bar.show_choice(choice, 0.0, (0.0, 1.0))
        self._bar.set_copyable(bool(self.pieces))
        self._plot.show_section(self._plane, self.pieces)
        self._words.setText(_text(self._plane, self.pieces, layer))

    def _choose(self, choice: SectionChoice) -> None:
        self.store.dispatch(DisplayChosen("section", choice))

    def _choose_points(self) -> None:
        pair = pair_of(self.store.state.selection.points)
        if pair is None:
            self._show(self.store.shown)
            self.tell("Select two control points first (Shift and a click adds one): the plane stands on both.")
            return
        self._choose(SectionChoice(through=pair))

    def _copy(self) -> None:
        if self._plane is not None and self.pieces:
            copy_table(points_table(self._plane, self.pieces))
            self.tell(f"Copied {sum(len(piece.points) for piece in self.pieces)} points of the section")


def points_table(plane: CuttingPlane, pieces: tuple[SectionCurve, ...]) -> Rows:
    """Return all points of a section under headings: their piece, parameters, coordinates, and place in the plane."""
    across, up = plane.labels
    rows: list[list[str | float]] = [["piece", "u", "v", "x", "y", "z", f"{across} in the plane", f"{up} in the plane"]]
    for number, piece in enumerate(pieces, start=1):
        drawn = plane.drawn(piece.points)
        for at, point, place in zip(piece.parameters, piece.points, drawn, strict=True):
            rows.append([float(number), *at.tolist(), *point.tolist(), *place.tolist()])
    return rows


def _layer(state: EditorState) -> Layer:
    """Return the layer that is shown, of both the one that lies on the net."""
    if state.display.layer is LayerChoice.BOTH:
        return state.document.formulation.resting_layer
    return state.display.layer.layers[0]


def _text(plane: CuttingPlane | None, pieces: tuple[SectionCurve, ...], layer: Layer) -> str:
    if plane is None:
        return "The two points stand over each other: no upright plane is given by them. Choose others."
    if not pieces:
        return f"The plane does not meet the {layer} surface, or holds all of it."
    lengths = ", ".join(f"{value_text(piece.length)}{' (closed)' if piece.is_closed else ''}" for piece in pieces)
    if len(pieces) == 1:
        return f"Length of the section of the {layer} surface, in the net's unit: {lengths}."
    total = value_text(sum(piece.length for piece in pieces))
    whole = f"Length of the section of the {layer} surface, in the net's unit: {total}"
    return f"{whole}, in {len(pieces)} pieces: {lengths}."
