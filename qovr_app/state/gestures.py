"""What all drags have in common: a number, by which all the edits of one become one undo step, and how fine is fine."""

from __future__ import annotations

import itertools

FINE = 0.1
"""Part of the mouse's way that what is dragged goes while Shift is held."""

_NUMBERS = itertools.count(1)


def next_gesture() -> int:
    """Return a number that no drag of this process had before."""
    return next(_NUMBERS)
