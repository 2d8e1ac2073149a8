"""Numbers and changes of the laboratory as people read them."""

from __future__ import annotations

from collections.abc import Sequence

from qovr_app.state.names import AXES, label
from qovr_core.laboratory.influence import Change, KnotMove
from qovr_core.number_texts import rounded_text

_DIGITS = 4


def value_text(value: float) -> str:
    """Return a number as the panels write it."""
    return rounded_text(value, _DIGITS)


def motion_text(motion: float) -> str:
    """Return how far something moves; only what is exactly 0 stays."""
    return value_text(motion) if motion else "stays"


def list_text(values: Sequence[float]) -> str:
    """Return numbers in a row."""
    return ", ".join(map(value_text, values))


def change_text(change: Change) -> str:
    """Return a change in one line of plain text."""
    if isinstance(change, KnotMove):
        return f"{label(change.place)} by {value_text(change.amount)}"
    axis = next(axis for axis in range(3) if change.vector[axis])
    return f"P {change.i},{change.j} along {AXES[axis]} by {value_text(change.vector[axis])}"
