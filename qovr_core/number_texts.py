"""Numbers as people read and step them: one rule for each purpose, and a true minus wherever a text is only read."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from decimal import ROUND_DOWN, Context, Decimal

import numpy as np
import numpy.typing as npt

MINUS = "\N{MINUS SIGN}"
MORE_DIGITS = "…"
"""Stands for digits that are left out."""

_MOST_DIGITS = 16
ALL_DIGITS = 17
"""So many always tell two doubles apart."""

USUAL_DIGITS = 6
"""As many as a hand means, and as a narrow column has room for."""

_LARGEST_WHOLE = 1e5
"""Short texts of what is smaller are whole from 100 on; what is larger has an exponent."""

_SLACK = 1e-9
"""Part of a step by which a tick may miss a decimal fraction: rounding."""

_LONGEST_FIXED, _SMALLEST_FIXED = 1e6, 1e-5
"""Ticks from this size on, or closer together than that, are written with exponents."""

_MOST_DECIMALS = 7

_PLACES_OF_SIZE = 2
"""A step is a power of ten this many decimal places below the size of what it moves in: about a hundredth of it."""

_PLACES_OF_NUMBER = 14
"""And at most this many places below the number's own first digit: fifteen digits always tell doubles apart."""

_SMALLEST_POWER = -323
"""The smallest power of ten that is not 0."""

_DECIMAL_DIGITS = 28
"""Digits that decimal arithmetic keeps by default; a double has 17 at most."""

_PLACES_KEPT = 10
"""Decimal places below the step that a stepped number keeps; what is smaller came from rounding."""

_SUMMED_DIGITS = 15
"""Digits of a sum after the first one of its larger part; a double has no more that count."""

_SUMMING = Context(prec=_DECIMAL_DIGITS)

_EXACT_POWER = 22
"""The largest power of ten that a double holds exactly."""

_SUPERSCRIPTS = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


def number_text(value: float) -> str:
    """Return the shortest text that reads back as the very same number; it may be typed, so its minus is a hyphen."""
    return _short_exponent(repr(float(value)).removesuffix(".0"))


def fitted_text(value: float, fits: Callable[[str], bool], most: int = ALL_DIGITS) -> str:
    """Return a number's text with as many digits as fit, at most so many; an ellipsis stands for those left out.

    Magnitude and sign are never cut off: where the whole part does not fit, the text gets an exponent; where that has
    no room beside one digit, the text says that there is one. The digits shown
    are the number's own, not rounded: others follow them.
    """
    exact = number_text(value)
    if fits(exact) and len(Decimal(repr(value)).normalize().as_tuple().digits) <= most:
        return exact
    for digits in range(min(most, _MOST_DIGITS), 0, -1):
        shown = float(Context(prec=digits, rounding=ROUND_DOWN).create_decimal(repr(value)))
        mantissa, _, exponent = f"{shown:.{digits}g}".partition("e")
        power = f"e{int(exponent)}" if exponent else ""
        if fits(text := f"{mantissa}{MORE_DIGITS}{power}"):
            return text
    return f"{mantissa}{'e' * bool(exponent)}{MORE_DIGITS}"


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


def signed_text(value: float) -> str:
    """Return a difference in few digits, with its sign whatever it is.

    Examples
    --------
    >>> signed_text(0.30000000000000004 - 0.1), signed_text(-0.25)
    ('+0.2', '−0.25')
    """
    text = rounded_text(round(value, 15), USUAL_DIGITS)
    return text if value < 0 else f"+{text}"


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


def natural_step(value: float, scale: float) -> float:
    """Return by how much one step of a key or wheel changes a number: a power of ten that means something beside it.

    Parameters
    ----------
    value : the number; far from 0, the step is no smaller than what its digits show
    scale : the size of what the number moves in, such as the extent of a net; where it is 0, the number's own size

    Examples
    --------
    >>> natural_step(2.5, scale=4), natural_step(2.5, scale=3e-7), natural_step(-4e11, scale=1e-3)
    (0.01, 1e-09, 0.001)
    """
    power = _power(scale or value or 1.0) - _PLACES_OF_SIZE
    if value:
        power = max(power, _power(value) - _PLACES_OF_NUMBER)
    return float(f"1e{max(power, _SMALLEST_POWER)}")


def knot_step(knot: float) -> float:
    """Return the natural step of a number strictly between 0 and 1; one step reaches no end 1e-12 away.

    Examples
    --------
    >>> knot_step(0.5), knot_step(0.04), knot_step(0.999)
    (0.01, 0.001, 0.0001)
    """
    return natural_step(knot, scale=min(1.0, 10 * min(knot, 1 - knot)))


def stepped(value: float, count: float, step: float) -> float:
    """Return a number changed by so many steps, counted in decimals: 0.1 and 0.2 are 0.3.

    Parameters
    ----------
    value : the number, which keeps its own digits as far as they count beside the step
    count : how many steps, negative downwards
    step : a power of ten, as ``natural_step`` gives it
    """
    exact = Decimal(repr(float(value))) + Decimal(repr(float(count))) * Decimal(repr(float(step)))
    places = max(_PLACES_KEPT - _power(step), 0)
    kept = round(exact, places) if exact.adjusted() + places < _DECIMAL_DIGITS else exact
    return float(kept) + 0.0  # never minus zero


def summed(value: float, amount: float) -> float:
    """Return a sum whose decimals are those of its parts: 2 and 1.07 are 3.07, where the binary sum has more digits.

    Examples
    --------
    >>> summed(2.0, 1.07), summed(0.5, -0.499), summed(1e12, 0.25)
    (3.07, 0.001, 1000000000000.25)
    """
    if value == 0 or amount == 0:
        return float(value) + float(amount) + 0.0
    part, other = Decimal(repr(float(value))), Decimal(repr(float(amount)))
    last = max(part.adjusted(), other.adjusted()) - _SUMMED_DIGITS
    return float((part + other).quantize(Decimal((0, (1,), last)), context=_SUMMING)) + 0.0


def summed_all(values: npt.NDArray[np.float64], amounts: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
    """Return ``summed`` of every value, (k,), with its amount, (k,): the very same numbers.

    Where both are whole numbers of one decimal place and have at most 15 digits, these are their decimals, so their
    whole sum is exact, and a division by a power of ten that is exact too rounds as reading a text does.
    """
    largest = max(np.abs(values).max(initial=0.0), np.abs(amounts).max(initial=0.0))
    places = _SUMMED_DIGITS - 1 - math.floor(math.log10(largest)) if 0 < largest < math.inf else 0
    power = 10.0 ** min(max(places, 0), _EXACT_POWER)
    whole, added = np.rint(values * power), np.rint(amounts * power)
    result: npt.NDArray[np.float64] = (whole + added) / power + 0.0
    is_exact = (whole / power == values) & (added / power == amounts)
    is_exact &= np.maximum(np.abs(whole), np.abs(added)) < 10.0**_SUMMED_DIGITS
    for k in np.flatnonzero(~is_exact).tolist():
        result[k] = summed(values[k], amounts[k])
    return result


def true_minus(text: str) -> str:
    """Return a text with every hyphen a minus sign."""
    return text.replace("-", MINUS)


def _short_exponent(text: str) -> str:
    """Return a text without the plus sign and the leading zero of its exponent."""
    return text.replace("e+0", "e").replace("e+", "e").replace("e-0", "e-")


def _power(value: float) -> int:
    """Return the power of ten of a number's first digit; what misses a power by rounding is that power."""
    return Decimal(f"{value:.12g}").adjusted()
