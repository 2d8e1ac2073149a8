"""Numbers of the laboratory as people read them."""

from __future__ import annotations

from collections.abc import Sequence

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
