"""The controls of the comparison: which surface the view shows besides, where, with what weight and colours."""

from __future__ import annotations

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QComboBox, QHBoxLayout, QToolButton, QWidget

from qovr_app.state.display import Placement
from qovr_app.style.spacing import SPACE
from qovr_app.style.symbols import symbol_html
from qovr_app.widgets.number_field import NumberField
from qovr_app.widgets.parts import CompactButton, symbol
from qovr_core import DocumentError
from qovr_core.checks import checked_number, described
from qovr_core.laboratory.comparison import DEFAULT_WEIGHT
from qovr_core.laboratory.comparison_surfaces import COMPARISON_SURFACES, ComparisonSurface

_NAME = "laboratory.comparison"
_PLACEMENTS = {Placement.OVER: "over QOVR", Placement.BESIDE: "beside QOVR", None: "not in the view"}
_FIRST_SURFACE = "b-spline"
_FIELD_WIDTH = 64
_TOOL_TIP = Qt.ItemDataRole.ToolTipRole


class ComparisonBar(QWidget):
    """Choices of one surface to look at, and the weight of the measured point.

    Signals
    -------
    view_changed : another surface or placement is chosen
    weight_changed : the weight is another one
    copy_requested : the button
    refused : why what is typed is no weight; empty when that is outdated
    """

    view_changed = Signal()
    weight_changed = Signal()
    copy_requested = Signal()
    refused = Signal(str)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._surface = QComboBox(
            self, objectName=f"{_NAME}.surface", accessibleName="Surface shown in the view besides QOVR"
        )
        for index, (name, surface) in enumerate(COMPARISON_SURFACES.items()):
            self._surface.addItem(surface.title, name)
            self._surface.setItemData(index, surface.description, _TOOL_TIP)
        self._surface.setCurrentIndex(list(COMPARISON_SURFACES).index(_FIRST_SURFACE))
        self._surface.setToolTip("The surface of the same net that the view shows besides QOVR")
        self._placement = QComboBox(
            self, objectName=f"{_NAME}.placement", accessibleName="Where the view shows the surface"
        )
        for placement, text in _PLACEMENTS.items():
            self._placement.addItem(text, placement)
        self._placement.setToolTip("Over: its lines on QOVR's picture. Beside: a picture of its own, same camera.")
        self._weight_label = symbol("", parent=self)
        self._weight = NumberField("the weight", _checked_weight, 1.0, self)
        self._weight.setObjectName(f"{_NAME}.weight")
        self._weight.setFixedWidth(_FIELD_WIDTH)
        self._weight.show_value(DEFAULT_WEIGHT)
        self.distances = DistanceMapSwitch(self)
        self._copy = CompactButton(
            "Copy Numbers", f"{_NAME}.copy", "Copy the table with every digit, tab separated", self
        )
        self._connect()
        self._arrange()

    @property
    def surface(self) -> ComparisonSurface:
        """The surface that is looked at."""
        return COMPARISON_SURFACES[self._surface.currentData()]

    @property
    def placement(self) -> Placement | None:
        """Where it stands in the view; None for nowhere."""
        chosen = self._placement.currentData()
        return None if chosen is None else Placement(chosen)

    @property
    def weight(self) -> float:
        """The weight of the measured point."""
        return self._weight.value

    def show_point(self, i: int, j: int) -> None:
        """Say which point has the weight."""
        self._weight_label.setText(f"NURBS weight {symbol_html('w', f'{i},{j}')}")
        self._weight.setAccessibleName(f"Weight of control point P {i} {j} in the NURBS surface")
        self._weight.set_tip(f"Weight of P {i},{j} in the NURBS surface; every other point has 1.")

    def set_copyable(self, is_copyable: bool) -> None:
        """Say whether there are numbers to copy."""
        self._copy.setEnabled(is_copyable)

    def _on_view_chosen(self) -> None:
        self.distances.set_useful(self.placement is not None)
        self.view_changed.emit()

    def _connect(self) -> None:
        for box in (self._surface, self._placement):
            box.currentIndexChanged.connect(lambda _index: self._on_view_chosen())
        self._weight.value_edited.connect(lambda _weight, _gesture: self.weight_changed.emit())
        self._weight.refused.connect(lambda reason: self.refused.emit(reason and f"{reason}."))
        self._copy.clicked.connect(self.copy_requested)

    def _arrange(self) -> None:
        layout = QHBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(SPACE)
        layout.addWidget(self._surface)
        layout.addWidget(self._placement)
        layout.addWidget(self.distances)
        layout.addStretch(1)
        layout.addWidget(self._weight_label)
        layout.addWidget(self._weight)
        layout.addWidget(self._copy)


class DistanceMapSwitch(QToolButton):
    """Colours the surfaces by their distance from each other, and brings the colours back that were there before."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setText("Distance map")
        self.setCheckable(True)
        self.setAutoRaise(True)
        self.setObjectName(f"{_NAME}.distance_map")
        self.setToolTip("Colour each surface by its distance from the other; pressed again, as it was before")
        self._action: QAction | None = None
        self._before: QAction | None = None
        self.clicked.connect(self._on_clicked)

    def use(self, action: QAction) -> None:
        """Take the command that colours by distance, one of an exclusive group."""
        self._action = action
        self.setChecked(action.isChecked())
        action.toggled.connect(self.setChecked)

    def set_useful(self, is_useful: bool) -> None:
        """Say whether there is a surface to take distances from; without one the colours before come back."""
        self.setEnabled(is_useful)
        if not is_useful:
            self.restore()

    def restore(self) -> None:
        """Bring back the colours that were there before it was pressed."""
        if self._before is not None and self._action.isChecked():
            self._before.trigger()
        self._before = None

    def _on_clicked(self, is_wanted: bool) -> None:
        if is_wanted:
            self._before = self._action.actionGroup().checkedAction()
            self._action.trigger()
            return
        if self._before is None:
            self._before = self._action.actionGroup().actions()[0]
        self.restore()


def _checked_weight(value: object, name: str) -> float:
    weight = checked_number(value, name)
    if weight <= 0:
        raise DocumentError(name, described(weight), "a positive number")
    return weight
