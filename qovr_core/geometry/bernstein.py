"""Polynomials in Bernstein form, eq. (3): bases, products, degree elevation, differences, halving, roots."""

from __future__ import annotations

from functools import cache
from math import comb

import numpy as np
import numpy.typing as npt

from qovr_core.arrays import Array, read_only

ROOT_TOLERANCE = 1e-6
"""How far a double root may come out from [0, 1], from the real axis, and from its twin: the square root of the
precision of its coefficients."""


@cache
def binomials(degree: int) -> Array:
    """Return the binomial coefficients of a degree, (degree + 1,) float64."""
    return read_only(np.array([comb(degree, k) for k in range(degree + 1)], dtype=np.float64))


def checked_parameters(parameters: npt.ArrayLike) -> Array:
    """Return parameters as (n,) float64; what is not one-dimensional raises ValueError."""
    x = np.asarray(parameters, dtype=np.float64)
    if x.ndim != 1:
        raise ValueError(f"parameters have shape {x.shape}; expected one dimension")
    return x


def basis(degree: int, parameters: npt.ArrayLike) -> Array:
    """Return the Bernstein polynomials B_{k,degree} of (3) at parameters.

    Parameters
    ----------
    degree : 0 or more
    parameters : (n,) any real numbers; the patch's domain is [0, 1]

    Returns
    -------
    (n, degree + 1) float64; each row sums to 1, and is exact at 0 and 1

    Raises
    ------
    ValueError : the parameters are not one-dimensional
    """
    x = checked_parameters(parameters)
    powers = np.empty((2, degree + 1, x.size))
    powers[:, 0] = 1
    for k in range(degree):
        np.multiply(powers[0, k], x, out=powers[0, k + 1])
        np.multiply(powers[1, k], 1 - x, out=powers[1, k + 1])
    values: Array = powers[0] * powers[1, ::-1] * binomials(degree)[:, None]
    return values.T


@cache
def _product_tensor(degree_a: int, degree_b: int) -> Array:
    tensor = np.zeros((degree_a + degree_b + 1, degree_a + 1, degree_b + 1))
    for i in range(degree_a + 1):
        for j in range(degree_b + 1):
            tensor[i + j, i, j] = comb(degree_a, i) * comb(degree_b, j)
    tensor /= binomials(degree_a + degree_b)[:, None, None]
    return read_only(tensor)


def product(a: Array, b: Array) -> Array:
    """Return the product of polynomials given by their Bernstein coefficients in the last axis.

    Parameters
    ----------
    a : (..., p + 1)
    b : (..., q + 1), its leading axes broadcastable with those of ``a``

    Returns
    -------
    (..., p + q + 1) float64
    """
    result: Array = np.einsum("kij,...i,...j->...k", _product_tensor(a.shape[-1] - 1, b.shape[-1] - 1), a, b)
    return result


@cache
def elevation(degree: int, to_degree: int) -> Array:
    """Return the matrix (to_degree + 1, degree + 1) that raises Bernstein coefficients to a higher degree."""
    return read_only(_product_tensor(degree, to_degree - degree).sum(axis=2))


def derivative(coefficients: Array, axis: int) -> Array:
    """Return the Bernstein coefficients of the derivative along an axis, one degree lower."""
    degree = coefficients.shape[axis] - 1
    result: Array = degree * np.diff(coefficients, axis=axis)
    return result


def partial_derivative(coefficients: Array, orders: tuple[int, int], axes: tuple[int, int]) -> Array:
    """Return the Bernstein coefficients of a partial derivative along two axes, of an order from 0 along each.

    Raises
    ------
    ValueError : an order is outside 0 to the degree
    """
    for order, axis in zip(orders, axes, strict=True):
        degree = coefficients.shape[axis] - 1
        if not 0 <= order <= degree:
            raise ValueError(f"derivative orders are {orders[0]} and {orders[1]}; expected 0 to {degree}")
        for _ in range(order):
            coefficients = derivative(coefficients, axis)
    return coefficients


@cache
def halving(degree: int) -> tuple[Array, Array]:
    """Return the matrices (degree + 1, degree + 1) that restrict coefficients to [0, 1/2] and to [1/2, 1]."""
    left = np.zeros((degree + 1, degree + 1))
    for k in range(degree + 1):
        left[k, : k + 1] = binomials(k) / 2.0**k
    return read_only(left), read_only(left[::-1, ::-1].copy())


def restriction(degree: int, start: float, end: float) -> Array:
    """Return the matrix (degree + 1, degree + 1) that restricts Bernstein coefficients to [start, end] of [0, 1].

    Its entries are never negative and each row sums to 1, so it enlarges no rounding.
    """
    matrix = np.zeros((degree + 1, degree + 1))
    for k, row in enumerate(matrix):
        row[0] = 1  # the blossom at degree - k times the start and k times the end
        for x in (start,) * (degree - k) + (end,) * k:
            row[1:] = (1 - x) * row[1:] + x * row[:-1]
            row[0] *= 1 - x
    return read_only(matrix)


def roots(coefficients: Array) -> Array:
    """Return the roots in [0, 1] of one polynomial; a double root comes out once or twice.

    Parameters
    ----------
    coefficients : (degree + 1,) in Bernstein form

    Returns
    -------
    (k,) float64 in no order; none where all coefficients are 0
    """
    if not coefficients.any():
        return np.empty(0)
    # In x = t / (1 - t) the polynomial has these coefficients, times a power of 1 - t; t = 1 is x at infinity,
    # where NumPy finds no root.
    degree = coefficients.size - 1
    x = np.roots((coefficients * binomials(degree))[::-1])
    at_one = np.ones(degree - x.size)
    x = x[np.abs(1 + x) > ROOT_TOLERANCE]
    t = x / (1 + x)
    is_inside = (np.abs(t.imag) <= ROOT_TOLERANCE) & (np.abs(t.real - 0.5) <= 0.5 + ROOT_TOLERANCE)
    return np.concatenate([at_one, np.clip(t[is_inside].real, 0.0, 1.0)])
