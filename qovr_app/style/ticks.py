"""Round numbers for axes: limits and tick positions."""

from __future__ import annotations

import math
import sys
from dataclasses import dataclass

import numpy as np

from qovr_core.arrays import Array, read_only

_ROUND_DIGITS = (1, 2, 5, 10)
_SLACK = 1e-9
"""Part of a step by which a bound may miss a tick and still count as on it: rounding of decimal fractions."""

_FLAT = 1e-13
"""An extent below this part of the largest coordinate is rounding: some hundred neighbouring numbers."""

_LEAST_EXTENT = 1e-304
"""What is smaller counts as no extent: the numbers near it lose their digits."""

_WIDENED = 1e-9
"""Of the largest coordinate: an interval without extent is widened by no less, so that ticks can be told apart."""

_ROUNDING = 4 * float(np.finfo(float).eps)
"""Part of a number of steps by which dividing by the step may miss it."""

_LIMIT_INTERVALS = 5
"""Limits are rounded to a step of about a fifth of the extent: close to the data, and steady while it
moves."""


@dataclass(frozen=True)
class RoundStep:
    """A digit times a power of ten: its multiples are the very numbers that their decimal fractions name."""

    digit: int
    power: int

    @property
    def length(self) -> float:
        """The step as a number."""
        return self.times(1)

    def times(self, count: int) -> float:
        """Return a multiple, the double that is nearest to the decimal fraction."""
        return float(f"{count * self.digit}e{self.power}")

    def last_before(self, bound: float) -> int:
        """Return the number of steps of the last multiple that is not above a bound, but for rounding."""
        steps = bound / self.length
        return math.floor(steps + _SLACK + _ROUNDING * abs(steps))


def round_step(extent: float, intervals: int) -> RoundStep:
    """Return the smallest of 1, 2, 5 times a power of ten that cuts an extent into at most
    ``intervals``."""
    least = min(max(extent, _LEAST_EXTENT), sys.float_info.max) / intervals
    power = math.floor(math.log10(least))
    steps = (RoundStep(digit, power) for digit in _ROUND_DIGITS)
    return next(step for step in steps if step.length >= least * (1 - _SLACK))


def is_flat(low: float, high: float) -> bool:
    """Return whether an interval has no extent but that of rounding."""
    return high - low <= max(_FLAT * max(abs(low), abs(high)), _LEAST_EXTENT)


def round_limits(low: float, high: float, widest: float = math.inf) -> tuple[float, float]:
    """Return limits on round numbers around an interval; one without extent is widened to show it.

    Parameters
    ----------
    widest : how far at most an interval without extent is widened to each side
    """
    if is_flat(low, high):
        largest = max(abs(low), abs(high))
        margin = largest / 2 if largest > _LEAST_EXTENT else 0.5
        margin = max(min(margin, widest), _WIDENED * largest)
        low, high = low - margin, high + margin
    step = round_step(high - low, _LIMIT_INTERVALS)
    return step.times(step.last_before(low)), step.times(-step.last_before(-high))


def tick_positions(low: float, high: float, intervals: int) -> Array:
    """Return the round positions inside [low, high], at most ``intervals`` apart from one another's count.

    Returns
    -------
    (k,) float64, read-only
    """
    step = round_step(high - low, max(intervals, 1))
    first, last = -step.last_before(-low), step.last_before(high)
    return read_only(np.array([step.times(count) for count in range(first, last + 1)]))
