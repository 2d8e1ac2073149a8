"""Scalar fields over a surface, and the range of values that a picture of one spreads its colours over."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from enum import StrEnum
from functools import partial
from math import hypot
from typing import Any, ClassVar

import numpy as np
import numpy.typing as npt

from qovr_core.arrays import Array, read_only
from qovr_core.geometry.closest import closest_points
from qovr_core.geometry.differential import ParametricSurface
from qovr_core.registry import Record, Registry

ROBUST_PERCENTILES = (2.0, 98.0)
"""Between these lies what a robust range shows: a few samples beside a singular point do not bleach the rest."""

_ROUNDING = 1e-11
"""Part of the largest coordinate below which differences of positions count as rounding, at the least."""

Range = tuple[float, float]
"""The values at the two ends of the colours."""


class Need(StrEnum):
    """What a field must be given besides the surface: the surface ``beside`` it.

    That is for ``REFERENCE`` the surface to measure from, and for ``KNOT`` the derivative dS/dknot of one internal
    knot, whose points are vectors (``qovr_core.laboratory.sensitivity.knot_sensitivity``).
    """

    REFERENCE = "reference"
    KNOT = "knot"


@dataclass(frozen=True, eq=False)
class Field(Record):
    """A number for every point of a surface, and everything that is to be known to offer and show it.

    Parameters
    ----------
    name : by which it is found
    title : what a colour bar says; the letters after ``_`` are a subscript
    symbol : what a readout of one point calls it
    text : what a menu says, with ``&`` before the letter that chooses it
    tip : what its colours say, in one sentence without an end
    values : called with the surface, u (n,), v (m,) and the surface beside it (None unless it ``needs`` one), it
        returns (n, m) float64 in the surface's own units; NaN where it is not defined
    is_diverging : whether zero is its natural middle
    length_power : its values are of the dimension length to this power
    finest : samples a side from which a moving and a resting picture take it, for values between which one may
        interpolate; None to take it everywhere
    axis : the coordinate that it is, 0 to 2, so that it can be read off that axis too; None for what is no coordinate
    needs : what it must be given besides the surface, if anything
    missing : what to say and do where that is missing
    title_beside : the title once that is there; ``{}`` stands for its name
    """

    name: str
    title: str
    symbol: str
    text: str
    tip: str
    values: Callable[[ParametricSurface, npt.ArrayLike, npt.ArrayLike, Any], Array]
    is_diverging: bool = False
    length_power: int = 1
    finest: tuple[int, int] | None = None
    axis: int | None = None
    needs: Need | None = None
    missing: str = ""
    title_beside: str = ""

    table: ClassVar[Registry[Field]]
    HEIGHT: ClassVar[Field]
    GAUSSIAN: ClassVar[Field]
    MEAN: ClassVar[Field]
    LARGEST: ClassVar[Field]
    SMALLEST: ClassVar[Field]
    DISTANCE: ClassVar[Field]
    SENSITIVITY: ClassVar[Field]


FIELDS = Field.table = Registry[Field]("field")
"""All fields, in the order in which they are offered."""

_FINE, _COSTLY = (49, 201), (25, 101)
"""Fields are smooth; a closest point costs as much as a hundred curvatures."""


def _distance(surface: ParametricSurface, u: npt.ArrayLike, v: npt.ArrayLike, reference: ParametricSurface) -> Array:
    points = surface.points(u, v)
    return closest_points(reference, points.reshape(-1, 3)).distance.reshape(points.shape[:2])


_curvature = partial(Field, is_diverging=True, length_power=-1, finest=_FINE)

for _field in (
    Field(
        "height",
        "Z-Axis Value",
        "z",
        "&Height",
        "Colours say z, as in the paper's figures",
        lambda surface, u, v, _: surface.points(u, v)[..., 2].copy(),  # held alone, without x and y
        axis=2,
    ),
    _curvature(
        "gaussian",
        "Gaussian curvature K",
        "K",
        "&Gaussian curvature K",
        "Colours say K = k_1 k_2: positive on domes, negative on saddles",
        lambda surface, u, v, _: surface.curvature(u, v).gaussian,
        length_power=-2,
    ),
    _curvature(
        "mean",
        "Mean curvature H",
        "H",
        "&Mean curvature H",
        "Colours say H = (k_1 + k_2) / 2, positive where the surface bends toward its normal S_u x S_v",
        lambda surface, u, v, _: surface.curvature(u, v).mean,
    ),
    _curvature(
        "largest",
        "Largest principal curvature k_1",
        "k_1",
        "&Largest principal curvature",
        "Colours say the larger principal curvature k_1",
        lambda surface, u, v, _: surface.curvature(u, v).largest,
    ),
    _curvature(
        "smallest",
        "Smallest principal curvature k_2",
        "k_2",
        "&Smallest principal curvature",
        "Colours say the smaller principal curvature k_2",
        lambda surface, u, v, _: surface.curvature(u, v).smallest,
    ),
    Field(
        "distance",
        "Distance from the reference",
        "distance",
        "&Distance from the reference",
        "Colours say the distance to the closest point of the reference (menu Laboratory, Pin)",
        _distance,
        finest=_COSTLY,
        needs=Need.REFERENCE,
        missing="Pin a reference to see the distance from it: menu Laboratory, Pin as reference",
        title_beside="Distance from {}",
    ),
    Field(
        "sensitivity",
        "Sensitivity",
        "|∂S/∂knot|",
        "Sensitivit&y to the knot in focus",
        "Colours say |dS/dknot| for the knot whose field had the keyboard last",
        lambda _, u, v, slope: np.linalg.norm(slope.points(u, v), axis=-1),
        finest=_FINE,
        needs=Need.KNOT,
        missing="Put the keyboard into a knot's field to see what that knot moves",
        title_beside="Sensitivity |∂S/∂{}|",
    ),
):
    FIELDS.register(_field)
    setattr(Field, _field.name.upper(), _field)
FIELDS.seal()


@np.errstate(all="ignore")  # what overflows has no colour
def field_values(
    field: Field,
    surface: ParametricSurface,
    u: npt.ArrayLike,
    v: npt.ArrayLike,
    beside: ParametricSurface | None = None,
) -> Array:
    """Return the values of a field on a grid, in the surface's own units.

    Parameters
    ----------
    surface : the surface; signs of curvatures belong to its normal S_u x S_v
    u, v : (n,) and (m,) parameters in the surface's domain
    beside : what the field ``needs``; without meaning for a field that needs nothing

    Returns
    -------
    (n, m) float64, read-only; NaN where a curvature is not defined, because the tangents are dependent

    Raises
    ------
    ValueError : the field needs a surface beside and has none
    """
    if field.needs is not None and beside is None:
        raise ValueError(f"the field {field} has no surface beside it; expected what its {field.needs} gives")
    return read_only(field.values(surface, u, v, beside))


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
    if field.is_diverging:
        reach = max(abs(low), abs(high))
        return (-reach, reach) if reach > least else (0.0, 0.0)
    if high - low > least:
        return low, high
    middle = (low + high) / 2
    return (middle, middle) if abs(middle) > least else (0.0, 0.0)


def field_rounding(field: Field, points: Array, rounding: npt.ArrayLike = 0.0) -> float:
    """Return the size below which a field's values, or their differences, are rounding.

    Parameters
    ----------
    points : (..., 3) of the surface, for its size and its distance from the origin
    rounding : (3,) of its coordinates, where that is known to be more (``Evaluation.layer_rounding``)
    """
    flat = points.reshape(-1, 3)
    largest, extent = float(np.abs(flat).max()), hypot(*np.ptp(flat, axis=0))
    size = extent or largest or 1.0
    noise = max(_ROUNDING * (largest or size), float(np.max(rounding)))
    with np.errstate(over="ignore", under="ignore"):  # a curvature of something minute is beyond all numbers
        return float(noise / size * np.float64(size) ** field.length_power)
