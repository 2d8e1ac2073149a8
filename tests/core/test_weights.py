"""The table of facts on one curve, against exact rational arithmetic."""

from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from qovr_core import Knots
from qovr_core.geometry import bernstein
from qovr_core.geometry.weights import transformations, weight_coefficients
from support.documents import knot_values, knots
from support.exact import weights as exact_weights

PARAMETERS = st.floats(0, 1)
HALF = (0.5, 0.5, 0.5, 0.5)


def evaluate(coefficients, u, order=0):
    for _ in range(order):
        coefficients = bernstein.derivative(coefficients, 0)
    return (bernstein.basis(len(coefficients) - 1, [u]) @ coefficients)[0]


def magnitude(coefficients):
    """The weights are sums of terms of this size, so their rounding is a part of it."""
    return np.abs(coefficients).max()


@given(knots, PARAMETERS)
def test_weights_are_those_of_the_definition(knots, u):
    coefficients = weight_coefficients(tuple(knots))
    exact = [float(b) for b in exact_weights(*knots, u)]
    assert evaluate(coefficients, u) == pytest.approx(exact, abs=1e-13 * magnitude(coefficients))


@given(knots, PARAMETERS)
def test_weights_are_a_partition_of_unity(knots, u):
    coefficients = weight_coefficients(tuple(knots))
    assert evaluate(coefficients, u).sum() == pytest.approx(1, abs=1e-13 * magnitude(coefficients))


@given(knots)
def test_the_curve_runs_from_p1_through_p2_to_p3(knots):
    coefficients = weight_coefficients(tuple(knots))
    tolerance = 1e-13 * magnitude(coefficients)
    assert coefficients[0] == pytest.approx([0, 1, 0, 0, 0], abs=1e-13)
    assert evaluate(coefficients, knots.u) == pytest.approx([0, 0, 1, 0, 0], abs=tolerance)
    assert coefficients[-1] == pytest.approx([0, 0, 0, 1, 0], abs=1e-13)


@given(knots)
def test_end_tangents(knots):
    r, _, u, t = knots
    coefficients = weight_coefficients(tuple(knots))
    tolerance = 1e-12 * magnitude(coefficients)
    start = [-((1 - r) ** 2) / (u * r), (1 - 2 * r) / (u * r), r / u, 0, 0]
    end = [0, 0, -(1 - t) / (1 - u), (1 - 2 * t) / ((1 - u) * (1 - t)), t * t / ((1 - u) * (1 - t))]
    assert evaluate(coefficients, 0.0, 1) == pytest.approx(start, abs=tolerance)
    assert evaluate(coefficients, 1.0, 1) == pytest.approx(end, abs=tolerance)


def test_ends_at_the_papers_knots():
    coefficients = weight_coefficients(HALF)
    assert evaluate(coefficients, 0.0, 1) == pytest.approx([-1, 0, 1, 0, 0], abs=1e-13)
    assert evaluate(coefficients, 1.0, 1) == pytest.approx([0, 0, -1, 0, 1], abs=1e-13)
    assert evaluate(coefficients, 0.0, 2) == pytest.approx([8, -22, 22, -10, 2], abs=1e-12)
    assert evaluate(coefficients, 1.0, 2) == pytest.approx([2, -10, 22, -22, 8], abs=1e-12)


@given(knots)
def test_the_true_degree_is_4_only_where_s_equals_u(knots):
    """The leading coefficients, taken exactly: sixth differences of exact weights at seven parameters."""
    sixth = [1, -6, 15, -20, 15, -6, 1]
    values = [exact_weights(*knots, Fraction(k, 6)) for k in range(7)]
    leading = [sum(c * value[j] for c, value in zip(sixth, values, strict=True)) for j in range(5)]
    assert knots.is_quartic == (not any(leading))
    if not knots.is_quartic:
        assert leading[0] == leading[4] == 0
        assert all(leading[1:4])


@given(knot_values, knot_values, knot_values)
def test_a_quartic_curve_is_held_as_its_elevation(r, u, t):
    coefficients = weight_coefficients((r, u, u, t))
    assert Knots(r, u, u, t).is_quartic
    for order in (5, 6):
        highest = np.diff(coefficients, n=order, axis=0)
        assert highest == pytest.approx(np.zeros_like(highest), abs=1e-12 * magnitude(coefficients))


@given(knots, PARAMETERS)
def test_transformations(knots, u):
    values = bernstein.basis(2, [u]) @ np.moveaxis(transformations(tuple(knots)), -1, 0)
    a = (knots.s - knots.u) / (knots.u**2 - knots.u)
    expected = [
        (1 - knots.r) / knots.u * u + knots.r,
        a * u * u + (1 - a) * u,
        knots.t / (1 - knots.u) * (u - knots.u),
    ]
    assert values[0] == pytest.approx(expected, abs=1e-11)


def test_cut_kernels_keep_the_unity_only_where_four_decimals_hold_them():
    u = np.linspace(0, 1, 101)
    sums = {
        case: bernstein.basis(6, u) @ weight_coefficients(case, kernel_decimals=4).sum(axis=-1)
        for case in (HALF, (0.4, 0.6, 0.7, 0.4), (0.3, 0.5, 0.5, 0.7))
    }
    assert np.abs(sums[HALF] - 1).max() < 1e-14
    assert np.abs(sums[0.4, 0.6, 0.7, 0.4] - 1).max() < 1e-13
    off = np.abs(sums[0.3, 0.5, 0.5, 0.7] - 1).max()
    assert 1e-5 < off < 1e-4


def test_many_curves_at_once():
    several = np.random.default_rng(3).uniform(0.1, 0.9, (2, 5, 4))
    stacked = weight_coefficients(several)
    assert stacked.shape == (2, 5, 7, 5)
    assert np.array_equal(stacked[1, 2], weight_coefficients(several[1, 2]))
