"""Differential geometry of any parametric surface, from its partial derivatives."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from functools import partial
from typing import Protocol

import numpy as np
import numpy.typing as npt

from qovr_core.arrays import Array, read_only

Domain = tuple[tuple[float, float], tuple[float, float]]
"""The first and the last parameter along u, and along v."""

Derivative = Callable[[int, int], Array]
"""Gives a partial derivative of orders in u and in v on some grid, (n, m, 3)."""


class ParametricSurface(Protocol):
    """What everything that looks at a surface S(u, v) over a rectangle asks it.

    ``Patch`` is one; so are the splines with which ``qovr_core.laboratory`` compares it.
    """

    @property
    def domain(self) -> Domain:
        """The rectangle of its parameters: the first and the last along u, and along v."""

    @property
    def breaks(self) -> tuple[Array, Array]:
        """The joints inside the domain in u and in v, across which the surface is another polynomial."""

    def derivative(self, u: npt.ArrayLike, v: npt.ArrayLike, order_u: int, order_v: int) -> Array:
        """Return a partial derivative on a grid of (n,) and (m,) parameters, (n, m, 3)."""

    def derivative_at(self, u: npt.ArrayLike, v: npt.ArrayLike, order_u: int, order_v: int) -> Array:
        """Return a partial derivative at scattered parameters, (k,) and (k,), as (k, 3)."""

    def points(self, u: npt.ArrayLike, v: npt.ArrayLike) -> Array:
        """Return the points on a grid, (n, m, 3)."""

    def normals(self, u: npt.ArrayLike, v: npt.ArrayLike) -> Array:
        """Return the unit normals along S_u x S_v on a grid, (n, m, 3)."""

    def curvature(self, u: npt.ArrayLike, v: npt.ArrayLike) -> Curvature:
        """Return the curvatures on a grid."""

    def transformed(self, matrix: npt.ArrayLike) -> ParametricSurface:
        """Return the surface mapped by a (4, 4) affine matrix that acts on columns [x y z 1]."""


_SINGULAR = 1e-12
"""|S_u x S_v| below this part of the largest possible one is rounding, and no direction."""

_NO_DIRECTION = np.array([0.0, 0.0, 1.0])


@dataclass(frozen=True)
class Curvature:
    """Gaussian and mean curvature, each float64 of one shape; NaN where the tangents are dependent.

    The signs of mean and principal curvatures belong to the normal S_u x S_v: they are positive where the
    surface bends toward that normal.

    Examples
    --------
    >>> saddle = Curvature(gaussian=np.array([-4.0]), mean=np.array([0.0]))
    >>> saddle.largest.tolist(), saddle.smallest.tolist()
    ([2.0], [-2.0])
    """

    gaussian: Array
    mean: Array

    @property
    def largest(self) -> Array:
        """The larger principal curvature k_1, never below k_2."""
        return read_only(self.mean + self._half_difference)

    @property
    def smallest(self) -> Array:
        """The smaller principal curvature k_2."""
        return read_only(self.mean - self._half_difference)

    @property
    def _half_difference(self) -> Array:
        """(k_1 - k_2) / 2; where rounding makes its square negative, the point is an umbilic."""
        return np.sqrt(np.maximum(self.mean**2 - self.gaussian, 0.0))


def curvature(su: Array, sv: Array, suu: Array, suv: Array, svv: Array, *, singular: float) -> Curvature:
    """Return the curvatures from the two fundamental forms.

    Parameters
    ----------
    su, sv, suu, suv, svv : (..., 3) partial derivatives
    singular : the length of S_u x S_v up to which the tangents count as dependent
    """
    normal = np.cross(su, sv)
    length = np.linalg.norm(normal, axis=-1)
    length = np.where(length <= singular, np.nan, length)
    g_uu, g_uv, g_vv = (np.einsum("...k,...k", a, b) for a, b in ((su, su), (su, sv), (sv, sv)))
    h_uu, h_uv, h_vv = (np.einsum("...k,...k", second, normal) / length for second in (suu, suv, svv))
    area = length**2
    gaussian = (h_uu * h_vv - h_uv * h_uv) / area
    mean = (g_uu * h_vv - 2 * g_uv * h_uv + g_vv * h_uu) / (2 * area)
    return Curvature(read_only(gaussian), read_only(mean))


def surface_curvature(surface: ParametricSurface, u: npt.ArrayLike, v: npt.ArrayLike, *, singular: float) -> Curvature:
    """Return the curvatures of a surface on a grid of (n,) and (m,) parameters; ``singular`` as in ``curvature``."""
    orders = ((1, 0), (0, 1), (2, 0), (1, 1), (0, 2))
    return curvature(*(surface.derivative(u, v, *order) for order in orders), singular=singular)


def normals(surface: ParametricSurface, u: npt.ArrayLike, v: npt.ArrayLike, *, singular: float) -> Array:
    """Return the unit normals of a surface along S_u x S_v on a grid.

    Where the tangents are dependent, as on an edge drawn together into a point, the normal is its limit
    on the way to the domain's centre; where that limit is not of first order, it is (0, 0, 1).

    Parameters
    ----------
    u, v : (n,) and (m,) parameters
    singular : the length of S_u x S_v up to which the tangents count as dependent

    Returns
    -------
    (n, m, 3) float64, read-only, every vector of length 1

    Raises
    ------
    ValueError : u or v is not one-dimensional
    """
    to_u, to_v = (
        sum(ends) / 2 - np.asarray(x, dtype=np.float64) for x, ends in zip((u, v), surface.domain, strict=True)
    )
    return unit_normals(partial(surface.derivative, u, v), (to_u, to_v), singular=singular)


def rounding_of_a_normal(tangents: Iterable[Array]) -> float:
    """Return the length below which S_u x S_v is no more than rounding, by the coefficients of S_u and of S_v."""
    return float(_SINGULAR * np.prod([np.abs(each).max() for each in tangents]))


def unit_normals(derivative: Derivative, inward: tuple[Array, Array], *, singular: float) -> Array:
    """Return the unit normals on a grid, as ``normals`` does.

    Parameters
    ----------
    derivative : gives the partial derivative of an order in u and in v on the grid, (n, m, 3)
    inward : (n,) and (m,) the way on which limits are taken
    singular : the length of S_u x S_v up to which the tangents count as dependent
    """
    vectors = np.cross(derivative(1, 0), derivative(0, 1))
    lengths = np.linalg.norm(vectors, axis=-1)
    is_singular = lengths <= singular
    if is_singular.any():
        limits = _normals_inward(derivative, inward, singular)
        vectors[is_singular] = limits[is_singular]
        lengths[is_singular] = 1
    vectors /= lengths[..., None]
    return read_only(vectors)


def _normals_inward(derivative: Derivative, inward: tuple[Array, Array], singular: float) -> Array:
    """Return the unit derivative of S_u x S_v on the way inward; (0, 0, 1) where it vanishes."""
    su, sv = derivative(1, 0), derivative(0, 1)
    suu, suv, svv = (derivative(*orders) for orders in ((2, 0), (1, 1), (0, 2)))
    to_u, to_v = inward[0][:, None, None], inward[1][None, :, None]
    vectors: Array = to_u * (np.cross(suu, sv) + np.cross(su, suv))
    vectors += to_v * (np.cross(suv, sv) + np.cross(su, svv))
    lengths = np.linalg.norm(vectors, axis=-1)
    vanished = lengths <= singular
    vectors[vanished] = _NO_DIRECTION
    lengths[vanished] = 1
    unit: Array = vectors / lengths[..., None]
    return unit
