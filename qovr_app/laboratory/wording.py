"""Numbers of the laboratory as people read them."""

from __future__ import annotations

from collections.abc import Sequence

from qovr_app.state.number_texts import number_text

_DIGITS = 4


def value_text(value: float) -> str:
    """Return a number with four digits and a true minus sign."""
    return number_text(float(f"{value:.{_DIGITS}g}")).replace("-", "\N{MINUS SIGN}")


def percent_text(part: float) -> str:
    """Return a part of a whole in percent, with three digits."""
    return f"{float(f'{100 * part:.3g}'):g} %"


def motion_text(motion: float) -> str:
    """Return how far something moves; only what is exactly 0 stays."""
    return value_text(motion) if motion else "stays"


def list_text(values: Sequence[float]) -> str:
    """Return numbers in a row."""
    return ", ".join(map(value_text, values))
