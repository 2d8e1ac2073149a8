"""Scalar fields over a surface, and the range of values that a picture of one spreads its colours over."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum
from math import hypot

import numpy as np
import numpy.typing as npt

from qovr_core.arrays import Array, read_only
from qovr_core.geometry.closest import closest_points
from qovr_core.geometry.differential import ParametricSurface

ROBUST_PERCENTILES = (2.0, 98.0)
"""Between these lies what a robust range shows: a few samples beside a singular point do not bleach the rest."""

_ROUNDING = 1e-11
"""Part of the largest coordinate, over the size of the surface, below which positions and curvatures are rounding."""

Range = tuple[float, float]
"""The values at the two ends of the colours."""


class Field(StrEnum):
    """What can be asked at every point of a surface."""

    HEIGHT = "height"
    GAUSSIAN = "gaussian"
    MEAN = "mean"
    LARGEST = "largest"
    SMALLEST = "smallest"
    DISTANCE = "distance"
    SENSITIVITY = "sensitivity"


@dataclass(frozen=True)
class FieldFacts:
    """What is to be known about a field.

    Parameters
    ----------
    title : what a colour bar says; the letters after ``_`` are a subscript
    is_diverging : whether zero is its natural middle
    length_power : its values are of the dimension length to this power
    """

    title: str
    is_diverging: bool
    length_power: int


FIELDS = {
    Field.HEIGHT: FieldFacts("Z-Axis Value", is_diverging=False, length_power=1),
    Field.GAUSSIAN: FieldFacts("Gaussian curvature K", is_diverging=True, length_power=-2),
    Field.MEAN: FieldFacts("Mean curvature H", is_diverging=True, length_power=-1),
    Field.LARGEST: FieldFacts("Largest principal curvature k_1", is_diverging=True, length_power=-1),
    Field.SMALLEST: FieldFacts("Smallest principal curvature k_2", is_diverging=True, length_power=-1),
    Field.DISTANCE: FieldFacts("Distance from the reference", is_diverging=False, length_power=1),
    Field.SENSITIVITY: FieldFacts("Sensitivity", is_diverging=False, length_power=1),
}
"""All fields, in the order in which they are offered."""


@np.errstate(all="ignore")  # what overflows has no colour
def field_values(
    field: Field,
    surface: ParametricSurface,
    u: npt.ArrayLike,
    v: npt.ArrayLike,
    companion: ParametricSurface | None = None,
) -> Array:
    """Return the values of a field on a grid, in the surface's own units.

    Parameters
    ----------
    surface : the surface; signs of curvatures belong to its normal S_u x S_v
    u, v : (n,) and (m,) parameters in [0, 1]
    companion : for ``DISTANCE`` the reference surface, whose closest point counts; for ``SENSITIVITY`` the derivative
        dS/dknot (``knot_sensitivity``), whose length counts; the other fields have none

    Returns
    -------
    (n, m) float64, read-only; NaN where a curvature is not defined, because the tangents are dependent

    Raises
    ------
    ValueError : the field needs a companion and has none
    """
    if field is Field.HEIGHT:
        return read_only(surface.points(u, v)[..., 2])
    if field in (Field.DISTANCE, Field.SENSITIVITY):
        if companion is None:
            raise ValueError(f"the field {field} has no companion; expected a reference surface or dS/dknot")
        if field is Field.SENSITIVITY:
            return read_only(np.linalg.norm(companion.points(u, v), axis=-1))
        return _distances(surface.points(u, v), companion)
    values: Array = getattr(surface.curvature(u, v), field.value)
    return values


def _distances(points: Array, reference: ParametricSurface) -> Array:
    return read_only(closest_points(reference, points.reshape(-1, 3)).distance.reshape(points.shape[:2]))


def field_range(field: Field, values: Array, *, robust: bool, least: float = 0.0) -> Range:
    """Return the range that shows a field's values: all of them, or those between the ``ROBUST_PERCENTILES``.

    The range of a diverging field is symmetric about zero.

    Parameters
    ----------
    values : any shape; what is not finite does not count
    least : the smallest extent, as ``field_rounding`` gives it: values that differ by less count as one

    Returns
    -------
    low and high; equal where all values count as one, and both NaN where none is finite
    """
    finite = values[np.isfinite(values)]
    if finite.size == 0:
        return np.nan, np.nan
    if robust:
        low, high = (float(end) for end in np.percentile(finite, ROBUST_PERCENTILES))
    else:
        low, high = float(finite.min()), float(finite.max())
    if FIELDS[field].is_diverging:
        reach = max(abs(low), abs(high))
        return (-reach, reach) if reach > least else (0.0, 0.0)
    if high - low > least:
        return low, high
    middle = (low + high) / 2
    return (middle, middle) if abs(middle) > least else (0.0, 0.0)


def field_rounding(field: Field, points: Array) -> float:
    """Return the size below which a field's values, or their differences, are rounding.

    Parameters
    ----------
    points : (..., 3) of the surface, for its size and its distance from the origin
    """
    flat = points.reshape(-1, 3)
    largest, extent = float(np.abs(flat).max()), hypot(*np.ptp(flat, axis=0))
    size = extent or largest or 1.0
    return _ROUNDING * (largest / size or 1.0) * size ** FIELDS[field].length_power
