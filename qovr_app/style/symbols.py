"""The paper's symbols as rich text."""

from __future__ import annotations

import html
import re

from qovr_app.style.theme import Rgb


def symbol_html(letter: str, index: str) -> str:
    """Return a symbol with its index set low, as rich text."""
    return f"<i>{letter}</i><sub>{index}</sub>"


def coloured(rich: str, colour: Rgb) -> str:
    """Return rich text in a colour."""
    return f'<span style="color:#{"".join(f"{part:02x}" for part in colour)}">{rich}</span>'


_LETTER_AND_INDEX = r"\b([rstuvCK])_(ip|\d+)\b(?!\.\w)"
"""Not the beginning of a file's name."""

_PLAIN_SYMBOL = re.compile(_LETTER_AND_INDEX)
_LOW_SIGNS = str.maketrans("0123456789ip", "₀₁₂₃₄₅₆₇₈₉ᵢₚ")


def symbols_in_plain(text: str) -> str:
    """Return a sentence whose symbols have low indices where text has no format: in menus, in the message line.

    Examples
    --------
    >>> symbols_in_plain("Set r_ip of C_0..C_12")
    'Set rᵢₚ of C₀..C₁₂'
    """
    return _PLAIN_SYMBOL.sub(lambda found: found[1] + found[2].translate(_LOW_SIGNS), text)


_SYMBOL = re.compile(rf"{_LETTER_AND_INDEX}|\bP (\d+),(\d+)")
"""A symbol as messages write it: r_ip, C_4, P 2,3."""


def sentence_html(text: str) -> str:
    """Return a sentence of plain text as rich text, its symbols with indices set low.

    Examples
    --------
    >>> sentence_html("r_ip of C_4 is <0>; P 2,3 is not.")
    '<i>r</i><sub>ip</sub> of <i>C</i><sub>4</sub> is &lt;0&gt;; <i>P</i><sub>2,3</sub> is not.'
    """
    return _SYMBOL.sub(_set_low, html.escape(text, quote=False))


def _set_low(found: re.Match[str]) -> str:
    letter, index, i, j = found.groups()
    return symbol_html(letter, index) if letter else symbol_html("P", f"{i},{j}")
