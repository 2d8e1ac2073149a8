"""How many digits of a number are shown where it is only read; one choice for all windows, like the theme."""

from __future__ import annotations

from PySide6.QtWidgets import QApplication

from qovr_core.number_texts import USUAL_DIGITS

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
