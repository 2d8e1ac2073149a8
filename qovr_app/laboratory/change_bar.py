"""The row of controls that says what is moved, by how much, and on which surface."""

from __future__ import annotations

from PySide6.QtCore import QSignalBlocker, Signal
from PySide6.QtWidgets import QComboBox, QLabel, QWidget

from qovr_app.state.editor_state import Focus
from qovr_app.state.focus import in_window, point_in_window
from qovr_app.state.names import AXES
from qovr_app.style.spacing import SPACE
from qovr_app.style.symbols import symbol_html
from qovr_app.widgets.flow import Flow, kept_together
from qovr_app.widgets.number_field import NumberField
from qovr_app.widgets.parts import CompactButton, named, symbol
from qovr_app.widgets.wheel import guard_from_wheels
from qovr_core import Document, DocumentError, Formulation, Layer
from qovr_core.checks import checked_number
from qovr_core.document import NetIndex, Window
from qovr_core.edits import value_at
from qovr_core.geometry.knots import KnotPlace
from qovr_core.laboratory.influence import DEFAULT_PART, Change, KnotMove, PointMove, default_amount
from qovr_core.number_texts import natural_step

_FIELD_WIDTH = 76
_FIRST_AXIS = 2
"""The heights are what the paper moves."""


class ChangeBar(QWidget):
    """Controls of the change whose influence is shown.

    The amount is the default one until another is typed; what is typed holds for all points, or all knots, that come
    into focus later.

    Signals
    -------
    change_edited : axis, amount or surface is another one
    copy_requested : the button
    refused : why what is typed is no amount; empty when that is outdated
    """

    change_edited = Signal()
    copy_requested = Signal()
    refused = Signal(str)

    def __init__(self, name: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._focused: tuple[Document, KnotPlace | NetIndex] | None = None
        self._formulation: Formulation | None = None
        self._typed: dict[bool, float] = {}
        """Amounts by whether they are a knot's."""
        self._title = named(symbol("", parent=self), f"{name}.title")
        self._axis = named(QComboBox(self), f"{name}.axis", "Axis along which the point moves")
        self._axis.addItems(AXES)
        self._axis.setCurrentIndex(_FIRST_AXIS)
        self._axis.setToolTip("Axis along which the point moves")
        self._by = QLabel("by", self)
        amount = NumberField("the amount", self._check, self._step, self)
        self._amount = named(amount, f"{name}.amount", "Amount of the change")
        self._amount.set_width(_FIELD_WIDTH)
        self._default = CompactButton("Default", f"{name}.default", "", self)
        self._layer = named(QComboBox(self), f"{name}.layer", "Surface on which it is measured")
        for layer in Layer:
            self._layer.addItem(layer.value, layer)
        self._layer.setToolTip("raw: the surface itself. transformed: T is computed again after the change.")
        self._copy = CompactButton(
            "Copy Numbers", f"{name}.copy", "Copy all numbers and the envelope, tab separated", self
        )
        self._connect()
        self._arrange()

    @property
    def change(self) -> Change | None:
        """The change of what is in focus; None where nothing is."""
        if self._focused is None:
            return None
        place, amount = self._focused[1], self._wanted_amount(*self._focused)
        if isinstance(place, KnotPlace):
            return KnotMove(place, amount)
        x, y, z = (amount * (axis == self._axis.currentIndex()) for axis in range(3))
        return PointMove(*place, (x, y, z))

    @property
    def layer(self) -> Layer:
        """The surface on which it is measured."""
        return Layer(self._layer.currentText())

    def show_focus(self, document: Document, focus: Focus, window: Window = (0, 0)) -> None:
        """Show the controls for a knot, a point, or nothing, of a document, which is a window of a net."""
        self._focused = None if focus is None else (document, focus)
        if document.formulation != self._formulation:
            self._formulation = document.formulation
            with QSignalBlocker(self._layer):
                self._layer.setCurrentText(document.formulation.resting_layer)
        is_knot = isinstance(focus, KnotPlace)
        for control in (self._by, self._amount, self._default):
            control.setVisible(focus is not None)
        self._axis.setVisible(focus is not None and not is_knot)
        self._title.setText(_title(focus, window))
        if focus is None:
            return
        self._amount.show_value(self._wanted_amount(document, focus))
        self._default.setEnabled(is_knot in self._typed)
        default = f"{DEFAULT_PART:g}, or as much downward" if is_knot else "a tenth of the net's size, rounded"
        self._default.setToolTip(f"Back to {default}")
        unit = "how much the knot changes" if is_knot else "how far the point moves, in the document's unit"
        self._amount.set_tip(f"By {unit}; the default is {default}. The document is not changed.")

    def set_copyable(self, is_copyable: bool) -> None:
        """Say whether there are numbers to copy."""
        self._copy.setEnabled(is_copyable)

    @property
    def _is_knot(self) -> bool:
        return self._focused is not None and isinstance(self._focused[1], KnotPlace)

    def _wanted_amount(self, document: Document, place: KnotPlace | NetIndex) -> float:
        is_knot = isinstance(place, KnotPlace)
        if is_knot in self._typed:
            return self._typed[is_knot]
        if isinstance(place, KnotPlace):
            return default_amount(document, place)
        return float(f"{DEFAULT_PART * document.net_size:.2g}") or DEFAULT_PART

    def _step(self, amount: float) -> float:
        """Return the step of an amount, which is as large as what it moves in, the net or a knot's interval."""
        return natural_step(amount, 1.0 if self._is_knot or self._focused is None else self._focused[0].net_size)

    def _check(self, value: object, name: str) -> float:
        amount = checked_number(value, name)
        if amount == 0:
            raise DocumentError(name, "0", "a number that moves something")
        if self._focused is not None and isinstance(place := self._focused[1], KnotPlace):
            knot = value_at(self._focused[0], place)
            if not 0 < knot + amount < 1:
                expected = f"more than {-knot:.6g} and less than {1 - knot:.6g}, so that the knot stays between 0 and 1"
                raise DocumentError(name, f"{amount:g}", expected)
        return amount

    def _on_amount_edited(self, amount: float, _gesture: int) -> None:
        self._typed[self._is_knot] = amount
        self.change_edited.emit()

    def _on_default(self) -> None:
        self._typed.pop(self._is_knot, None)
        self._amount.revert()
        self.change_edited.emit()

    def _connect(self) -> None:
        guard_from_wheels(self._axis, self._layer)
        self._axis.currentIndexChanged.connect(lambda _index: self.change_edited.emit())
        self._layer.currentIndexChanged.connect(lambda _index: self.change_edited.emit())
        self._amount.value_edited.connect(self._on_amount_edited)
        self._amount.refused.connect(lambda reason: self.refused.emit(reason and f"{reason}."))
        self._default.clicked.connect(self._on_default)
        self._copy.clicked.connect(self.copy_requested)

    def _arrange(self) -> None:
        layout = Flow(self, SPACE)
        layout.setContentsMargins(0, 0, 0, 0)
        change = kept_together(self, SPACE, self._title, self._axis, self._by, self._amount)
        for control in (change, self._default, kept_together(self, SPACE, QLabel("on", self), self._layer), self._copy):
            layout.addWidget(control)


def _title(focus: Focus, window: Window) -> str:
    if focus is None:
        return ""
    if isinstance(focus, KnotPlace):
        knot = symbol_html(focus.letter, "ip")
        curve = in_window(focus, window).curve
        return f"{knot} of {symbol_html(focus.direction.letter, str(curve))} alone changes"
    i, j = point_in_window(focus, window)
    return f"{symbol_html('P', f'{i},{j}')} moves along"
