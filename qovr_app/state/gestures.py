"""Numbers for drags: all the edits of one drag carry one number, and become one undo step."""

from __future__ import annotations

import itertools

_NUMBERS = itertools.count(1)


def next_gesture() -> int:
    """Return a number that no drag of this process had before."""
    return next(_NUMBERS)
