"""Checks of single values, shared by everything that makes a document."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any, TypeGuard

import numpy as np

from qovr_core.arrays import Array
from qovr_core.errors import LONGEST_QUOTE, DocumentError, one_line

LARGEST_MAGNITUDE = 1e12
"""Beyond this a coordinate is taken for a mistake, not for a shape."""

SAMPLES_RANGE = (2, 4096)
"""Fewest and most samples along one parameter."""


class Verbatim(str):
    """What stands in a file where a value belongs and is none, such as ``#DIV/0!``: shown without quotes."""

    __slots__ = ()

    def __repr__(self) -> str:
        return str(self)


def _is_real(value: object) -> TypeGuard[float]:
    return isinstance(value, (int, float, np.integer, np.floating)) and not isinstance(value, bool)


def plain_numbers(values: Sequence[object]) -> Array | None:
    """Return plain numbers as an array, all at once; None where any is none, so that they are to be checked singly."""
    if not {*map(type, values)} <= {float, int}:
        return None
    try:
        return np.array(values, dtype=np.float64)
    except OverflowError:
        return None


def described(value: object) -> str:
    """Return a short one-line picture of any value, for an error's text."""
    if isinstance(value, dict):
        return f"an object of {len(value)} entries"
    if isinstance(value, (list, tuple)):
        return f"a list of {len(value)} entries"
    if value is None:
        return "empty"
    if isinstance(value, np.ndarray) and value.size != 1:
        return f"an array of {value.size} entries"
    try:
        text = repr(value.item() if hasattr(value, "item") else value)
    except ValueError:  # an integer with more digits than Python agrees to print
        return "an absurdly long number"
    return one_line(text, LONGEST_QUOTE)


def entries(value: object, place: str, count: int | None = None, expected: str = "a list") -> Sequence[Any]:
    """Return a list of entries, of exactly ``count`` where that is given, or raise DocumentError."""
    expected = expected if count is None else f"a list of {count} entries"
    if isinstance(value, np.ndarray):
        value = list(value)
    if isinstance(value, (str, bytes, dict)) or not isinstance(value, Iterable):
        raise DocumentError(place, described(value), expected)
    result = list(value)
    if count is not None and len(result) != count:
        raise DocumentError(place, described(result), expected)
    return result


def checked_number(value: object, place: str) -> float:
    """Return a coordinate as float; a bool, a text, a non-finite or an absurd number raises DocumentError."""
    expected = f"a finite number of magnitude at most {LARGEST_MAGNITUDE:g}"
    if not (_is_real(value) and abs(value) <= LARGEST_MAGNITUDE):
        raise DocumentError(place, described(value), expected)
    return float(value)


def checked_knot(value: object, place: str) -> float:
    """Return an internal knot as float; anything not strictly between 0 and 1 raises DocumentError."""
    expected = "a number strictly between 0 and 1"
    if not (_is_real(value) and 0 < value < 1):
        raise DocumentError(place, described(value), expected)
    return float(value)


def checked_samples(value: object, place: str) -> int:
    """Return a sample count as int; anything but a whole number in SAMPLES_RANGE raises DocumentError."""
    fewest, most = SAMPLES_RANGE
    is_whole = isinstance(value, (int, np.integer)) and not isinstance(value, bool)
    if not (is_whole and _is_real(value) and fewest <= value <= most):
        raise DocumentError(place, described(value), f"a whole number from {fewest} to {most}")
    return int(value)


def checked_choice(value: object, place: str, choices: Iterable[str]) -> str:
    """Return one of the choices; anything else raises DocumentError."""
    choices = list(choices)
    if not isinstance(value, str) or value not in choices:
        raise DocumentError(place, described(value), "one of " + ", ".join(choices))
    return value
