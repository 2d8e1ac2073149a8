"""The paper's curve in exact rational numbers, term by term: what proofs are about.

Polynomials in u are arrays of their coefficients, by growing powers along the first axis.
"""

from __future__ import annotations

from fractions import Fraction
from functools import cache
from typing import Any

import numpy as np
import numpy.typing as npt

from qovr_core.arrays import read_only

Exact = npt.NDArray[np.object_]
"""An array of fractions and integers."""

BLENDS = ((1, -2, 1), (0, 2, -2), (0, 0, 1))
"""(1 - u)^2, 2 u (1 - u) and u^2 of (5)-(7)."""

PARABOLAS = len(BLENDS)

_POWERS, _POINTS = 7, 5


def kernel(k: Fraction) -> Exact:
    """Return the kernel M of (14)-(16), (3, 3)."""
    return _exact([[0, 0, 1], [k * k, k, 1], [1, 1, 1]])


def inverse_kernel(k: Fraction) -> Exact:
    """Return its inverse as (17), (21), (22) print it, (3, 3)."""
    return _exact([[1 / k, 1 / (k * (k - 1)), 1 / (1 - k)], [-(k + 1) / k, 1 / (k * (1 - k)), k / (k - 1)], [1, 0, 0]])


def transformation(p: int, own: Fraction, middle: Fraction) -> Exact:
    """Return r(u), s(u) or t(u) of (24)-(26), (3,).

    Parameters
    ----------
    p : 0, 1 or 2, the number of the parabola
    own : its own knot r_ip, s_ip or t_ip
    middle : u_ip
    """
    a = (own - middle) / (middle * middle - middle)
    slope = own / (1 - middle)
    return _exact([[own, (1 - own) / middle, 0], [0, 1 - a, a], [-slope * middle, slope, 0]][p])


def monomials(p: int, own: Fraction, middle: Fraction) -> Exact:
    """Return w_p x^2, w_p x and w_p of (23), where x is r(u), s(u) or t(u), as (7, 3)."""
    x, one = transformation(p, own, middle), _exact([1])
    table = np.zeros((_POWERS, 3), dtype=object)
    for column, factor in enumerate((np.convolve(x, x), x, one)):
        product = np.convolve(_exact(BLENDS[p]), factor)
        table[: len(product), column] = product
    return table


@cache
def parabola(p: int, own: Fraction, middle: Fraction) -> Exact:
    """Return the weights that the parabola p gives to its three points, w_p [x^2 x 1] M^-1 of (23), (7, 3)."""
    return read_only(monomials(p, own, middle) @ inverse_kernel(own))


@cache
def weights(r: Fraction, s: Fraction, u: Fraction, t: Fraction) -> Exact:
    """Return the five weights of a curve with these knots, (7, 5)."""
    table = np.zeros((_POWERS, _POINTS), dtype=object)
    for p, own in enumerate((r, s, t)):
        table[:, p : p + 3] += parabola(p, own, u)
    return read_only(table)


def end_rows(polynomials: Exact, order: int = 0) -> Exact:
    """Return derivatives of polynomials (7, ...) at 0 and at 1, (2, ...)."""
    for _ in range(order):
        polynomials = (polynomials.T * np.arange(len(polynomials))).T[1:]
    return np.stack([polynomials[0], polynomials.sum(axis=0)])


def values(polynomials: Exact, u: Fraction) -> Exact:
    """Return polynomials (7, ...) at u, (...)."""
    powers = _exact([u**k for k in range(len(polynomials))])
    result: Exact = powers @ polynomials
    return result


def boolean_share(mean_across: Any, along: Any, mean_along: Any, across: Any) -> Any:
    """Return the weight of one point P_ij in the Boolean-sum surface.

    Parameters
    ----------
    mean_across : its weight along v for the mean of the column knots, or a derivative of that; so below
    along : along u on its own row curve C_i
    mean_along : along u for the mean of the row knots
    across : along v on its own column curve K_j
    """
    return mean_across * along + mean_along * across - mean_along * mean_across


def _exact(numbers: Any) -> Exact:
    return np.array(numbers, dtype=object)
