"""The number of samples along one parameter."""

from __future__ import annotations

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QWidget

from qovr_app.widgets.number_field import NumberField
from qovr_core.checks import SAMPLES_RANGE, checked_samples


def _check(value: object, name: str) -> float:
    count = int(value) if isinstance(value, float) and value.is_integer() else value
    return float(checked_samples(count, name))


class SamplesField(NumberField):
    """A count of samples; what is valid is reported at once, what is not stays and is marked.

    Signals
    -------
    count_edited : the new count and its gesture, 0 for none
    """

    count_edited = Signal(int, int)

    def __init__(self, parameter: str, parent: QWidget | None = None) -> None:
        super().__init__(f"samples along {parameter}", _check, lambda _count: 1.0, parent, least=1.0)
        fewest, most = SAMPLES_RANGE
        self.setObjectName(f"surface.samples_{parameter}")
        self.setAccessibleName(f"Samples along {parameter}")
        self.set_tip(f"How many points of the surface are computed along {parameter}, from {fewest} to {most}.")
        self.set_width(self.fontMetrics().horizontalAdvance("00000") + 16)
        self.value_edited.connect(lambda value, gesture: self.count_edited.emit(int(value), gesture))

    @property
    def count(self) -> int:
        """The count that was shown or reported last."""
        return int(self.value)

    def show_count(self, count: int) -> None:
        """Show a count."""
        self.show_value(float(count))
