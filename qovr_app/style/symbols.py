"""The paper's symbols as rich text."""

from __future__ import annotations

from qovr_app.style.theme import Rgb


def symbol_html(letter: str, index: str) -> str:
    """Return a symbol with its index set low, as rich text."""
    return f"<i>{letter}</i><sub>{index}</sub>"


def coloured(html: str, colour: Rgb) -> str:
    """Return rich text in a colour."""
    return f'<span style="color:#{"".join(f"{part:02x}" for part in colour)}">{html}</span>'
