"""Round numbers for axes: limits and tick positions."""

from __future__ import annotations

import math

import numpy as np

from qovr_core.arrays import Array, read_only

_ROUND_STEPS = (1.0, 2.0, 5.0, 10.0)
_SLACK = 1e-9
"""Part of a step by which a bound may miss a tick and still count as on it: rounding of decimal fractions."""

_LIMIT_INTERVALS = 5
"""Limits are rounded to a step of about a fifth of the extent: close to the data, and steady while it
moves."""


def round_step(extent: float, intervals: int) -> float:
    """Return the smallest of 1, 2, 5 times a power of ten that cuts an extent into at most
    ``intervals``."""
    least = extent / intervals
    power = 10.0 ** math.floor(math.log10(least))
    return next(power * step for step in _ROUND_STEPS if power * step >= least * (1 - _SLACK))


def round_limits(low: float, high: float) -> tuple[float, float]:
    """Return limits on round numbers around an interval; an interval without extent is widened to show it."""
    if high - low <= _SLACK * max(abs(low), abs(high)):
        margin = abs(low) / 2 or 0.5
        low, high = low - margin, high + margin
    step = round_step(high - low, _LIMIT_INTERVALS)
    return math.floor(low / step + _SLACK) * step, math.ceil(high / step - _SLACK) * step


def tick_positions(low: float, high: float, intervals: int) -> Array:
    """Return the round positions inside [low, high], at most ``intervals`` apart from one another's count.

    Returns
    -------
    (k,) float64, read-only
    """
    step = round_step(high - low, max(intervals, 1))
    first, last = math.ceil(low / step - _SLACK), math.floor(high / step + _SLACK)
    return read_only(np.arange(first, last + 1) * step)
