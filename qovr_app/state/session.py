"""What was asked for in a window: what a report of a fault says, and what can be replayed."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterator, Sized

from qovr_app.state.intents import Intent
from qovr_core import Document

LONGEST = 1000
"""Intents; as much as anybody reads of what led to a fault."""

MOST_ENTRIES = 500_000
"""Points and numbers that all intents may name together, which takes some 50 MB; to move the largest net once names
80,000."""


class Session:
    """The intents that came last, the latest of them last; of a drag, where it went last."""

    def __init__(self) -> None:
        self._intents: deque[Intent] = deque()
        self._entries = 0

    def __iter__(self) -> Iterator[Intent]:
        return iter(self._intents)

    def note(self, intent: Intent) -> None:
        """Take one more, and drop the oldest where there are too many."""
        gesture = getattr(intent, "gesture", 0)
        last = self._intents[-1] if self._intents else None
        if gesture and type(last) is type(intent) and getattr(last, "gesture", 0) == gesture:
            self._entries -= _entries(self._intents.pop())
        self._intents.append(intent)
        self._entries += _entries(intent)
        while len(self._intents) > LONGEST or (self._entries > MOST_ENTRIES and len(self._intents) > 1):
            self._entries -= _entries(self._intents.popleft())


def _entries(intent: Intent) -> int:
    """Return how many points and numbers an intent names."""
    return sum(map(_length, vars(intent).values()))


def _length(value: object) -> int:
    if isinstance(value, Document):
        return value.control_points.size
    return len(value) if isinstance(value, Sized) else 1
