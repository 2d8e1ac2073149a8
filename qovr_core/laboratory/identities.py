"""Identities of the paper's curve and surfaces, proved in exact rational arithmetic.

Each says that a rational function N / D of some variables is 0. N is a polynomial; if its degree in every variable is
known not to exceed d, and it is 0 on a grid of d + 1 values a variable, it is 0 everywhere. With D as the product of
what is divided by, the degrees are counted in the comments.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from functools import cache
from itertools import product
from typing import Any

import numpy as np

from qovr_core.geometry.weights import CURVE_DEGREE
from qovr_core.laboratory import exact
from qovr_core.laboratory.exact import Exact

_FIRST = 2
"""Grids begin here: what is divided by are variables x and 1 - x, and on integers from 2 on none of them is 0."""

PARABOLA_DEGREES = (3, 4)
"""Of a parabola's weights, times D = k (1-k) u^2 (1-u)^2, in its own knot k and in u_ip, and of their derivatives.

u r(u), u (1-u) s(u) and (1-u) t(u) are of degree 1 in k, and of degree 1, 2 and 1 in u_ip. Squared, and times
k (1-k) M^-1, whose rows for x^2, x and 1 are of degree 1, 2 and 2 in k, they are of degree 3 in k, and with what else
there is of D of degree 4 in u_ip."""

_ENDS = ((0, 1, 0, 0, 0), (0, 0, 0, 1, 0))


def vanishes(function: Callable[..., Any], *degrees: int) -> bool:
    """Return whether a rational function, or an array of them, is 0 for all values of its variables.

    Parameters
    ----------
    function : of as many fractions as there are degrees; it divides by no more than its variables x and by 1 - x
    degrees : which its numerator does not exceed, by variable

    Examples
    --------
    >>> vanishes(lambda x, y: (x + y) ** 2 - x * x - 2 * x * y - y * y, 2, 2)
    True
    >>> vanishes(lambda x: (x - 2) * (x - 3), 2)
    False
    """
    grids = (map(Fraction, range(_FIRST, _FIRST + degree + 1)) for degree in degrees)
    return all(not number for place in product(*grids) for number in np.ravel(function(*place)))


def vanishes_for_all_curves(function: Callable[[Fraction, Fraction, Fraction, Fraction], Any]) -> bool:
    """Return whether something made of the weights of a curve is 0 for all knots r, s, u, t.

    The weights are a sum over three parabolas that share u_ip and know one more knot each. So what is linear in them is
    0 for all knots if it is for all values of u_ip and of one other knot at a time.

    Parameters
    ----------
    function : linear in the weights; what else is in it is such a sum, too, and of no higher degree
    """
    rest = Fraction(_FIRST)
    return (
        vanishes(lambda r, u: function(r, rest, u, rest), *PARABOLA_DEGREES)
        and vanishes(lambda s, u: function(rest, s, u, rest), *PARABOLA_DEGREES)
        and vanishes(lambda t, u: function(rest, rest, u, t), *PARABOLA_DEGREES)
    )


@cache
def kernels_invert() -> bool:
    """M M^-1 = I: k (1-k) M^-1 and M are of degree 2 in k."""
    return vanishes(lambda k: exact.kernel(k) @ exact.inverse_kernel(k) - np.eye(3, dtype=int), 4)


@cache
def weights_sum_to_one() -> bool:
    """b_0 + ... + b_4 = 1."""
    one = [1] + [0] * CURVE_DEGREE
    return vanishes_for_all_curves(lambda *knots: exact.weights(*knots).sum(axis=1) - one)


@cache
def unit_rows_sum_to_one() -> bool:
    """The weights sum to 1 for all kernels whose rows sum to 0, 0, 1: the sum asks for nothing else of a kernel.

    Only w_p is left of w_p [x^2 x 1] (0, 0, 1)^T, which is of degree 0 in the knots; with u (1-u) as D for the others
    it is of degree 1 and 2.
    """
    one = [1] + [0] * CURVE_DEGREE

    def excess(own: Fraction, middle: Fraction) -> Any:
        sums = [exact.monomials(p, own, middle) @ [0, 0, 1] for p in range(exact.PARABOLAS)]
        return np.sum(sums, axis=0) - one

    return vanishes(excess, 1, 2)


@cache
def quartic_where_s_is_u() -> bool:
    """Where s_ip = u_ip no power of u above the fourth is left, whatever the kernels: those of w_p x^2, w_p x, w_p.

    u r(u) and (1-u) t(u) are of degree 1 in both knots, and where s_ip = u_ip u (1-u) s(u) is of degree 2 in it; the
    squares count. Sums of such curves, and their products with what depends on v alone, are of degree four in u; the
    mean of knots with s_ip = u_ip is of that kind too.
    """
    high = slice(CURVE_DEGREE - 1, None)
    outer = (vanishes(lambda own, u, p=p: exact.monomials(p, own, u)[high], 2, 2) for p in (0, 2))
    return all(outer) and vanishes(lambda u: exact.monomials(1, u, u)[high], 4)


@cache
def curves_end_on_points() -> bool:
    """b(0) = [0 1 0 0 0] and b(1) = [0 0 0 1 0]."""
    return vanishes_for_all_curves(lambda *knots: exact.end_rows(exact.weights(*knots)) - _ENDS)


def start_tangent(r: Fraction, u: Fraction) -> Exact:
    """Return the weights of C'(0), (5,)."""
    return np.array([-((1 - r) ** 2) / (u * r), (1 - 2 * r) / (u * r), r / u, 0, 0], dtype=object)


def end_tangent(u: Fraction, t: Fraction) -> Exact:
    """Return the weights of C'(1), (5,)."""
    return np.array([0, 0, -(1 - t) / (1 - u), (1 - 2 * t) / ((1 - u) * (1 - t)), t**2 / ((1 - u) * (1 - t))], object)


@cache
def tangents_are_known() -> bool:
    """b'(0) and b'(1) are ``start_tangent`` and ``end_tangent``: times D these are of degree 3 in r and in t."""

    def excess(r: Fraction, s: Fraction, u: Fraction, t: Fraction) -> Any:
        return exact.end_rows(exact.weights(r, s, u, t), 1) - [start_tangent(r, u), end_tangent(u, t)]

    return vanishes_for_all_curves(excess)


def tangent_ratio(left: Fraction, tau: Fraction, right: Fraction) -> Fraction:
    """Return lambda, by which a tangent left of a smooth joint is that right of it.

    Parameters
    ----------
    left, right : u_ip on either side
    tau : t_ip left of the joint, r_ip right of it
    """
    return right * tau / ((1 - left) * (1 - tau))


@cache
def tangents_meet() -> bool:
    """Across a joint with t_ip = r_ip = tau tangents differ by the factor lambda alone.

    D is tau (1-tau) (1-left) right, which ``end_tangent`` and lambda times ``start_tangent`` divide by.
    """

    def excess(left: Fraction, tau: Fraction, right: Fraction) -> Any:
        return end_tangent(left, tau)[2:] - tangent_ratio(left, tau, right) * start_tangent(tau, right)[:3]

    return vanishes(excess, 1, 3, 1)


@cache
def tangents_agree() -> bool:
    """lambda = 1 where tau / (1 - u_ip) left = (1 - tau) / u_ip right, over (1-left) tau."""
    return vanishes(lambda left, tau: tangent_ratio(left, tau, (1 - left) * (1 - tau) / tau) - 1, 1, 2)


@cache
def curvature_begins_before() -> bool:
    """b_0''(1) = 2 (1-r)^2 (1-u) / (u^2 r), which is above 0 whatever the knots; times D of degree 3 in r and u."""

    def excess(r: Fraction, s: Fraction, u: Fraction, t: Fraction) -> Any:
        weight = exact.end_rows(exact.weights(r, s, u, t), 2)[1, 0]
        return weight - 2 * (1 - r) ** 2 * (1 - u) / (u * u * r)

    return vanishes_for_all_curves(excess)


@cache
def boolean_sum_ends_on_curves() -> bool:
    """Where the weights along u are 0 or 1 whatever the knots, only K_j is left of the Boolean sum, and C_i along v.

    Every summand is of degree 1 in each of the two weights across.
    """
    return all(
        vanishes(lambda mean, own, end=end: exact.boolean_share(mean, end, end, own) - end * own, 1, 1)
        and vanishes(lambda own, mean, end=end: exact.boolean_share(end, own, mean, end) - end * own, 1, 1)
        for end in (0, 1)
    )


@cache
def equal_curves_make_products() -> bool:
    """Where the rows, or the columns, have one weight, the Boolean sum is a product of own weights, linear in each."""
    return vanishes(
        lambda mean, along, across: exact.boolean_share(mean, along, along, across) - along * across, 1, 1, 1
    ) and vanishes(
        lambda mean, along, across: exact.boolean_share(across, along, mean, across) - along * across, 1, 1, 1
    )


@cache
def boxes_are_mapped() -> bool:
    """m raw + n of (61)-(65) takes both ends of the raw box to those of the control box; m > 0 keeps their order.

    Over the raw extent the numerator is of degree 1 in every variable, and 2 in that extent.
    """

    def excess(low: Fraction, extent: Fraction, wanted: Fraction, wanted_extent: Fraction) -> Any:
        ends, wanted_ends = (np.array([a, a + width], object) for a, width in ((low, extent), (wanted, wanted_extent)))
        m = (wanted_ends[1] - wanted_ends[0]) / (ends[1] - ends[0])
        n = wanted_ends[0] - m * ends[0]
        return m * ends + n - wanted_ends

    return vanishes(excess, 1, 2, 1, 1)
