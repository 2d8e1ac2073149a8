"""The classical tensor-product surfaces of a net, which the paper's Table 2 sets beside its own."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cache
from math import comb, perm
from typing import Any

import numpy as np
import numpy.typing as npt

from qovr_core.arrays import Array, read_only
from qovr_core.geometry import bernstein, differential, grid, scattered
from qovr_core.geometry.differential import Curvature, Domain


@dataclass(frozen=True, eq=False)
class Basis:
    """Basis functions over [0, 1].

    Parameters
    ----------
    count : how many there are
    functions : called with parameters (n,) and an order of derivative, it returns (n, count); at a joint the
        derivatives are those from the right, beyond [0, 1] the outer polynomials go on
    breaks : (q,) the joints inside (0, 1) where two polynomials meet
    """

    count: int
    functions: Callable[[Array, int], Array]
    breaks: Array

    def __call__(self, parameters: npt.ArrayLike, order: int) -> Array:
        """Return the derivatives of all functions, (n, count); parameters that are no list raise ValueError."""
        x = bernstein.checked_parameters(parameters)
        values: Array = self.functions(x, order)
        return values


@dataclass(frozen=True, eq=False)
class TensorSurface:
    """A surface S(u, v) = sum_ij B_j(u) B_i(v) w_ij P_ij / sum_ij B_j(u) B_i(v) w_ij over [0, 1] x [0, 1].

    As for the QOVR surface, u runs along row i, over j, and v along column j, over i.

    Parameters
    ----------
    net : (k, l, 3) control points, ``[i, j]`` is P_{i,j}; kept as read-only float64
    basis_u, basis_v : the l functions B_j that serve along u, and the k functions B_i along v
    weights : (k, l), positive; None for a surface that is not rational

    Raises
    ------
    ValueError : the net or the weights have another shape, or a weight is not positive and finite
    """

    net: Array
    basis_u: Basis
    basis_v: Basis
    weights: Array | None = None

    def __post_init__(self) -> None:
        net = np.array(self.net, dtype=np.float64)
        if net.shape != (*self._counts, 3):
            raise ValueError(f"the net has shape {net.shape}; expected {(*self._counts, 3)}")
        object.__setattr__(self, "net", read_only(net))
        if self.weights is not None:
            object.__setattr__(self, "weights", _checked_weights(self.weights, self._counts))

    @property
    def _counts(self) -> tuple[int, int]:
        """Rows and columns of the net."""
        return self.basis_v.count, self.basis_u.count

    @property
    def domain(self) -> Domain:
        """The rectangle of its parameters, [0, 1] x [0, 1]."""
        return (0.0, 1.0), (0.0, 1.0)

    @property
    def breaks(self) -> tuple[Array, Array]:
        """The joints inside (0, 1) in u and in v, across which the surface is another polynomial."""
        return self.basis_u.breaks, self.basis_v.breaks

    def points(self, u: npt.ArrayLike, v: npt.ArrayLike) -> Array:
        """Return the points S(u, v) on a grid of (n,) and (m,) parameters, (n, m, 3) indexed [iu, iv]."""
        return self.derivative(u, v, 0, 0)

    def derivative(self, u: npt.ArrayLike, v: npt.ArrayLike, order_u: int, order_v: int) -> Array:
        """Return a partial derivative of S on a grid; at a joint the one from the right.

        Parameters
        ----------
        u, v : (n,) and (m,) parameters
        order_u, order_v : order of the derivative in u and in v

        Returns
        -------
        (n, m, 3) float64, read-only, indexed [iu, iv]

        Raises
        ------
        ValueError : u or v is not one-dimensional, or an order is negative
        """
        return self._evaluated(u, v, order_u, order_v, grid.evaluate)

    def derivative_at(self, u: npt.ArrayLike, v: npt.ArrayLike, order_u: int, order_v: int) -> Array:
        """Return a partial derivative of S at scattered parameters (k,) and (k,), (k, 3), as ``derivative`` does."""
        return self._evaluated(u, v, order_u, order_v, scattered.evaluate)

    def normals(self, u: npt.ArrayLike, v: npt.ArrayLike) -> Array:
        """Return the unit normals along S_u x S_v on a grid, (n, m, 3); see ``differential.normals``."""
        return differential.normals(self, u, v, singular=self._rounding_of_a_normal())

    def curvature(self, u: npt.ArrayLike, v: npt.ArrayLike) -> Curvature:
        """Return the curvatures on a grid, at a joint those from the right."""
        return differential.surface_curvature(self, u, v, singular=self._rounding_of_a_normal())

    def transformed(self, matrix: npt.ArrayLike) -> TensorSurface:
        """Return the surface mapped by a (4, 4) affine matrix that acts on columns [x y z 1]."""
        m = np.asarray(matrix, dtype=np.float64)
        return replace(self, net=self.net @ m[:3, :3].T + m[:3, 3])

    def _evaluated(
        self, u: npt.ArrayLike, v: npt.ArrayLike, order_u: int, order_v: int, evaluate: Callable[..., Array]
    ) -> Array:
        if min(order_u, order_v) < 0:
            raise ValueError(f"derivative orders are {order_u} and {order_v}; expected 0 or more")
        if self.weights is None:
            return read_only(evaluate(self.net.transpose(1, 0, 2), self.basis_u(u, order_u), self.basis_v(v, order_v)))
        along_u = [self.basis_u(u, order) for order in range(order_u + 1)]
        along_v = [self.basis_v(v, order) for order in range(order_v + 1)]
        weighted = np.concatenate([self.weights[..., None] * self.net, self.weights[..., None]], axis=2)
        coefficients = np.ascontiguousarray(weighted.transpose(1, 0, 2))
        lifted = [[evaluate(coefficients, a, b) for b in along_v] for a in along_u]
        return read_only(_quotient_derivative(lifted))

    def _rounding_of_a_normal(self) -> float:
        return differential.rounding_of_a_normal(np.diff(self.net, axis=axis) for axis in (0, 1))


def bezier(net: npt.ArrayLike) -> TensorSurface:
    """Return the Bezier surface of a net (k, l, 3): one polynomial, bi-quartic where the net is 5 x 5."""
    return _tensor_surface(net, lambda count: _b_spline_basis(count, count - 1))


def b_spline(net: npt.ArrayLike) -> TensorSurface:
    """Return the clamped uniform bi-cubic B-spline surface of a net (k, l, 3): 2 x 2 polynomials of 5 x 5, C2."""
    return _tensor_surface(net, lambda count: _b_spline_basis(count, _CUBIC))


def nurbs(net: npt.ArrayLike, weights: npt.ArrayLike) -> TensorSurface:
    """Return the clamped uniform bi-cubic NURBS surface of a net (k, l, 3) and weights (k, l)."""
    return _tensor_surface(net, lambda count: _b_spline_basis(count, _CUBIC), np.asarray(weights))


def catmull_rom(net: npt.ArrayLike) -> TensorSurface:
    """Return the uniform Catmull-Rom surface of a net (k, l, 3): 2 x 2 bi-cubic patches of 5 x 5, C1.

    It runs through the inner points; like the QOVR surface it begins and ends at the last but one.
    """
    return _tensor_surface(net, _catmull_rom_basis)


_CUBIC = 3

_CATMULL_ROM = np.array([[0, 2, 0, 0], [-1, 0, 1, 0], [2, -5, 4, -1], [-1, 3, -3, 1]]) / 2
"""What four points give to the powers 0 to 3 of the parameter from 0 to 1 between the second and the third."""


def _tensor_surface(
    net: npt.ArrayLike, basis_of: Callable[[int], Basis], weights: Array | None = None
) -> TensorSurface:
    points = np.asarray(net, dtype=np.float64)
    rows, columns = points.shape[:2]
    return TensorSurface(points, basis_of(columns), basis_of(rows), weights)


@cache
def _b_spline_basis(count: int, degree: int) -> Basis:
    """Return the B-splines of a degree over clamped uniform knots; one more than their degree are Bernstein's."""
    from scipy.interpolate import BSpline

    breaks = np.linspace(0.0, 1.0, count - degree + 1)[1:-1]
    knots = np.concatenate([np.zeros(degree + 1), breaks, np.ones(degree + 1)])
    return _basis(count, BSpline(knots, np.eye(count), degree), breaks)


@cache
def _catmull_rom_basis(count: int) -> Basis:
    """Return the cardinal functions of P_0, P_1, ...: inner points are met evenly, half the chord is the tangent.

    They are worked out here, for SciPy takes longer to import than the claims about a document to decide.
    """
    pieces = count - 3
    joints = np.linspace(0.0, 1.0, pieces + 1)
    polynomials = np.stack([_CATMULL_ROM @ np.eye(count)[p : p + 4] for p in range(pieces)])

    def functions(parameters: Array, order: int) -> Array:
        piece = np.clip(np.searchsorted(joints, parameters, side="right") - 1, 0, pieces - 1)
        local = (parameters - joints[piece]) * pieces
        values: Array = np.zeros((len(parameters), count))
        for power in range(_CUBIC, order - 1, -1):
            values = values * local[:, None] + perm(power, order) * polynomials[piece, power]
        return values * float(pieces) ** order

    return Basis(count, functions, read_only(joints[1:-1]))


def _basis(count: int, spline: Any, breaks: Array) -> Basis:
    def functions(parameters: Array, order: int) -> Array:
        values: Array = spline(parameters, nu=order)
        return values

    return Basis(count, functions, read_only(breaks))


def _checked_weights(weights: npt.ArrayLike, shape: tuple[int, int]) -> Array:
    checked = np.array(weights, dtype=np.float64)
    if checked.shape != shape:
        raise ValueError(f"the weights have shape {checked.shape}; expected {shape}")
    if not (np.isfinite(checked) & (checked > 0)).all():
        raise ValueError("a weight is not positive and finite; expected positive weights")
    return read_only(checked)


def _quotient_derivative(lifted: list[list[Array]]) -> Array:
    """Return the highest partial derivative of A / w by Leibniz' rule for A = S w.

    ``lifted[k][l]`` is the derivative of order (k, l) of (A, w), (..., 4).
    """
    result: dict[tuple[int, int], Array] = {}
    for k, row in enumerate(lifted):
        for m, value in enumerate(row):
            numerator = value[..., :3].copy()
            for (a, b), lower in result.items():
                if a <= k and b <= m:
                    numerator -= comb(k, a) * comb(m, b) * lifted[k - a][m - b][..., 3:] * lower
            result[k, m] = numerator / lifted[0][0][..., 3:]
    return result[len(lifted) - 1, len(lifted[0]) - 1]
