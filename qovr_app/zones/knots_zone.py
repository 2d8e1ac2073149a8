"""The two zones of internal knots, and the slider of the field that has the keyboard."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import chain

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QGridLayout, QHBoxLayout, QLabel, QWidget

from qovr_app.state.editor_state import EditorState
from qovr_app.state.field_facts import default_value
from qovr_app.state.focus import in_window, is_net, opposite
from qovr_app.state.intents import FormulationChosen, Intent
from qovr_app.state.knot_intents import KnotsSet
from qovr_app.state.names import knot_meaning, spoken
from qovr_app.store import Store
from qovr_app.style.spacing import SPACE
from qovr_app.style.symbols import symbol_html
from qovr_app.widgets.clipboard import Rows
from qovr_app.widgets.header_label import HeaderLabel
from qovr_app.widgets.parts import Note, named
from qovr_app.widgets.wheel import guard_from_wheels
from qovr_app.zones.gestures import dispatch_gestures
from qovr_app.zones.headings import Headings
from qovr_app.zones.knot_notes import KnotNotes, five_curves, shared_words
from qovr_app.zones.knot_slider import KnotSlider
from qovr_app.zones.knot_transformations import KnotTransformations
from qovr_app.zones.net_facts import structure_of
from qovr_app.zones.zone import FieldZone, no_place
from qovr_core import Document, Knots
from qovr_core.checks import checked_knot
from qovr_core.edits import Place, Zone, knots_of
from qovr_core.geometry.folding import forward_range
from qovr_core.geometry.knots import KNOT_NAMES, Direction, KnotPlace, KnotTable
from qovr_core.geometry.windows import NET_SIZE
from qovr_core.number_texts import knot_step

_NAMES = {Direction.ROWS: KNOT_NAMES, Direction.COLUMNS: KNOT_NAMES[::-1]}
"""The knots in the order of the paper's window: rightwards for the rows, downwards for the columns."""

_LEAST_PLOT = 104
"""Lower, a picture of the knots with its title says nothing: then the zones are scrolled."""


_TALLEST = 1.25
"""How far a field of a knot may grow: what height is left says more in the picture under the fields."""


class KnotsZone(FieldZone):
    """The knots of the five curves of one direction, as the net lies: rows upward, columns rightward."""

    longest = "0.123456"
    _check = staticmethod(checked_knot)

    def __init__(self, direction: Direction, store: Store, parent: QWidget | None = None) -> None:
        letter, parameter = direction.letter, direction.parameter
        index = "i" if direction is Direction.ROWS else "j"
        super().__init__(Zone(direction.value), f"{symbol_html(letter, index)}(<i>{parameter}</i>)", store, parent)
        self._direction = direction
        self._headings = Headings(store, self.fields, lambda: self.shown_window)
        self._layout.addLayout(self._make_grid(), 1)
        self._caption = QLabel(self)
        self._slider = KnotSlider(f"{direction}.slider", self)
        guard_from_wheels(self._slider)
        self._slider.knot_moved.connect(self._on_slider_moved)
        self._slider.reset_asked.connect(lambda: self._on_slider_moved(default_value(store.state, self._knot), 0))
        self._slider.menu_asked.connect(lambda at: self._ask_for_menu(self._knot, at))
        dispatch_gestures(self._slider, store.dispatch)
        slider_row = QHBoxLayout()
        slider_row.setSpacing(2 * SPACE)
        slider_row.addWidget(self._caption)
        slider_row.addWidget(self._slider, 1)
        self._layout.addLayout(slider_row)
        self._layout.addLayout(self._make_buttons())
        self._note = Note(f"{direction}.note", self)
        self._note.linkActivated.connect(lambda name: store.dispatch(FormulationChosen(name)))
        self._layout.addWidget(self._note)
        self._transformations = named(KnotTransformations(direction, store, self), f"{direction}.plot")
        self._transformations.setMinimumHeight(_LEAST_PLOT)
        self._layout.addWidget(self._transformations, 1)

    def show_state(self, before: EditorState | None, after: EditorState) -> None:
        super().show_state(before, after)
        self._transformations.show_state(before, after)
        if before is not None and before.document.joints != after.document.joints:
            for place, field in self.fields.items():
                field.set_tip(self._tip(place, after.document))
        if before is None or self._noted(before) != self._noted(after):
            curves = five_curves(after.draft, self._direction, after.window)
            self._show_effects(KnotNotes(self._direction, after.document, after.window, curves))
        if before is None or self._slid(before) != self._slid(after):
            self._show_slider(after)

    def _noted(self, state: EditorState) -> tuple[object, ...]:
        """Return what the notes depend on; most edits leave it as it is."""
        return self._knots(state), structure_of(state.document), state.window

    def _slid(self, state: EditorState) -> tuple[object, ...]:
        """Return what the slider and its caption depend on."""
        return self._knots(state), state.fields, state.links, state.window

    def _knots(self, state: EditorState) -> KnotTable:
        return knots_of(state.draft, self._direction)

    def _show_effects(self, notes: KnotNotes) -> None:
        """Mark the knots without effect, and those whose curve folds back."""
        active, warnings = notes.active, [notes.warning(number) for number in range(NET_SIZE)]
        for local in chain(*self._table()):
            field = self.fields[self._shown(local)]
            field.set_idle(local.curve not in active)
            field.set_warning(warnings[local.curve])
        self._note.say(notes.html())

    def _tip(self, place: Place, document: Document) -> str:
        if not isinstance(place, KnotPlace):
            return ""
        return "\n".join(filter(None, (knot_meaning(place), shared_words(document, place))))

    def copied_block(self) -> Rows:
        return [[self.fields[place].value for place in row] for row in self._shown_table()]

    def _shown_table(self) -> list[list[Place]]:
        return [[self._shown(place) for place in row] for row in self._table()]

    def _table(self) -> list[list[KnotPlace]]:
        """Return the places of window (0, 0) as they stand on the screen."""
        numbers, names = range(NET_SIZE), _NAMES[self._direction]
        if self._direction is Direction.ROWS:
            return [[KnotPlace(self._direction, k, name) for name in names] for k in reversed(numbers)]
        return [[KnotPlace(self._direction, k, name) for k in numbers] for name in names]

    def _places_of_block(self, rows: int, columns: int) -> list[list[Place]]:
        table = self._shown_table()
        whole = (len(table), len(table[0]))
        if (rows, columns) == whole:
            return table
        r, c = next((r, row.index(self._place)) for r, row in enumerate(table) if self._place in row)
        part = [row[c : c + columns] for row in table[r : r + rows]]
        if len(part) < rows or len(part[0]) < columns:
            expected = f"the whole zone, {whole[0]} x {whole[1]}, or what fits right of and below the field"
            raise no_place(rows, columns, expected)
        return part

    def _make_grid(self) -> QGridLayout:
        grid = QGridLayout()
        grid.setHorizontalSpacing(SPACE)
        grid.setVerticalSpacing(2)
        table = self._table()
        for r, row in enumerate(table, start=1):
            grid.addWidget(self._line_header(row), r, 0)
            grid.setRowStretch(r, 1)
            for c, place in enumerate(row, start=1):
                field = self._make_field(place, knot_step)
                field.set_tallest(_TALLEST)
                grid.addWidget(field, r, c)
        for c, column in enumerate(zip(*table, strict=True), start=1):
            grid.addWidget(self._line_header(column), 0, c, Qt.AlignmentFlag.AlignRight)
            grid.setColumnStretch(c, 1)
        return grid

    def _line_header(self, line: Sequence[KnotPlace]) -> HeaderLabel:
        """Return the heading of a line of the table: of one curve, or of one knot of all curves."""
        first, curves = line[0], sorted({place.curve for place in line})
        is_curve = len(curves) == 1
        letter, index = (self._direction.letter, str(first.curve)) if is_curve else (first.letter, "ip")
        points = [(k, n) if self._direction is Direction.ROWS else (n, k) for k in curves for n in range(NET_SIZE)]
        name = f"{self._direction}.{self._direction.curve_name(first.curve) if is_curve else first.letter}"
        return self._headings.heading(symbol_html(letter, index), name, line, points)

    def _on_slider_moved(self, value: float, gesture: int) -> None:
        self.fields[self._knot].revert()
        if self._store.dispatch(self._edit_of(self._knot, value, gesture)) is not None:
            self._show_slider(self._store.state)

    def _edit_of(self, place: Place, value: float, gesture: int) -> Intent:
        """Return what sets one knot, or what is no knot."""
        if not isinstance(place, KnotPlace):
            return super()._edit_of(place, value, gesture)
        return KnotsSet(place.direction, place.curve, place.window, place.name, value, gesture)

    @property
    def _knot(self) -> KnotPlace:
        """The knot that the slider moves."""
        place = self._place
        return place if isinstance(place, KnotPlace) else self._table()[0][0]

    def _show_slider(self, state: EditorState) -> None:
        place, letter = self._knot, self._direction.letter
        ends = 0, len(knots_of(state.draft, self._direction)) - 1
        own = in_window(place, opposite(self.shown_window)).curve
        curves = ends if state.links.curves else (own,)
        whose = "..".join(symbol_html(letter, str(number)) for number in curves)
        more = f" + {self._direction.other.letter}" if state.links.directions else ""
        self._caption.setText(f"{symbol_html(place.letter, 'ip')} of {whose}{more}")
        self._slider.setAccessibleName(f"{spoken(place, in_net=is_net(state))}, slider")
        knots = Knots(**{name: self.fields[replace(place, name=name)].value for name in KNOT_NAMES})
        self._slider.show_knot(self.fields[place].value, forward_range(knots, place.name))
