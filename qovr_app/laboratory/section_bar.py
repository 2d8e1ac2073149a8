"""The controls of the section: which plane, and where it stands."""

from __future__ import annotations

from math import floor, log10

from PySide6.QtCore import QSignalBlocker, Qt, Signal
from PySide6.QtWidgets import QCheckBox, QComboBox, QSlider, QWidget

from qovr_app.state.display import SectionChoice
from qovr_app.state.names import AXES
from qovr_app.style.spacing import SPACE
from qovr_app.widgets.flow import Flow, kept_together
from qovr_app.widgets.number_field import NumberField
from qovr_app.widgets.parts import CompactButton, named
from qovr_app.widgets.wheel import guard_from_wheels
from qovr_core.checks import checked_number
from qovr_core.document import NetIndex
from qovr_core.number_texts import natural_step

_NAME = "laboratory.section"
_STEPS = 1000
_FIELD_WIDTH, _SLIDER_WIDTH = 80, 120
_THROUGH = len(AXES)


class SectionBar(QWidget):
    """Choices of a plane.

    Signals
    -------
    chosen : the SectionChoice that is wanted
    two_points_wanted : the plane is to stand on the two points that are selected
    scales_linked : whether both directions of the plane are drawn at one scale
    copy_requested : the button
    refused : why what is typed is no place; empty when that is outdated
    """

    chosen = Signal(object)
    two_points_wanted = Signal()
    scales_linked = Signal(bool)
    copy_requested = Signal()
    refused = Signal(str)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._choice = SectionChoice()
        self._ends = (0.0, 1.0)
        self._plane = named(QComboBox(self), f"{_NAME}.plane", "Cutting plane")
        self._plane.addItems([*(f"{axis} =" for axis in AXES), "through 2 points"])
        self._plane.setToolTip("The plane on which a coordinate is constant, or the upright one through two points")
        self._place = named(
            NumberField(
                "the section's place", checked_number, lambda _value: natural_step(self._ends[1], self._size), self
            ),
            f"{_NAME}.place",
        )
        self._place.setAccessibleName("Place of the cutting plane")
        self._place.set_width(_FIELD_WIDTH)
        self._slider = named(QSlider(Qt.Orientation.Horizontal, self), f"{_NAME}.slider", "Place of the cutting plane")
        self._slider.setRange(0, _STEPS)
        self._slider.setFixedWidth(_SLIDER_WIDTH)
        self._equal = named(QCheckBox("Equal scales", self), f"{_NAME}.equal_scales")
        self._equal.setToolTip("Draw both directions of the plane at one scale")
        self._copy = CompactButton(
            "Copy Points", f"{_NAME}.copy", "Copy all points of the section with every digit", self
        )
        guard_from_wheels(self._plane, self._slider)
        layout = Flow(self, 2 * SPACE)
        layout.setContentsMargins(0, 0, 0, 0)
        where = kept_together(self, SPACE, self._plane, self._place)
        for widget in (where, self._slider, self._equal, self._copy):
            layout.addWidget(widget)
        self._plane.activated.connect(self._on_plane)
        self._place.value_edited.connect(lambda value, _gesture: self.chosen.emit(SectionChoice(self._axis, value)))
        self._place.refused.connect(lambda reason: self.refused.emit(reason and f"{reason}."))
        self._slider.valueChanged.connect(self._on_slid)
        self._equal.toggled.connect(self.scales_linked)
        self._copy.clicked.connect(lambda _checked: self.copy_requested.emit())

    def show_choice(self, choice: SectionChoice, offset: float, ends: tuple[float, float]) -> None:
        """Show a choice, where its plane stands, and between which places it meets the surface."""
        self._choice, self._ends = choice, ends
        with QSignalBlocker(self._plane), QSignalBlocker(self._slider):
            self._plane.setCurrentIndex(choice.axis if choice.through is None else _THROUGH)
            part = (offset - ends[0]) / self._size
            self._slider.setValue(round(min(max(part, 0.0), 1.0) * _STEPS))
        self._place.show_value(_round(offset, self._size) if choice.place is None else offset)
        for control in (self._place, self._slider):
            control.setVisible(choice.through is None)

    def set_copyable(self, is_copyable: bool) -> None:
        """Say whether there are points to copy."""
        self._copy.setEnabled(is_copyable)

    @property
    def _axis(self) -> int:
        return min(self._plane.currentIndex(), _THROUGH - 1)

    @property
    def _size(self) -> float:
        return (self._ends[1] - self._ends[0]) or 1.0

    def _on_plane(self, index: int) -> None:
        if index == _THROUGH:
            self.two_points_wanted.emit()
        else:
            self.chosen.emit(SectionChoice(index))

    def _on_slid(self, step: int) -> None:
        self.chosen.emit(SectionChoice(self._axis, _round(self._ends[0] + self._size * step / _STEPS, self._size)))


def _round(place: float, size: float) -> float:
    """Return a place without digits that no slider of this size means."""
    return round(place, max(0, -floor(log10(size / _STEPS))))


def pair_of(points: frozenset[NetIndex]) -> tuple[NetIndex, NetIndex] | None:
    """Return two selected points in the net's order; None where there are not two."""
    if len(points) != 2:
        return None
    first, second = sorted(points)
    return first, second
