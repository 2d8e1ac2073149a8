"""Where a curve folds back, against exact rational arithmetic that shares nothing with the program."""

from fractions import Fraction
from itertools import pairwise
from math import comb

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from qovr_core import Knots
from qovr_core.geometry.exact_roots import sign_changes
from qovr_core.geometry.folding import MOST_FOLDS, folding_parts, folds, forward_range
from qovr_core.geometry.knots import KNOT_NAMES
from support.documents import knots
from support.exact import weights as exact_weights

U = [Fraction(k, 512) for k in range(513)]
_NOT_SETTLED = 60
"""Halvings after which the oracle gives up: it ends only where the speed does not touch 0."""


def position(curve, u):
    """Return sum_j j b_j(u), exactly."""
    return sum(j * weight for j, weight in enumerate(exact_weights(*curve, u)))


def bernstein_speed(curve):
    """Return the exact Bernstein coefficients of the speed, by way of the position at seven places."""
    values = [position(curve, Fraction(k, 6)) for k in range(7)]
    rows = [[comb(6, k) * Fraction(i, 6) ** k * Fraction(6 - i, 6) ** (6 - k) for k in range(7)] for i in range(7)]
    for column in range(7):  # Gauss, with rows that never need to be exchanged: the matrix is totally positive
        for row in range(7):
            if row != column:
                factor = rows[row][column] / rows[column][column]
                rows[row] = [a - factor * b for a, b in zip(rows[row], rows[column], strict=True)]
                values[row] -= factor * values[column]
    coefficients = [value / rows[k][k] for k, value in enumerate(values)]
    return [6 * (b - a) for a, b in pairwise(coefficients)]


def is_negative_somewhere(coefficients, depth=0):
    """Decide by halving until every piece has coefficients of one sign, or an end below 0."""
    if min(coefficients) >= 0:
        return False
    if min(coefficients[0], coefficients[-1]) < 0:
        return True
    assert depth < _NOT_SETTLED
    left, right, row = [], [], coefficients
    while row:
        left.append(row[0])
        right.insert(0, row[-1])
        row = [(a + b) / 2 for a, b in pairwise(row)]
    return is_negative_somewhere(left, depth + 1) or is_negative_somewhere(right, depth + 1)


def speed_at(coefficients, u):
    return sum(c * comb(5, k) * u**k * (1 - u) ** (5 - k) for k, c in enumerate(coefficients))


def test_the_two_of_the_definition():
    assert folds([(0.5, 0.2, 0.2, 0.5), (0.5, 0.2, 0.5, 0.5)]).tolist() == [True, False]
    assert folding_parts(Knots(s=0.2)) == ()
    ((low, high),) = folding_parts(Knots(s=0.2, u=0.2))
    # By hand: the parabolas are 1 + 5u, 1 + 5.75u - 3.75u^2 and 1.75 + 1.25u.
    u = np.poly1d([1, 0])
    x = (1 - u) ** 2 * (1 + 5 * u) + 2 * u * (1 - u) * (1 + 5.75 * u - 3.75 * u**2) + u**2 * (1.75 + 1.25 * u)
    assert [low, high] == pytest.approx(sorted(root for root in x.deriv().roots.real if 0 < root < 1))


@given(knots)
@example(Knots(0.05, 0.95, 0.05, 0.95))
@example(Knots())
def test_folding_is_what_exact_arithmetic_says(curve):
    speed = bernstein_speed(curve)
    expected = is_negative_somewhere(speed)
    assert bool(folds(tuple(curve))) == expected
    parts = folding_parts(curve)
    assert bool(parts) == expected
    assert len(parts) <= MOST_FOLDS
    ends = [end for part in parts for end in part]
    assert ends == sorted(ends)
    for u in U:
        if all(abs(u - end) > 1e-9 for end in ends):
            assert (speed_at(speed, u) < 0) == any(low < u < high for low, high in parts)


@settings(max_examples=12)
@given(knots, st.sampled_from(KNOT_NAMES))
def test_the_last_number_that_does_not_fold_is_told_from_the_next(curve, name):
    """Halve between a knot that folds and one that does not down to two neighbouring numbers."""
    values = {bool(folds(tuple(Knots(**{**vars_of(curve), name: v})))): v for v in np.arange(1, 100) / 100}
    if len(values) < 2:
        return
    forward, back = values[False], values[True]
    while (middle := (forward + back) / 2) not in (forward, back):
        if folding_parts(Knots(**{**vars_of(curve), name: middle})):
            back = middle
        else:
            forward = middle
    for value, expected in ((forward, False), (back, True)):
        changed = Knots(**{**vars_of(curve), name: value})
        assert bool(folds(tuple(changed))) == expected == is_negative_somewhere(bernstein_speed(changed))


def vars_of(curve):
    return dict(zip(KNOT_NAMES, curve, strict=True))


def test_many_curves_at_once_and_knots_at_the_ends_of_what_floats_hold():
    several = np.random.default_rng(5).uniform(0.02, 0.98, (40, 5, 4))
    answer = folds(several)
    assert answer.shape == (40, 5)
    assert answer[7, 3] == folds(several[7, 3])
    for k in (1e-300, 5e-324, 1 - 2**-53):
        for column in range(4):
            curve = [0.5] * 4
            curve[column] = k
            assert bool(folds(curve)) == is_negative_somewhere(bernstein_speed(curve))


def test_the_range_of_one_knot():
    """The design's ranges, the rest at 0.5."""
    assert forward_range(Knots(), "s") == pytest.approx((0.145, 0.855), abs=2e-3)
    low, high = forward_range(Knots(), "r")
    assert (low, high) == pytest.approx((0.172, 0.999), abs=2e-3)
    assert forward_range(Knots(), "t") == pytest.approx((1 - high, 1 - low), abs=2e-3)
    for curve, name in ((Knots(s=0.05), "s"), (Knots(r=0.1), "r"), (Knots(u=0.9), "u")):
        assert folds(tuple(curve))
        low, high = forward_range(curve, name)
        assert not (low <= getattr(curve, name) <= high)
        assert not any(folds(tuple(Knots(**{**vars_of(curve), name: v}))) for v in np.linspace(low, high, 31))
    assert forward_range(Knots(s=0.2, u=0.2), "s") is None


@pytest.mark.parametrize(
    ("roots", "changes"),
    [
        ({}, []),
        ({0.25: 1}, [0.25]),
        ({0.25: 2}, []),
        ({0.25: 3, 0.5: 2}, [0.25]),
        ({0.25: 4, 0.75: 1}, [0.75]),
        ({0.25: 1, 0.25 + 2.0**-45: 1}, [0.25, 0.25]),
        ({1.0: 1, -0.5: 1, 1.5: 3}, [1.0]),
    ],
)
def test_touching_is_no_change_of_sign(roots, changes):
    polynomial = [Fraction(3)]
    for root, times in roots.items():
        for _ in range(times):
            shifted, padded = [Fraction(0), *polynomial], [*polynomial, Fraction(0)]
            polynomial = [a - Fraction(root) * b for a, b in zip(shifted, padded, strict=True)]
    assert sign_changes(polynomial) == pytest.approx(changes, abs=1e-11)
