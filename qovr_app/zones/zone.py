"""What the three zones of fields have in common: Get and Set, pending text, blocks from a spreadsheet."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Callable, Mapping, Sequence

from PySide6.QtCore import QPoint, Qt
from PySide6.QtWidgets import QFrame, QHBoxLayout, QLabel, QVBoxLayout, QWidget

from qovr_app.state.editor_state import EditorState
from qovr_app.state.focus import has_window, in_window, is_net, opposite
from qovr_app.state.intents import Intent, TextTyped, ValuesEdited, ValuesPasted, ZoneRead, ZoneSet
from qovr_app.state.looking_intents import FieldFocused, MessageOutdated, MessageShown
from qovr_app.state.names import ZONE_TITLES, in_window_words, label, object_name, spoken, window_words
from qovr_app.state.requests import FieldMenuAsked
from qovr_app.state.typed import typed_block
from qovr_app.store import Store
from qovr_app.style.spacing import SPACE
from qovr_app.widgets.clipboard import Rows, pasted_cells
from qovr_app.widgets.number_field import NumberField, Snapping
from qovr_app.widgets.parts import MARGINS, CompactButton, named, symbol, title_html
from qovr_app.zones.gestures import dispatch_gestures
from qovr_core import Document, DocumentError, QovrError
from qovr_core.document import Window
from qovr_core.edits import Place, Zone, value_at


class FieldZone(QFrame):
    """A zone of fields, one a number of the document: shows the draft, and dispatches what the user wants of it."""

    def __init__(self, zone: Zone, aside: str, store: Store, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.zone, self._store = zone, store
        self.setObjectName(f"zone.{zone}")
        self.setAccessibleName(ZONE_TITLES[zone])
        self.shown_window: Window = (0, 0)
        self.fields: dict[Place, NumberField] = {}
        """By the places of the window that is shown."""
        self._has_reported = False  # then a field shows what it has asked for, which may be undone in the same turn
        self._where = named(symbol("", quiet=True, parent=self), f"{zone}.window")
        self._where.setVisible(False)
        self._layout = QVBoxLayout(self)
        self._layout.setContentsMargins(*MARGINS)
        self._layout.setSpacing(SPACE)
        title = QHBoxLayout()
        title.setSpacing(SPACE)
        title.addWidget(symbol(title_html(ZONE_TITLES[zone], aside), parent=self), 1)
        title.addWidget(self._where)
        self._layout.addLayout(title)

    def show_state(self, before: EditorState | None, after: EditorState) -> None:
        """Show the draft of a state, and mark what differs from the document."""
        if before is not None:
            _drop_texts(self.fields, before, after)
        if before is None or (before.window, before.document.windows) != (after.window, after.document.windows):
            self._turn_to(after)
        if after.differs(before, "document", "draft", "window") or self._has_reported:
            self._has_reported = False
            draft, document = after.draft, after.document
            for place, field in self.fields.items():
                value = value_at(draft, place)
                field.show_value(value, is_unset=draft is not document and value != value_at(document, place))
        if after.differs(before, "document", "draft", "texts", "window"):
            self._count_pending()

    def _turn_to(self, state: EditorState) -> None:
        """Let the fields stand for the numbers of the window in focus."""
        back, in_net = opposite(self.shown_window), is_net(state)
        for place, field in self.fields.items():
            if field.hasFocus() and place in state.texts:
                field.commit()  # as leaving it would
        self.shown_window = state.window
        fields = [(in_window(place, back), field) for place, field in self.fields.items()]
        self.fields.clear()
        for local, field in fields:
            place = in_window(local, self.shown_window)
            self.fields[place] = field
            name, tip = label(place, in_net=in_net), self._tip(place, state.document)
            field.turn_to(name, tip, value_at(state.draft, place), state.texts.get(place))
            field.setAccessibleName(spoken(place, in_net=in_net))
        self._where.setText(window_words(self.shown_window, state.document.windows))
        self._where.setVisible(in_net)
        self.setAccessibleDescription(self._where.text())

    def get_values(self) -> None:
        """Read the active state into the fields."""
        for field in self.fields.values():
            field.revert()
        self._store.dispatch(ZoneRead(self.zone))

    def set_values(self) -> None:
        """Report what the fields hold, or which of them holds nothing valid: then nothing is set."""
        typed, refusals = {}, []
        for place, field in self.fields.items():
            if field.has_own_text:
                try:
                    typed[place] = field.typed()
                except QovrError as error:
                    refusals.append((field, str(error)))
        if refusals:
            field, reason = refusals[0]
            field.setFocus()
            more = f" ({len(refusals)} fields are marked.)" if len(refusals) > 1 else ""
            self._refuse(f"Nothing was set: {reason}.{more}")
            return
        if self._store.dispatch(ZoneSet(self.zone, typed)) is None:
            for place in typed:
                self.fields[place].accept()

    def focus_first(self) -> None:
        """Bring the keyboard to the field that had it last, else to the first one."""
        self.fields[self._place].setFocus()
        self.fields[self._place].selectAll()

    @property
    def _place(self) -> Place:
        """The field that has, or had last, the keyboard; the first one before any had it."""
        place = self._store.state.fields.get(self.zone)
        return place if place in self.fields else next(iter(self.fields))

    def _shown(self, local: Place) -> Place:
        """Return the place of the window that is shown, for one of window (0, 0)."""
        return in_window(local, self.shown_window)

    @abstractmethod
    def _tip(self, place: Place, document: Document) -> str:
        """Return what the number at a place means."""

    @abstractmethod
    def copied_block(self) -> Rows:
        """Return the zone's numbers as a table, as they lie in a spreadsheet."""

    @abstractmethod
    def _places_of_block(self, rows: int, columns: int) -> Sequence[Sequence[Place]]:
        """Return where a block of this size goes, or raise DocumentError with the sizes that have a place."""

    def paste(self) -> None:
        """Report the numbers of the table on the clipboard, all or none."""

        def has_place(rows: int, columns: int) -> bool:
            try:
                self._places_of_block(rows, columns)
            except DocumentError:
                return False
            return True

        try:
            block = typed_block(pasted_cells(), has_place)
            places = self._places_of_block(len(block), len(block[0]))
            values = {}
            for place_row, row in zip(places, block, strict=True):
                for place, value in zip(place_row, row, strict=True):
                    values[place] = self._check(value, label(place, in_net=is_net(self._store.state)))
        except QovrError as error:
            self._refuse(f"Nothing was pasted: {error}.")
            return
        for place in values:
            self.fields[place].revert()
        self._store.dispatch(ValuesPasted(values))

    # For the zones

    _check: Callable[[object, str], float]
    _snapping: Snapping | None = None
    """Of what dragged numbers are multiples; without, of a key's step, while Ctrl is held."""

    longest: str
    """A usual number of the zone that is as long as they come: six digits, and a sign where it can have one."""

    def _make_field(self, place: Place, step: Callable[[float], float]) -> NumberField:
        field = NumberField(label(place), self._check, step, self, snapping=self._snapping)
        field.setObjectName(object_name(place))
        field.value_edited.connect(lambda value, gesture: self._on_value_edited(self._shown(place), value, gesture))
        dispatch_gestures(field, self._store.dispatch)
        field.refused.connect(lambda reason: self._refuse(reason and f"{reason}."))
        field.focused.connect(lambda: self._store.dispatch(FieldFocused(self._shown(place))))
        field.text_owned.connect(lambda: self._on_text_owned(self._shown(place), field))
        field.block_pasted.connect(self.paste)
        field.setContextMenuPolicy(Qt.ContextMenuPolicy.CustomContextMenu)
        field.customContextMenuRequested.connect(
            lambda at: self._ask_for_menu(self._shown(place), field.mapToGlobal(at))
        )
        self.fields[place] = field
        return field

    def _on_value_edited(self, place: Place, value: float, gesture: int) -> None:
        self._has_reported = True
        error = self._store.dispatch(self._edit_of(place, value, gesture))
        if error is not None:
            self.fields[place].refuse(value_at(self._store.state.draft, place), in_window_words(str(error)))

    def _edit_of(self, place: Place, value: float, gesture: int) -> Intent:
        """Return what sets the number at a place."""
        return ValuesEdited({place: value}, gesture)

    def _ask_for_menu(self, place: Place, at: QPoint) -> None:
        self._store.dispatch(FieldFocused(place))
        self._store.dispatch(FieldMenuAsked((at.x(), at.y())))

    def _on_text_owned(self, place: Place, field: NumberField) -> None:
        before = self._store.state.texts
        if field.has_own_text or place in before:
            self._store.dispatch(TextTyped(place, field.text() if field.has_own_text else None))
        if self._store.state.texts is not before:
            self._count_pending()

    def _refuse(self, text: str) -> None:
        """Say why something was not done; an empty text says that this is outdated."""
        self._store.dispatch(MessageShown(text, is_refusal=True) if text else MessageOutdated(only_refusals=True))

    def _make_buttons(self) -> QHBoxLayout:
        """Return the row of Get and Set; made after the fields, because Tab goes in the order of making."""
        zone, title = self.zone, ZONE_TITLES[self.zone].lower()
        self._count = QLabel(self)
        self._get = CompactButton("Get Values", f"{zone}.get", f"Read the active {title} back into the fields", self)
        self._set = CompactButton("Set Values", f"{zone}.set", f"Make the fields the active {title}, all or none", self)
        self._get.setAccessibleName(f"Get Values of the {title}")
        self._set.setAccessibleName(f"Set Values of the {title}")
        self._get.clicked.connect(self.get_values)
        self._set.clicked.connect(self.set_values)
        row = QHBoxLayout()
        row.setSpacing(SPACE)
        row.addWidget(self._count, 1)
        row.addWidget(self._get)
        row.addWidget(self._set)
        return row

    def _count_pending(self) -> None:
        state = self._store.state
        count = state.count_pending(self.fields) if has_window(state.document, self.shown_window) else 0
        self._set.set_due(count > 0)
        self._count.setText(f"{count} not set" if count else "")


def no_place(rows: int, columns: int, expected: str) -> DocumentError:
    """Return the refusal of a block that has no place."""
    return DocumentError("the block", f"{rows} x {columns} numbers", expected)


def _drop_texts(fields: Mapping[Place, NumberField], before: EditorState, after: EditorState) -> None:
    """Drop the texts of fields that the state holds no longer."""
    if before.texts is not after.texts:
        for place in before.texts:
            if place not in after.texts and place in fields:
                fields[place].revert()
