"""Where a polynomial with rational coefficients changes its sign, decided in rational arithmetic."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from itertools import pairwise
from math import lcm

Polynomial = Sequence[Fraction]
"""The coefficients of 1, x, x^2, ...; the last is not 0, and none are left of the polynomial 0."""

_BITS = 40
"""Roots are found to 2^-40 of [0, 1]; whether there are any needs no such limit."""


def sign_changes(polynomial: Polynomial) -> list[float]:
    """Return where in (0, 1] a polynomial changes its sign, in order.

    A root at which it only touches 0 is none of them, however near another polynomial comes to it.

    Examples
    --------
    >>> once, twice = [Fraction(-1, 3), Fraction(1)], [Fraction(1, 4), Fraction(-1), Fraction(1)]
    >>> [round(place, 9) for place in sign_changes(product(once, twice))]
    [0.333333333]
    """
    odd = _odd_part(trimmed(polynomial))
    if len(odd) < 2:
        return []
    chain = [_whole(each) for each in _sturm_chain(odd)]
    return _roots(chain, 0, 0, _changes(chain, 0, 0), _changes(chain, 1, 0))


def trimmed(coefficients: Polynomial) -> list[Fraction]:
    """Return a polynomial without the zeros in its highest places."""
    kept = list(coefficients)
    while kept and kept[-1] == 0:
        kept.pop()
    return kept


def product(a: Polynomial, b: Polynomial) -> list[Fraction]:
    """Return the product of two polynomials."""
    result = [Fraction(0)] * max(len(a) + len(b) - 1, 0)
    for i, x in enumerate(a):
        for j, y in enumerate(b):
            result[i + j] += x * y
    return result


def derivative(polynomial: Polynomial) -> list[Fraction]:
    """Return the derivative of a polynomial."""
    return [k * coefficient for k, coefficient in enumerate(polynomial)][1:]


def _divided(a: Polynomial, b: Polynomial) -> tuple[list[Fraction], list[Fraction]]:
    """Return quotient and remainder."""
    rest, quotient = list(a), [Fraction(0)] * max(len(a) - len(b) + 1, 0)
    for k in reversed(range(len(quotient))):
        quotient[k] = rest[k + len(b) - 1] / b[-1]
        for j, y in enumerate(b):
            rest[k + j] -= quotient[k] * y
    return quotient, trimmed(rest[: len(b) - 1])


def _common(a: Polynomial, b: Polynomial) -> Polynomial:
    """Return the greatest common divisor of two polynomials, its highest coefficient 1."""
    while b:
        a, b = b, _divided(a, b)[1]
    return [x / a[-1] for x in a]


def _odd_part(polynomial: Polynomial) -> Polynomial:
    """Return the product of the factors that occur an odd number of times, each once (Yun's algorithm)."""
    repeated = _common(polynomial, derivative(polynomial)) if len(polynomial) > 1 else [Fraction(1)]
    several: Polynomial = _divided(polynomial, repeated)[0]  # every factor once
    result: Polynomial = [Fraction(1)]
    is_odd = True
    while len(several) > 1:
        more_often = _common(several, repeated)
        if is_odd:
            result = product(result, _divided(several, more_often)[0])
        several, repeated = more_often, _divided(repeated, more_often)[0]
        is_odd = not is_odd
    return result


def _sturm_chain(polynomial: Polynomial) -> list[Polynomial]:
    chain: list[Polynomial] = [polynomial, derivative(polynomial)]
    while chain[-1]:
        chain.append([-x for x in _divided(chain[-2], chain[-1])[1]])
    return chain[:-1]


def _whole(polynomial: Polynomial) -> list[int]:
    """Return a positive multiple with whole coefficients."""
    factor = lcm(*(x.denominator for x in polynomial))
    return [int(x * factor) for x in polynomial]


def _changes(chain: Sequence[Sequence[int]], number: int, bits: int) -> int:
    """Return how often the values of a Sturm chain at number / 2^bits change their sign."""
    signs = []
    for coefficients in chain:
        value, scale = 0, 1
        for coefficient in reversed(coefficients):
            value = value * number + coefficient * scale
            scale <<= bits
        if value:
            signs.append(value > 0)
    return sum(a != b for a, b in pairwise(signs))


def _roots(chain: Sequence[Sequence[int]], number: int, bits: int, at_low: int, at_high: int) -> list[float]:
    """Return the roots between number / 2^bits and the next such place, given the changes of the chain at both."""
    if at_low == at_high:
        return []
    if bits == _BITS:
        return [(number + 0.5) / 2.0**bits] * (at_low - at_high)
    at_middle = _changes(chain, 2 * number + 1, bits + 1)
    lower = _roots(chain, 2 * number, bits + 1, at_low, at_middle)
    return lower + _roots(chain, 2 * number + 1, bits + 1, at_middle, at_high)
