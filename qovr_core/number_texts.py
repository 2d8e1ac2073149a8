"""Numbers as people read them: one rule for each purpose, and a true minus sign wherever a text is only looked at."""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from decimal import Decimal

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
_FAR = 10_000
"""Ticks this many steps from 0 have the digits that they share set apart."""

_PLAIN_POWERS = range(-4, 6)
"""Powers of ten of ticks that are written in full."""

_LONGEST_OFFSET, _SMALLEST_OFFSET = 12, -6
"""Powers of ten beyond which the digits that ticks share are written with an exponent."""

_GROUPED = str.maketrans(",", "\N{NO-BREAK SPACE}")
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


def block_text(rows: Sequence[Sequence[float]]) -> str:
    """Return rows of numbers as a spreadsheet takes them: tabs, line ends, full precision."""
    return "".join("\t".join(map(number_text, row)) + "\n" for row in rows)


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


@dataclass(frozen=True)
class TickLabels:
    """The texts of ticks, and what they have in common.

    Parameters
    ----------
    texts : one a tick
    note : the factor of all, and the number that is added to all, as "×10⁻⁶ + 500 000"; empty where there is neither
    """

    texts: list[str]
    note: str = ""


def tick_labels(positions: Iterable[float], plain_powers: range = _PLAIN_POWERS) -> TickLabels:
    """Return short labels of ticks at even steps that tell neighbours apart, however far from 0 or small they are.

    Parameters
    ----------
    positions : each the double that is nearest to its decimal fraction
    plain_powers : the powers of ten of numbers that are written in full

    Examples
    --------
    >>> tick_labels([512345.6, 512345.62])
    TickLabels(texts=['0.00', '0.02'], note='+ 512\xa0345.6')
    >>> tick_labels([0.0, 2e-6, 4e-6])
    TickLabels(texts=['0', '2', '4'], note='×10⁻⁶')
    """
    values = [Decimal(repr(float(position))) for position in positions]
    offset = _shared(values)
    rest = [value - offset for value in values]
    largest = max(map(abs, rest), default=Decimal(0))
    power = largest.adjusted() if largest else 0
    power = 0 if power in plain_powers else power
    texts = tick_texts(float(value.scaleb(-power)) for value in rest)
    parts = power_text(power) if power else "", _offset_text(offset) if offset else ""
    return TickLabels(texts, " ".join(part for part in parts if part))


def _shared(values: Sequence[Decimal]) -> Decimal:
    """Return the roundest of ticks that are close together and far from 0; 0 where they are not."""
    steps = [after - before for before, after in itertools.pairwise(values)]
    if not steps or max(map(abs, values)) < _FAR * min(steps):
        return Decimal(0)
    return min(values, key=lambda value: len(value.normalize().as_tuple().digits))


def _offset_text(offset: Decimal) -> str:
    size = abs(offset).normalize()
    is_plain = _SMALLEST_OFFSET <= size.adjusted() <= _LONGEST_OFFSET
    text = f"{size:,f}".translate(_GROUPED) if is_plain else number_text(float(size))
    return f"{'+' if offset > 0 else MINUS} {true_minus(text)}"


def true_minus(text: str) -> str:
    """Return a text with every hyphen a minus sign."""
    return text.replace("-", MINUS)


def _short_exponent(text: str) -> str:
    """Return a text without the plus sign and the leading zero of its exponent."""
    return text.replace("e+0", "e").replace("e+", "e").replace("e-0", "e-")
