"""Numbers as they are typed or pasted: with a point or a comma, one by one or in blocks of a spreadsheet."""

from __future__ import annotations

import re
from decimal import Context, Decimal, DecimalException, DivisionByZero, InvalidOperation, localcontext

from qovr_core import DocumentError
from qovr_core.number_texts import MINUS, MORE_DIGITS

_NUMBER = re.compile(r"[+-]?(\d+([.,]\d*)?|[.,]\d+)([eE][+-]?\d+)?", re.ASCII)
_TERM = re.compile(r"([-+*/]?)([+-]?(?:\d+(?:[.,]\d*)?|[.,]\d+)(?:[eE][+-]?\d+)?)", re.ASCII)
_CALCULATION = re.compile(rf"[+*/]?(?:{_NUMBER.pattern})(?:[-+*/](?:{_NUMBER.pattern}))*", re.ASCII)
_SPACED = re.compile(r"\s*([-+*/])\s*")
_LONGEST_QUOTE = 24

_DIGITS = 40
"""Decimals are carried this far, so that what becomes a float is rounded once."""


def typed_number(text: str) -> float | str | None:
    """Return the number that a text says with a point or a comma; the text itself where it says none.

    An empty text gives None. What comes back is for a check of ``qovr_core.checks``, which refuses it in words.
    """
    text = text.strip().replace(MINUS, "-")
    if not text:
        return None
    if not _NUMBER.fullmatch(text):
        return _quoted(text)
    return float(text.replace(",", "."))


def _quoted(text: str) -> str:
    return text if len(text) <= _LONGEST_QUOTE else text[:_LONGEST_QUOTE] + MORE_DIGITS


def typed_value(text: str, present: float) -> float | str | None:
    """Return the number that a text makes of a field's present one; otherwise as ``typed_number``.

    Sums and products are worked out, and what begins with an operation goes on from the present number. A minus is a
    sign there: ``-0.1`` is a number, ``+-0.1`` takes 0.1 away.

    Examples
    --------
    >>> [typed_value(text, 0.7) for text in ("0.5", "-0.1", "1/3", "+0.1", "+-0.1", "*2", "/2")]
    [0.5, -0.1, 0.3333333333333333, 0.8, 0.6, 1.4, 0.35]
    """
    typed = _SPACED.sub(r"\1", text.strip().replace(MINUS, "-"))
    if not _CALCULATION.fullmatch(typed) or (_NUMBER.fullmatch(typed) and typed[0] != "+"):
        return typed_number(text)
    terms = [(operation or "+", number.replace(",", ".")) for operation, number in _TERM.findall(typed)]
    total, product = Decimal(0), Decimal(repr(present)) if typed[0] in "+*/" else Decimal(0)
    try:
        # as decimals, in which 0.7 + 0.1 is 0.8
        with localcontext(Context(prec=_DIGITS, traps=[InvalidOperation, DivisionByZero])):
            for operation, number in terms:
                if operation in "*/":
                    product = product * Decimal(number) if operation == "*" else product / Decimal(number)
                else:
                    total, product = total + product, Decimal(number) * (-1 if operation == "-" else 1)
            return float(total + product)
    except DecimalException:
        return _quoted(text.strip())


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
