"""What counts as rounding, one way for all claims."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from qovr_core.arrays import Array
from qovr_core.geometry.differential import ParametricSurface

ROUNDING = 1e-12
"""A difference below this part of the largest number that entered it is rounding: thousands of operations in
double precision lose less, and what the published workbooks cut from their kernels, up to 1e-4, is far more."""

NOISE = 8 * float(np.finfo(np.float64).eps)
"""Rounding of a surface as part of its summands; over many random nets it stays below a tenth of this."""

LEAST_NOISE = float(np.finfo(np.float64).tiny)
"""Numbers below this have lost digits to underflow, whatever they were made of."""

_SIZED_AT = np.linspace(0.0, 1.0, 9)
"""Where a surface is looked at for its size; between them a polynomial of degree 6 is not much larger."""

_MOST_PLACES = 1000
"""Binary places of the largest unit; its inverse is a number too."""

LARGEST_BESIDE = 1e30
"""How much larger than the unit other lengths may be; products of four stay finite beside a surface of any tangents."""


def largest(array: Array) -> float:
    """Return the largest magnitude in an array; 0 for an empty one."""
    return float(abs(array).max(initial=0.0))


def part_of(value: float, whole: float) -> float:
    """Return a value as part of a whole; of a surface that is drawn together into a point, the value itself."""
    return value / (whole or 1.0)


def own_unit(size: npt.ArrayLike) -> Array:
    """Return the units, powers of two by which nothing is rounded, in which sizes are about 1; for 0 it is 1."""
    return np.asarray(np.ldexp(1.0, np.clip(np.frexp(size)[1], -_MOST_PLACES, _MOST_PLACES)))


def in_own_unit(surface: ParametricSurface, *, beside: float = 0.0) -> tuple[ParametricSurface, float]:
    """Return a surface in a unit in which it is about 1, so that no product of its derivatives overflows.

    Parameters
    ----------
    beside : a length that is measured in the same unit, and whose square must not overflow either

    Returns
    -------
    the surface, and the unit: a power of two, so that nothing is rounded
    """
    u, v = (low + (high - low) * _SIZED_AT for low, high in surface.domain)
    size = max(largest(surface.points(u, v)), beside / LARGEST_BESIDE)
    unit = float(own_unit(size))
    return surface.transformed(np.diag([1 / unit, 1 / unit, 1 / unit, 1.0])), unit
