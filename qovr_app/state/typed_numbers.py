"""Numbers as they are typed: the one place that says which texts are numbers, for fields, dialogs and pasted cells."""

from __future__ import annotations

import re
from collections.abc import Callable

from qovr_app.state.calculation import worked_out
from qovr_core import DocumentError
from qovr_core.checks import described
from qovr_core.number_texts import MINUS, MORE_DIGITS

_NUMBER = re.compile(r"[+-]?(\d+([.,]\d*)?|[.,]\d+)([eE][+-]?\d+)?", re.ASCII)
_GROUPED = re.compile(r"[+-]?[0-9]{1,3}(?:[.,'’_\s][0-9]{3})+(?:[.,][0-9]*)?")
_LONGEST_QUOTE = 24

_MINUSES = str.maketrans(dict.fromkeys((MINUS, "\N{HYPHEN}", "\N{NON-BREAKING HYPHEN}", "\N{EN DASH}"), "-"))
"""What stands for a minus in texts that people set well, beside the hyphen of a keyboard."""

_UNSEEN = "\N{ZERO WIDTH SPACE}\N{ZERO WIDTH NO-BREAK SPACE}\N{WORD JOINER}\N{LEFT-TO-RIGHT MARK}\N{RIGHT-TO-LEFT MARK}"
"""Characters without width that web pages and spreadsheets leave around a number; Python takes none for a space."""


def typed_number(text: str) -> float | str | None:
    """Return the number that a text says with a point or a comma; the text itself where it says none.

    Spaces of every width around it do not count. An empty text gives None. What comes back is for a check of
    ``qovr_core.checks``, which refuses it in words.
    """
    text = trimmed(text).translate(_MINUSES)
    if not text:
        return None
    if not _NUMBER.fullmatch(text):
        return text if len(text) <= _LONGEST_QUOTE else text[:_LONGEST_QUOTE] + MORE_DIGITS
    return float(text.replace(",", "."))


def typed_value(text: str, name: str, check: Callable[[object, str], float], present: float | None = None) -> float:
    """Return the number that a text says, as a check of ``name`` agrees to.

    Where there is a ``present`` number, a text may also be a calculation, which may go on from it.

    Raises
    ------
    QovrError : it says none, or not one that may be; a group separator, or a digit of another script, is called that
    """
    calculated = worked_out(trimmed(text).translate(_MINUSES), present) if present is not None else None
    value = typed_number(text) if calculated is None else calculated
    if isinstance(value, str) and (expected := _what_is_wrong(trimmed(text))):
        raise DocumentError(name, described(value), expected)
    return check(value, name)


def trimmed(text: str) -> str:
    """Return a text without what is not seen at its ends."""
    before = None
    while text != before:
        before, text = text, text.strip().strip(_UNSEEN)
    return text


def _what_is_wrong(text: str) -> str:
    """Return what would be right instead of a text that nearly is a number; empty where it is far from one."""
    if any(character.isnumeric() and not character.isascii() for character in text):
        return "a number in the digits 0 to 9, as 0.35 or 0,35"
    if _GROUPED.fullmatch(text.translate(_MINUSES)):
        return "a number without group separators, as 1234.5 or 1234,5"
    return ""
