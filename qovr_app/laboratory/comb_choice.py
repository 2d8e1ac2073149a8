"""Whether a curve has its comb, and how long the teeth of combs are: here and in the view alike."""

from __future__ import annotations

from math import log10

from PySide6.QtCore import QSignalBlocker, Qt, Signal
from PySide6.QtWidgets import QCheckBox, QHBoxLayout, QSlider, QWidget

from qovr_app.style.spacing import SPACE
from qovr_app.widgets.parts import named
from qovr_app.widgets.wheel import guard_from_wheels

_STEPS_TENFOLD = 20
_REACH = 30
"""So many steps of the slider make teeth ten times as long, and so many it goes both ways: from a thirtieth to thirty
times their first length."""

_WIDTH = 70


class CombChoice(QWidget):
    """A check mark and a slider.

    Signals
    -------
    toggled : whether the comb is wanted
    scaled : how many times as long as at first teeth are wanted
    """

    toggled = Signal(bool)
    scaled = Signal(float)

    def __init__(self, name: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._check = named(QCheckBox("Comb", self), f"{name}.comb")
        self._check.setToolTip(
            "Teeth as long as the curve is bent, and the sum of their changes: the fairer the curve, the less"
        )
        self._slider = named(QSlider(Qt.Orientation.Horizontal, self), f"{name}.comb_scale", "Length of the teeth")
        self._slider.setToolTip("Length of the teeth, here and of combs in the view (View, Show)")
        self._slider.setRange(-_REACH, _REACH)
        self._slider.setFixedWidth(_WIDTH)
        guard_from_wheels(self._slider)
        layout = QHBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(SPACE)
        layout.addWidget(self._check)
        layout.addWidget(self._slider)
        self._check.toggled.connect(self.toggled)
        self._slider.valueChanged.connect(lambda step: self.scaled.emit(10 ** (step / _STEPS_TENFOLD)))

    @property
    def is_wanted(self) -> bool:
        """Whether the comb is wanted."""
        return self._check.isChecked()

    def show_scale(self, scale: float) -> None:
        """Show how long the teeth are."""
        with QSignalBlocker(self._slider):
            self._slider.setValue(round(_STEPS_TENFOLD * log10(scale)))
