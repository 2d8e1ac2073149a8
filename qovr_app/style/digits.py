"""How many digits of a number are shown where it is only read; one choice for all windows, like the theme."""

from __future__ import annotations

from PySide6.QtWidgets import QApplication

USUAL_DIGITS = 6
"""As many as a hand means, and as a narrow column has room for."""

ALL_DIGITS = 17
"""So many always tell two doubles apart."""

_in_force = [USUAL_DIGITS]


def digits_in_force() -> int:
    """Return how many significant digits are shown at most."""
    return _in_force[0]


def set_digits(digits: int) -> None:
    """Show so many significant digits in all windows, at once."""
    if digits != _in_force[0]:
        _in_force[0] = digits
        for widget in QApplication.allWidgets():
            widget.update()
