"""The controls of the comparison: which surface the view shows besides, where, with what weight and colours."""

from __future__ import annotations

from PySide6.QtCore import QSignalBlocker, Qt, Signal
from PySide6.QtWidgets import QComboBox, QToolButton, QWidget

from qovr_app.state.display import Placement
from qovr_app.state.editor_state import EditorState
from qovr_app.state.focus import measured_in_window, point_in_window
from qovr_app.state.looking_intents import ComparisonChosen, DistanceMapSwitched
from qovr_app.store import Dispatch
from qovr_app.style.spacing import SPACE
from qovr_app.style.symbols import symbol_html
from qovr_app.widgets.flow import Flow, kept_together
from qovr_app.widgets.number_field import NumberField
from qovr_app.widgets.parts import CompactButton, named, symbol
from qovr_app.widgets.wheel import guard_from_wheels
from qovr_core import DocumentError
from qovr_core.checks import checked_number, described
from qovr_core.fields import Field
from qovr_core.laboratory.comparison_surfaces import COMPARISON_SURFACES
from qovr_core.number_texts import natural_step

_NAME = "laboratory.comparison"
_PLACEMENTS = {Placement.OVER: "over QOVR", Placement.BESIDE: "beside QOVR", "": "not in the view"}
_FIELD_WIDTH = 64
_TENS = 10
"""A weight steps by tenths of itself, where a length steps by hundredths: less is seen nowhere."""

_TOOL_TIP = Qt.ItemDataRole.ToolTipRole


class ComparisonBar(QWidget):
    """Choices of one surface to look at, and the weight of the measured point.

    Signals
    -------
    copy_requested : the button
    refused : why what is typed is no weight; empty when that is outdated
    """

    copy_requested = Signal()
    refused = Signal(str)

    def __init__(self, dispatch: Dispatch, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._dispatch = dispatch
        self._surface = named(QComboBox(self), f"{_NAME}.surface", "Surface shown in the view besides QOVR")
        for index, (name, surface) in enumerate(COMPARISON_SURFACES.items()):
            self._surface.addItem(surface.title, name)
            self._surface.setItemData(index, surface.description, _TOOL_TIP)
        self._surface.setToolTip("The surface of the same net that the view shows besides QOVR")
        self._placement = named(QComboBox(self), f"{_NAME}.placement", "Where the view shows the surface")
        for placement, text in _PLACEMENTS.items():
            self._placement.addItem(text, placement)
        self._placement.setToolTip("Over: its lines on QOVR's picture. Beside: a picture of its own, same camera.")
        self._weight_label = symbol("", parent=self)
        self._weight = named(
            NumberField("the weight", _checked_weight, _weight_step, self),
            f"{_NAME}.weight",
        )
        self._weight.set_width(_FIELD_WIDTH)
        self._distances = DistanceMapSwitch(dispatch, self)
        self._copy = CompactButton(
            "Copy Numbers", f"{_NAME}.copy", "Copy the table with every digit, tab separated", self
        )
        self._connect()
        self._arrange()

    def show_state(self, state: EditorState) -> None:
        """Show what is compared with, where, and which point has the weight."""
        choice, (i, j) = state.comparison, point_in_window(measured_in_window(state), state.window)
        with QSignalBlocker(self._surface), QSignalBlocker(self._placement):
            self._surface.setCurrentIndex(self._surface.findData(choice.surface))
            self._placement.setCurrentIndex(self._placement.findData(choice.placement or ""))
        self._weight.show_value(choice.weight)
        self._weight_label.setText(f"NURBS weight {symbol_html('w', f'{i},{j}')}")
        self._weight.setAccessibleName(f"Weight of control point P {i} {j} in the NURBS surface")
        self._weight.set_tip(f"Weight of P {i},{j} in the NURBS surface; every other point has 1.")
        self._distances.show_state(state)

    def set_copyable(self, is_copyable: bool) -> None:
        """Say whether there are numbers to copy."""
        self._copy.setEnabled(is_copyable)

    def _choose(self) -> None:
        surface, placement = self._surface.currentData(), self._placement.currentData()
        self._dispatch(ComparisonChosen(str(surface), str(placement), self._weight.value))

    def _connect(self) -> None:
        guard_from_wheels(self._surface, self._placement)
        for box in (self._surface, self._placement):
            box.currentIndexChanged.connect(lambda _index: self._choose())
        self._weight.value_edited.connect(lambda _weight, _gesture: self._choose())
        self._weight.refused.connect(lambda reason: self.refused.emit(reason and f"{reason}."))
        self._copy.clicked.connect(self.copy_requested)

    def _arrange(self) -> None:
        layout = Flow(self, SPACE)
        layout.setContentsMargins(0, 0, 0, 0)
        weight = kept_together(self, SPACE, self._weight_label, self._weight)
        for control in (self._surface, self._placement, self._distances, weight, self._copy):
            layout.addWidget(control)


class DistanceMapSwitch(QToolButton):
    """Colours the surfaces by their distance from each other, and brings the colours back that were there before."""

    def __init__(self, dispatch: Dispatch, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setText("Distance map")
        self.setCheckable(True)
        self.setAutoRaise(True)
        self.setObjectName(f"{_NAME}.distance_map")
        self.setToolTip("Colour each surface by its distance from the other; pressed again, as it was before")
        self.clicked.connect(lambda is_wanted: dispatch(DistanceMapSwitched(is_wanted)))

    def show_state(self, state: EditorState) -> None:
        """Say whether there is a surface to take distances from, and whether the colours are distances."""
        self.setEnabled(state.shown_comparison is not None)
        self.setChecked(state.display.colour_by == Field.DISTANCE.name)


def _weight_step(weight: float) -> float:
    return natural_step(weight, _TENS * weight)


def _checked_weight(value: object, name: str) -> float:
    weight = checked_number(value, name)
    if weight <= 0:
        raise DocumentError(name, described(weight), "a positive number")
    return weight
