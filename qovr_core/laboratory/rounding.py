"""What counts as rounding, one way for all claims."""

from __future__ import annotations

import math

from qovr_core.arrays import Array

ROUNDING = 1e-12
"""A difference below this part of the largest number that entered it is rounding: thousands of operations in
double precision lose less, and what the published workbooks cut from their kernels, up to 1e-4, is far more."""


def largest(array: Array) -> float:
    """Return the largest magnitude in an array; 0 for an empty one."""
    return float(abs(array).max(initial=0.0))


def part_of(value: float, whole: float) -> float:
    """Return a value as part of a whole; where there is no whole, 0 for nothing and infinity for something."""
    if whole:
        return value / whole
    return 0.0 if value == 0 else math.inf
