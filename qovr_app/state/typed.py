"""Numbers as they are typed or pasted: with a point or a comma, one by one or in blocks of a spreadsheet."""

from __future__ import annotations

import re

from qovr_core import DocumentError
from qovr_core.number_texts import MINUS, MORE_DIGITS

_NUMBER = re.compile(r"[+-]?(\d+([.,]\d*)?|[.,]\d+)([eE][+-]?\d+)?", re.ASCII)
_LONGEST_QUOTE = 24


def typed_number(text: str) -> float | str | None:
    """Return the number that a text says with a point or a comma; the text itself where it says none.

    An empty text gives None. What comes back is for a check of ``qovr_core.checks``, which refuses it in words.
    """
    text = text.strip().replace(MINUS, "-")
    if not text:
        return None
    if not _NUMBER.fullmatch(text):
        return text if len(text) <= _LONGEST_QUOTE else text[:_LONGEST_QUOTE] + MORE_DIGITS
    return float(text.replace(",", "."))


def is_block(text: str) -> bool:
    """Return whether a text holds more than one cell."""
    return "\t" in text.strip("\r\n") or len(text.strip("\r\n").splitlines()) > 1


def typed_block(text: str) -> list[list[float]]:
    """Return the rows of numbers in a spreadsheet's text.

    Raises
    ------
    DocumentError : there is no cell, a cell holds no number, or the rows are of different lengths; it names the place
    """
    rows: list[list[float]] = []
    for r, line in enumerate(text.strip("\r\n").splitlines(), start=1):
        cells = [
            _cell(cell, f"row {r}, column {c} of what is pasted") for c, cell in enumerate(line.split("\t"), start=1)
        ]
        if rows and len(cells) != len(rows[0]):
            raise DocumentError(
                f"row {r} of what is pasted", f"{len(cells)} cells long", f"{len(rows[0])} cells, as the rows above"
            )
        rows.append(cells)
    if not rows:
        raise DocumentError("what is pasted", "empty", "a block of numbers")
    return rows


def _cell(text: str, place: str) -> float:
    value = typed_number(text)
    if not isinstance(value, float):
        found = "empty" if value is None else repr(value)
        raise DocumentError(place, found, "a number, as 0.35 or 0,35")
    return value
