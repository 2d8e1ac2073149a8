"""What is worked out in a field: sums and products, and what goes on from the number that stands there."""

from __future__ import annotations

import re
from decimal import Context, Decimal, DecimalException, DivisionByZero, InvalidOperation, localcontext

_NUMBER = r"[+-]?(?:\d+(?:[.,]\d*)?|[.,]\d+)(?:[eE][+-]?\d+)?"
_TERM = re.compile(rf"([-+*/]?)({_NUMBER})", re.ASCII)
_CALCULATION = re.compile(rf"[+*/]{_NUMBER}(?:[-+*/]{_NUMBER})*|{_NUMBER}(?:[-+*/]{_NUMBER})+", re.ASCII)
_SPACED = re.compile(r"\s*([-+*/])\s*")
_LONGEST = 200
"""Nobody types a longer calculation into a field."""

_DIGITS = 40
"""Decimals are carried this far, so that what becomes a float is rounded once."""


def worked_out(text: str, present: float) -> float | None:
    """Return the number that a calculation makes of the present one; None where the text is no calculation.

    What begins with an operation goes on from the present number. A minus is a sign there: ``-0.1`` is a number and no
    calculation, ``+-0.1`` takes 0.1 away.

    Parameters
    ----------
    text : with the hyphen of a keyboard for every minus

    Examples
    --------
    >>> [worked_out(text, 0.7) for text in ("1/3", "+0.1", "+-0.1", "*2", "/2", "-0.1")]
    [0.3333333333333333, 0.8, 0.6, 1.4, 0.35, None]
    """
    typed = _SPACED.sub(r"\1", text.strip()) if len(text) <= _LONGEST else ""
    if not _CALCULATION.fullmatch(typed):
        return None
    total, product = Decimal(0), Decimal(repr(present)) if typed[0] in "+*/" else Decimal(0)
    try:
        # as decimals, in which 0.7 + 0.1 is 0.8
        with localcontext(Context(prec=_DIGITS, traps=[InvalidOperation, DivisionByZero])):
            for operation, digits in _TERM.findall(typed):
                number = Decimal(digits.replace(",", "."))
                if operation == "*":
                    product *= number
                elif operation == "/":
                    product /= number
                else:
                    total, product = total + product, -number if operation == "-" else number
            return float(total + product)
    except DecimalException:
        return None
