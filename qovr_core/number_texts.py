"""Numbers as people read them: one rule for each purpose, and a true minus sign wherever a text is only looked at."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence

MINUS = "\N{MINUS SIGN}"
MORE_DIGITS = "…"
"""Stands for digits that are left out."""

_MOST_DIGITS = 16
_LARGEST_WHOLE = 1e5
"""Short texts of what is smaller are whole from 100 on; what is larger has an exponent."""

_SLACK = 1e-9
"""Part of a step by which a tick may miss a decimal fraction: rounding."""

_LONGEST_FIXED, _SMALLEST_FIXED = 1e6, 1e-5
"""Ticks from this size on, or closer together than that, are written with exponents."""

_MOST_DECIMALS = 7
_SUPERSCRIPTS = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


def number_text(value: float) -> str:
    """Return the shortest text that reads back as the very same number; it may be typed, so its minus is a hyphen."""
    return _short_exponent(repr(float(value)).removesuffix(".0"))


def fitted_text(value: float, fits: Callable[[str], bool]) -> str:
    """Return a number's text with as many digits as fit; an ellipsis stands for those that do not.

    Magnitude and sign are never cut off: where the whole part does not fit, the text gets an exponent.
    """
    exact = number_text(value)
    if fits(exact):
        return exact
    for digits in range(_MOST_DIGITS, 0, -1):
        mantissa, _, exponent = f"{value:.{digits}g}".partition("e")
        power = f"e{int(exponent)}" if exponent else ""
        if fits(text := f"{mantissa}{MORE_DIGITS}{power}"):
            return text
    return text


def block_text(rows: Sequence[Sequence[float | str]]) -> str:
    """Return rows of numbers and words as a spreadsheet takes them: tabs, line ends, full precision."""
    return "".join("\t".join(map(_cell_text, row)) + "\n" for row in rows)


def _cell_text(cell: float | str) -> str:
    return " ".join(cell.split()) if isinstance(cell, str) else number_text(cell)


def rounded_text(value: float, digits: int) -> str:
    """Return a number rounded to so many digits, written as short as may be: 123460, 0.5, 1.2e-7."""
    return true_minus(number_text(float(f"{value:.{digits}g}")))


def significant_text(value: float, digits: int) -> str:
    """Return a number with so many digits, and an exponent where it has more before the point: 1.2346e5."""
    return true_minus(f"{value:.{digits}g}".replace("e+0", "e").replace("e-0", "e-"))


def fixed_text(value: float, decimals: int) -> str:
    """Return a number with so many decimals, so that numbers below one another are aligned."""
    return true_minus(f"{value:.{decimals}f}")


def short_text(value: float) -> str:
    """Return a number for a narrow cell: whole from 100 on, else two digits, but one before an exponent."""
    text = f"{value:.0f}" if 100 <= value < _LARGEST_WHOLE else f"{value:.2g}"
    return true_minus(_short_exponent(f"{value:.0e}" if "e" in text else text))


def percent_text(part: float) -> str:
    """Return a part of a whole in percent, with three digits."""
    return f"{float(f'{100 * part:.3g}'):g} %"


def power_text(power: int) -> str:
    """Return a power of ten as a factor: ×10⁻³."""
    return f"×10{str(power).translate(_SUPERSCRIPTS)}"


def tick_texts(positions: Iterable[float]) -> list[str]:
    """Return the texts of ticks at even steps, with as many decimals as tell neighbours apart."""
    values = [float(position) + 0.0 for position in positions]  # no tick is at minus zero
    if not values:
        return []
    largest = max(map(abs, values))
    step = values[1] - values[0] if len(values) > 1 else 0.0
    step = step or largest or 1.0  # far from 0, neighbours can be one and the same number
    if largest >= _LONGEST_FIXED or step < _SMALLEST_FIXED:
        digits = max(0, math.floor(math.log10(largest or step)) - math.floor(math.log10(step) + _SLACK))
        return [true_minus(f"{value:.{digits}e}") for value in values]
    exact = (d for d in range(_MOST_DECIMALS) if abs(round(step, d) - step) <= _SLACK * step)
    decimals = next(exact, _MOST_DECIMALS)  # far from 0, the step itself is rounded
    return [fixed_text(value, decimals) for value in values]


def true_minus(text: str) -> str:
    """Return a text with every hyphen a minus sign."""
    return text.replace("-", MINUS)


def _short_exponent(text: str) -> str:
    """Return a text without the plus sign and the leading zero of its exponent."""
    return text.replace("e+0", "e").replace("e+", "e").replace("e-0", "e-")
