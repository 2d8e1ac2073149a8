"""What the hand wants of several fields at once, as values."""

from __future__ import annotations

from dataclasses import dataclass

from qovr_app.state.intents import Intent
from qovr_core.edits import Place


@dataclass(frozen=True)
class ValuesShifted(Intent):
    """Numbers change by the same amount, and with them those that are linked.

    Parameters
    ----------
    amount : counted from where the numbers stood when the gesture began
    """

    places: tuple[Place, ...]
    amount: float
    gesture: int = 0
