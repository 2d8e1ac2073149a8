"""What the three zones of fields have in common: Get and Set, pending text, blocks from a spreadsheet."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Callable

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QFrame, QHBoxLayout, QLabel, QVBoxLayout, QWidget

from qovr_app.state.names import ZONE_TITLES, label, object_name, spoken
from qovr_app.state.typed import typed_block
from qovr_app.style.spacing import SPACE
from qovr_app.widgets.number_field import NumberField
from qovr_app.widgets.parts import MARGINS, CompactButton, title_html
from qovr_core import Document, DocumentError, QovrError
from qovr_core.edits import Place, Zone, value_at


class FieldZone(QFrame):
    """A zone of fields, one a number of the document.

    Signals
    -------
    values_edited : a dict of places and values that one intent changes, and its gesture, 0 for none
    values_pasted : a dict of places and values
    set_requested : a dict of the values typed and not yet reported, all of them valid
    get_requested : the fields have dropped their own text
    refused : one sentence that says what was not done, and why; empty when that is outdated
    """

    values_edited = Signal(object, int)
    values_pasted = Signal(object)
    set_requested = Signal(object)
    get_requested = Signal()
    refused = Signal(str)

    def __init__(self, zone: Zone, aside: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.zone = zone
        self.setObjectName(f"zone.{zone}")
        self.setAccessibleName(ZONE_TITLES[zone])
        self.fields: dict[Place, NumberField] = {}
        self._focused: Place | None = None
        self._title = QLabel(title_html(ZONE_TITLES[zone], aside), self)
        self._layout = QVBoxLayout(self)
        self._layout.setContentsMargins(*MARGINS)
        self._layout.setSpacing(SPACE)
        self._layout.addWidget(self._title)

    def show_documents(self, document: Document, draft: Document) -> None:
        """Show a draft, and mark what differs from the document."""
        for place, field in self.fields.items():
            value = value_at(draft, place)
            field.show_value(value, is_unset=value != value_at(document, place))
        self._count_pending()

    def drop_text(self) -> None:
        """Drop every field's own text."""
        for field in self.fields.values():
            field.revert()

    def get_values(self) -> None:
        """Read the active state into the fields."""
        self.drop_text()
        self.get_requested.emit()

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
            self.refused.emit(f"Nothing was set: {reason}.{more}")
            return
        for place in typed:
            self.fields[place].accept()
        self.set_requested.emit(typed)

    def focus_first(self) -> None:
        """Bring the keyboard to the field that had it last, else to the first one."""
        place = self._focused or next(iter(self.fields))
        self.fields[place].setFocus()
        self.fields[place].selectAll()

    @abstractmethod
    def copied_block(self) -> list[list[float]]:
        """Return the zone's numbers as a table, as they lie in a spreadsheet."""

    @abstractmethod
    def _places_of_block(self, rows: int, columns: int) -> list[list[Place]]:
        """Return where a block of this size goes, or raise DocumentError with the sizes that have a place."""

    def paste_block(self, text: str) -> None:
        """Report the numbers of a spreadsheet's block, all or none."""
        try:
            block = typed_block(text)
            places = self._places_of_block(len(block), len(block[0]))
            values = {}
            for place_row, row in zip(places, block, strict=True):
                for place, value in zip(place_row, row, strict=True):
                    values[place] = self._check(value, label(place))
        except QovrError as error:
            self.refused.emit(f"Nothing was pasted: {error}.")
            return
        for place in values:
            self.fields[place].revert()
        self.values_pasted.emit(values)

    # For the zones

    _check: Callable[[object, str], float]

    def _make_field(self, place: Place, step: float) -> NumberField:
        field = NumberField(label(place), self._check, step, self)
        field.setObjectName(object_name(place))
        field.setAccessibleName(spoken(place))
        field.value_edited.connect(lambda value, gesture: self.values_edited.emit({place: value}, gesture))
        field.refused.connect(lambda reason: self.refused.emit(reason and f"{reason}."))
        field.focused.connect(lambda: self._on_focused(place))
        field.text_owned.connect(self._count_pending)
        field.block_pasted.connect(self.paste_block)
        self.fields[place] = field
        return field

    def _on_focused(self, place: Place) -> None:
        self._focused = place

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
        count = sum(field.is_pending for field in self.fields.values())
        self._set.set_due(count > 0)
        self._count.setText(f"{count} not set" if count else "")

    def _no_place(self, rows: int, columns: int, expected: str) -> DocumentError:
        return DocumentError("the block", f"{rows} x {columns} numbers", expected)
