"""What the control point or knot in focus moves: a map, a plot against the distance, and the numbers."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from PySide6.QtCore import Qt, QTimer
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QBoxLayout, QCheckBox, QHBoxLayout, QLabel, QStackedWidget, QVBoxLayout, QWidget

from qovr_app.laboratory.change_bar import ChangeBar
from qovr_app.laboratory.falloff_plot import FalloffPlot
from qovr_app.laboratory.heat_map import HeatMap
from qovr_app.laboratory.influence_numbers import FactTable, copied_rows, facts
from qovr_app.laboratory.panel import WIDE, LaboratoryPanel
from qovr_app.laboratory.wording import change_text, value_text
from qovr_app.state.editor_state import EditorState
from qovr_app.state.focus import focus_in_window, focused_document
from qovr_app.state.names import ZONE_TITLES, window_words
from qovr_app.store import Store
from qovr_app.style.spacing import SPACE
from qovr_app.style.theme import theme_of
from qovr_app.widgets.clipboard import copy_table
from qovr_app.widgets.parts import named, words
from qovr_app.work.worker import Worker
from qovr_core import Document, QovrError
from qovr_core.edits import Zone
from qovr_core.geometry.knots import KnotPlace
from qovr_core.laboratory.falloff import Falloff
from qovr_core.laboratory.influence import Influence, KnotMove, influence
from qovr_core.number_texts import percent_text

_NAME = "laboratory.influence"
_TABLE_WIDTH, _ANY = 196, 16_777_215
"""The second is what Qt takes for no largest width."""

_LEAST_MAP, _LEAST_PLOT = 190, 170
_WHAT_TO_DO = (
    "Select a control point in the view, or click into the field of a point or a knot: "
    "what it moves, how far, and what the edges do is shown here."
)


class _Moved(NamedTuple):
    """An influence in which something moves, the document it is of, and how it falls off."""

    document: Document
    influence: Influence
    falloff: Falloff


class InfluencePanel(LaboratoryPanel):
    """Follows the point or knot in focus, and every edit."""

    def __init__(self, store: Store, worker: Worker, parent: QWidget | None = None) -> None:
        super().__init__(store, worker, parent)
        self._moved: _Moved | None = None
        self._due = QTimer(self, singleShot=True, interval=0)
        self._due.timeout.connect(lambda: self._show(self.store.shown))
        self._bar = ChangeBar(_NAME, self)
        self._bar.change_edited.connect(self._due.start)
        self._bar.copy_requested.connect(self._copy)
        self._bar.refused.connect(self.refuse)
        self._words = words(f"{_NAME}.words", self)
        self._words.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self._words.setMargin(4 * SPACE)
        self._map = HeatMap(f"{_NAME}.map", self)
        self._plot = FalloffPlot(f"{_NAME}.plot", self)
        self._table = FactTable(f"{_NAME}.numbers", "Influence in numbers", self)
        self._map_caption, self._plot_caption = (
            named(QLabel(self), f"{_NAME}.{name}") for name in ("map_caption", "plot_caption")
        )
        self._log = named(QCheckBox("log", self), f"{_NAME}.log", "Logarithmic scale")
        self._log.setToolTip("Show the displacement on a logarithmic scale, on which an exponential is a straight line")
        self._log.toggled.connect(self._plot.show_logarithmic)
        self._map.hovered.connect(self._on_map_hovered)
        self._plot.hovered.connect(self._on_plot_hovered)
        self._arrange()

    def show_state(self, before: EditorState | None, after: EditorState) -> None:
        if before is None or before.display.theme != after.display.theme:
            theme = theme_of(after.display.theme)
            self._map.show_theme(theme)
            self._plot.show_theme(theme)
        if before is None or before.focus != after.focus or after.differs(before, "shown_document", "window"):
            self._show(after)

    def _show(self, state: EditorState) -> None:
        document = focused_document(state)
        if document is None:
            return
        self._bar.show_focus(document, focus_in_window(state), state.window)
        self._moved, text = None, _WHAT_TO_DO
        if (change := self._bar.change) is not None:
            try:
                found = influence(document, change, self._bar.layer)
            except QovrError as error:
                text = f"{error}. Another amount may do, or the default."
            else:
                self._moved = None if found.falloff is None else _Moved(document, found, found.falloff)
                text = _why_nothing_moves(document, found)
        self._bar.set_copyable(self._moved is not None)
        self._stack.setCurrentWidget(self._words if self._moved is None else self._content)
        self._words.setText(text)
        if self._moved is not None:
            _, found, fall = self._moved
            self._map.show_influence(found)
            self._plot.show_influence(found, fall)
            self._table.show_facts(facts(found, fall))
            self._place(is_wide=self.width() >= WIDE)
            self._on_map_hovered(None)
            self._on_plot_hovered(None)

    def _copy(self) -> None:
        if self._moved is not None:
            state = self.store.shown
            where = window_words(state.window, state.document.windows)
            what = ", ".join(filter(None, (change_text(self._moved.influence.change), where)))
            copy_table(copied_rows(what, *self._moved))
            self.tell(f"Copied the influence of {what}")

    def _on_map_hovered(self, place: tuple[float, float] | None) -> None:
        if place is None or self._moved is None:
            self._map_caption.setText("|Δ<i>S</i>|, lines at 10 % and 1 %")
            return
        (u, v), found = place, self._moved.influence
        length = math.hypot(*found.displacement.points([u], [v])[0, 0])
        part = percent_text(length / found.largest)
        self._map_caption.setText(f"<i>u</i> {u:.2f} <i>v</i> {v:.2f}: {value_text(length)} = {part}")

    def _on_plot_hovered(self, place: tuple[float, float] | None) -> None:
        if place is None or self._moved is None or not 0 <= place[0] <= self._moved.falloff.envelope[-1, 0]:
            self._plot.show_reading(None)
            self._plot_caption.setText("&nbsp; ".join(self._plot.legend))
            return
        envelope = self._moved.falloff.envelope
        distance, most = envelope[np.abs(envelope[:, 0] - place[0]).argmin()].tolist()
        self._plot.show_reading(distance)
        part = percent_text(most / self._moved.influence.largest)
        self._plot_caption.setText(f"<i>d</i> {distance:.2f}: up to {value_text(most)} = {part}")

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._place(is_wide=self.width() >= WIDE)

    def _place(self, *, is_wide: bool) -> None:
        """Put map, plot and numbers beside each other, or below each other where there is no room for that."""
        directions = QBoxLayout.Direction.TopToBottom, QBoxLayout.Direction.LeftToRight
        self._parts.setDirection(directions[is_wide])
        self._table.setMinimumSize(*((_TABLE_WIDTH, 0) if is_wide else (0, self._table.whole_height)))
        self._table.setMaximumWidth(_TABLE_WIDTH if is_wide else _ANY)
        self._map.setMinimumHeight(_LEAST_MAP)
        self._plot.setMinimumHeight(_LEAST_PLOT)

    def _arrange(self) -> None:
        self._content = QWidget(self)
        self._parts = parts = QBoxLayout(QBoxLayout.Direction.LeftToRight, self._content)
        parts.setContentsMargins(0, 0, 0, 0)
        parts.setSpacing(2 * SPACE)
        parts.addLayout(_captioned(self._map, self._map_caption), 6)
        parts.addLayout(_captioned(self._plot, self._plot_caption, self._log), 5)
        parts.addWidget(self._table)
        self._stack = QStackedWidget(self)
        self._stack.addWidget(self._words)
        self._stack.addWidget(self._content)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(2 * SPACE, SPACE, 2 * SPACE, SPACE)
        layout.setSpacing(SPACE)
        layout.addWidget(self._bar)
        layout.addWidget(self._stack, 1)


def _captioned(picture: QWidget, *caption: QWidget) -> QVBoxLayout:
    """Return a picture under a line that begins with its caption."""
    head = QHBoxLayout()
    for widget in caption:
        head.addWidget(widget, widget is caption[0])
    column = QVBoxLayout()
    column.setSpacing(SPACE // 2)
    column.addLayout(head)
    column.addWidget(picture, 1)
    return column


def _why_nothing_moves(document: Document, found: Influence) -> str:
    change = found.change
    if isinstance(change, KnotMove) and _is_idle(document, change.place):
        direction = change.place.direction
        used = f"{ZONE_TITLES[Zone(direction)].lower()} of {', '.join(document.formulation.active_names(direction))}"
        return (
            f"This knot moves nothing: the {document.formulation} surface uses the {used} alone. "
            "Choose another formulation to see what it does there."
        )
    return "Nothing moves."


def _is_idle(document: Document, place: KnotPlace) -> bool:
    return not document.formulation.is_active(place.direction, place.curve)
