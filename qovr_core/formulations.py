"""The surfaces that the paper's equations, data and claims describe, one record each; arrays alone, no documents."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import ClassVar

import numpy as np

from qovr_core.arrays import Array
from qovr_core.geometry.knots import Direction, KnotPlace
from qovr_core.geometry.network import (
    boolean_sum,
    boolean_sum_of,
    boolean_sum_slope,
    boolean_sum_summands,
    network_curves,
    product_slope,
    product_summands,
    product_surface,
)
from qovr_core.geometry.rounding import LEAST_NOISE, NOISE
from qovr_core.layer import Layer
from qovr_core.registry import Record, Registry

PUBLISHED_KERNEL_DECIMALS = 4
"""The published workbooks were computed from inverse kernels cut to this many decimals."""

_STEP = float(np.finfo(np.float64).eps ** (1 / 5))
"""Step of a numerical slope, as part of the knot's distance from the nearer end of (0, 1), near which surfaces vary
like powers of 1 / distance: what a difference of fourth order cuts off and what rounding adds are then alike."""

_STEPS = np.array([-2.0, -1.0, 1.0, 2.0])
_FACTORS = np.array([1.0, -8.0, 8.0, -1.0]) / 12
"""The central difference of fourth order: sum of factor f(x + step h), over h."""

_LAST_ROW = 4

Build = Callable[[Array, Array, Array], Array]
"""Called with net (..., k, l, 3), row knots (..., k, 4) and column knots (..., l, 4); see ``Formulation``."""

Join = Callable[[Array, Array, Array, Array, Array], Array]
"""Called as a ``Build``, and with the curves (..., k, 7, 3) and (..., l, 7, 3) of the network; see ``Formulation``."""

Summands = Callable[[Array, Array, Array], Array]
"""Called as a ``Build``; see ``Formulation``."""

Slope = Callable[[Array, Array, Array, KnotPlace], Array]
"""Called with net (k, l, 3), row knots (k, 4), column knots (l, 4), and which of them; see ``Formulation``."""


@dataclass(frozen=True, eq=False, repr=False)
class Formulation(Record):
    """How the curves of a net become one surface; compared and pickled by its name.

    Parameters
    ----------
    name : in documents, files and commands
    description : what surface it is, in one sentence
    build : gives the raw surfaces (..., 7, 7, 3) of many nets at once, as Bernstein coefficients of degree 6 each way,
        u along the first of them; the leading axes of both knot arrays are the same, and broadcastable with those of
        the net. Along u the surface is of degree 4 where s_ip = u_ip on every active row, along v likewise
    slope : gives the derivative (7, 7, 3) of these coefficients with respect to one knot; None has it taken numerically
    active_rows, active_columns : the curves whose knots have an effect on the surface; None for all of them
    kernel_decimals : to how many decimals the inverse kernels are cut; None where they are exact
    resting_layer : the layer that lies on the control net
    is_continuous : whether the windows of a net meet along whole curves, so that it has one surface; else each is alone
    is_as_claimed : whether it is the surface that the paper's claims describe
    summands : gives, for what ``build`` is given, how large all that is added up to a coordinate is together, (..., 3):
        the scale of its rounding, however much of it cancels. None has it taken from ``build``, far on the safe side
    join : gives what ``build`` does from curves that are known already, as those of a net are which its windows share

    Raises
    ------
    ValueError : the kernels are cut, so that the surface is a step function of its knots, and no slope is given

    Examples
    --------
    >>> [str(formulation) for formulation in FORMULATIONS.values()]
    ['published', 'double-sum', 'interpolating']
    >>> def halved(net, row_knots, column_knots):
    ...     return Formulation.INTERPOLATING.build(net, row_knots, column_knots) / 2
    >>> with FORMULATIONS.register(Formulation("halved", "Half of the interpolating surface.", halved)):
    ...     list(FORMULATIONS)
    ['published', 'double-sum', 'interpolating', 'halved']
    """

    name: str
    description: str
    build: Build
    slope: Slope | None = None
    active_rows: tuple[int, ...] | None = None
    active_columns: tuple[int, ...] | None = None
    kernel_decimals: int | None = None
    resting_layer: Layer = Layer.TRANSFORMED
    is_continuous: bool = False
    is_as_claimed: bool = False
    summands: Summands | None = None
    join: Join | None = None

    table: ClassVar[Registry[Formulation]] = Registry("formulation")
    PUBLISHED: ClassVar[Formulation]
    DOUBLE_SUM: ClassVar[Formulation]
    INTERPOLATING: ClassVar[Formulation]

    def __post_init__(self) -> None:
        if self.kernel_decimals is not None and self.slope is None:
            raise ValueError(f"the formulation '{self.name}' cuts its kernels; expected the slope of its uncut surface")

    def active_curves(self, direction: Direction) -> tuple[int, ...] | None:
        """Return the curves of a direction whose knots have an effect on the surface; None for all of them."""
        return self.active_rows if direction is Direction.ROWS else self.active_columns

    def is_active(self, direction: Direction, curve: int) -> bool:
        """Return whether the knots of a curve have an effect on the surface."""
        active = self.active_curves(direction)
        return active is None or curve in active

    def active_names(self, direction: Direction) -> list[str]:
        """Return the names of the active curves of a direction, as ``C_4``; none where every curve is active."""
        return [direction.curve_name(curve) for curve in self.active_curves(direction) or ()]

    def rounding(self, net: Array, row_knots: Array, column_knots: Array) -> Array:
        """Return up to what size a coordinate of the raw surfaces, or a difference of two, is no more than rounding.

        Parameters
        ----------
        net, row_knots, column_knots : (..., k, l, 3), (..., k, 4) and (..., l, 4)

        Returns
        -------
        (..., 3) float64, above 0, for x, y and z
        """
        summands = self.summands or self._numerical_summands
        rounding: Array = np.maximum(NOISE * summands(net, row_knots, column_knots), LEAST_NOISE)
        return rounding

    def _numerical_summands(self, net: Array, row_knots: Array, column_knots: Array) -> Array:
        """Return how far the surfaces move in all when each point is doubled, as often as there are points."""
        before = self.build(net, row_knots, column_knots)
        total = np.zeros_like(before)
        for i, j in np.ndindex(net.shape[-3:-1]):
            doubled = net.copy()
            doubled[..., i, j, :] *= 2
            total += np.abs(self.build(doubled, row_knots, column_knots) - before)
        moved: Array = net.shape[-3] * net.shape[-2] * total.max(axis=(-2, -3))
        return moved

    def knot_slope(self, net: Array, row_knots: Array, column_knots: Array, place: KnotPlace) -> Array:
        """Return the derivative of the raw surface with respect to one knot, as patch coefficients (7, 7, 3).

        It is exact where the record knows its slope. Else it is a central difference, off by about 1e-11 of the
        surface's largest coefficient over the knot's distance from the nearer end of (0, 1). Where kernels are cut
        it is that of the same surface with its kernels uncut.

        Parameters
        ----------
        net, row_knots, column_knots : (k, l, 3), (k, 4) and (l, 4)
        place : which knot
        """
        if not self.is_active(place.direction, place.curve):
            return np.zeros_like(self.build(net, row_knots, column_knots))
        slope = self.slope or self._numerical_slope
        return slope(net, row_knots, column_knots, place)

    def _numerical_slope(self, net: Array, row_knots: Array, column_knots: Array, place: KnotPlace) -> Array:
        knots = [np.stack([row_knots] * len(_STEPS)), np.stack([column_knots] * len(_STEPS))]
        moved = knots[place.direction is Direction.COLUMNS][:, place.curve, place.number]
        step = _STEP * min(moved[0], 1 - moved[0])
        moved += step * _STEPS
        return np.tensordot(_FACTORS / step, self.build(net, *knots), axes=1)


def _published(net: Array, row_knots: Array, column_knots: Array) -> Array:
    """Only the last row curve enters: C_4(u) * sum_j K_j(v), as the published workbooks contain."""
    curves = network_curves(net, row_knots, column_knots, PUBLISHED_KERNEL_DECIMALS)
    return _published_of(net, row_knots, column_knots, *curves)


def _published_of(_net: Array, _row_knots: Array, _column_knots: Array, rows: Array, columns: Array) -> Array:
    return product_surface(rows[..., _LAST_ROW, :, :], columns.sum(axis=-3))


def _double_sum(net: Array, row_knots: Array, column_knots: Array) -> Array:
    """(sum_i C_i(u)) * (sum_j K_j(v)), eqs. (27), (44) and Algorithm 1 as printed."""
    return _double_sum_of(net, row_knots, column_knots, *network_curves(net, row_knots, column_knots))


def _double_sum_of(_net: Array, _row_knots: Array, _column_knots: Array, rows: Array, columns: Array) -> Array:
    return product_surface(rows.sum(axis=-3), columns.sum(axis=-3))


Formulation.PUBLISHED = Formulation(
    name="published",
    description="What the published workbooks contain: the last row curve times the sum of the columns, with kernels "
    "cut to four decimals.",
    build=_published,
    join=_published_of,
    slope=partial(product_slope, entering_rows=slice(_LAST_ROW, None)),
    active_rows=(_LAST_ROW,),
    kernel_decimals=PUBLISHED_KERNEL_DECIMALS,
    summands=partial(product_summands, kernel_decimals=PUBLISHED_KERNEL_DECIMALS, entering_rows=slice(_LAST_ROW, None)),
)
Formulation.DOUBLE_SUM = Formulation(
    name="double-sum",
    description="The paper's equations as printed: the sum of the row curves times the sum of the columns.",
    build=_double_sum,
    join=_double_sum_of,
    slope=product_slope,
    summands=product_summands,
)
Formulation.INTERPOLATING = Formulation(
    name="interpolating",
    description="What the paper claims: a surface through the inner control points, with fixed edges.",
    build=boolean_sum,
    join=boolean_sum_of,
    slope=boolean_sum_slope,
    resting_layer=Layer.RAW,
    is_continuous=True,
    is_as_claimed=True,
    summands=boolean_sum_summands,
)

FORMULATIONS = Formulation.table
"""All formulations, in the order in which they are offered."""

for _record in (Formulation.PUBLISHED, Formulation.DOUBLE_SUM, Formulation.INTERPOLATING):
    FORMULATIONS.register(_record)
FORMULATIONS.seal()
