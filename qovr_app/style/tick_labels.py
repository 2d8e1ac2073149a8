"""Labels of ticks: short however far from 0 or small the ticks are, because what they share is set apart."""

from __future__ import annotations

import itertools
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from decimal import Decimal

from qovr_core.number_texts import MINUS, number_text, power_text, tick_texts, true_minus

_FAR = 10_000
"""Ticks this many steps from 0 have the digits that they share set apart."""

_PLAIN_POWERS = range(-4, 6)
"""Powers of ten of ticks that are written in full."""

_LONGEST_OFFSET, _SMALLEST_OFFSET = 12, -6
"""Powers of ten beyond which the digits that ticks share are written with an exponent."""

_GROUPED = str.maketrans(",", "\N{NO-BREAK SPACE}")


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
