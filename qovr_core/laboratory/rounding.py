"""What counts as rounding, one way for all claims."""

from __future__ import annotations

from qovr_core.arrays import Array

ROUNDING = 1e-12
"""A difference below this part of the largest number that entered it is rounding: thousands of operations in
double precision lose less, and what the published workbooks cut from their kernels, up to 1e-4, is far more."""


def largest(array: Array) -> float:
    """Return the largest magnitude in an array; 0 for an empty one."""
    return float(abs(array).max(initial=0.0))


def part_of(value: float, whole: float) -> float:
    """Return a value as part of a whole; of a surface that is drawn together into a point, the value itself."""
    return value / (whole or 1.0)
