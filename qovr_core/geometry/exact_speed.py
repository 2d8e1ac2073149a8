"""The speed of a curve over evenly spaced points, sum_j j b_j'(u), in rational arithmetic."""

from __future__ import annotations

from fractions import Fraction

from qovr_core.geometry.exact_roots import derivative, product
from qovr_core.geometry.knots import Knots


def exact_speed(knots: Knots) -> list[Fraction]:
    """Return the speed as coefficients of 1, u, u^2, ..., for the very numbers that the knots are."""
    r, s, u, t = (Fraction(knot) for knot in knots)
    a = (s - u) / (u * u - u)
    zero, one = Fraction(0), Fraction(1)
    transformed = [r, (1 - r) / u, zero], [zero, 1 - a, a], [-t * u / (1 - u), t / (1 - u), zero]
    blends = [one, -2 * one, one], [zero, 2 * one, -2 * one], [zero, zero, one]
    position = [zero] * 7
    for p, (x, blend, knot) in enumerate(zip(transformed, blends, (r, s, t), strict=True)):
        c = (1 - 2 * knot) / (knot * (1 - knot))
        parabola = [-c * square for square in product(x, x)]
        for k in range(3):
            parabola[k] += (2 + c) * x[k]
        parabola[0] += p
        position = [before + more for before, more in zip(position, product(blend, parabola), strict=True)]
    return derivative(position)
