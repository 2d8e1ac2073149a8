"""The paper's symbols as rich text."""

from __future__ import annotations


def symbol_html(letter: str, index: str) -> str:
    """Return a symbol with its index set low, as rich text."""
    return f"<i>{letter}</i><sub>{index}</sub>"
