"""How long work tells how far it is."""

from __future__ import annotations

from collections.abc import Callable

Progress = Callable[[float], None]
"""Called with the part done, 0 to 1; whatever it raises ends the work, which then leaves nothing behind."""


def silent(_part: float) -> None:
    """Tell nobody."""
