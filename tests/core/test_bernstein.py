import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from qovr_core.geometry import bernstein

coefficient = st.floats(-10, 10)
polynomial = st.lists(coefficient, min_size=1, max_size=7).map(np.array)
GRID = np.linspace(-0.5, 1.5, 11)


def values(coefficients, at=GRID):
    return bernstein.basis(len(coefficients) - 1, at) @ coefficients


@pytest.mark.parametrize("degree", range(7))
def test_the_basis_is_exact_at_the_ends_and_sums_to_one(degree):
    basis = bernstein.basis(degree, [0.0, 1.0, 0.3])
    assert basis[0].tolist() == [1.0] + [0.0] * degree
    assert basis[1].tolist() == [0.0] * degree + [1.0]
    assert basis[2].sum() == pytest.approx(1, abs=1e-15)


@given(polynomial, polynomial)
def test_product(a, b):
    assert values(bernstein.product(a, b)) == pytest.approx(values(a) * values(b), rel=1e-9, abs=1e-8)


@given(polynomial)
def test_elevation(a):
    assert values(bernstein.elevation(len(a) - 1, 8) @ a) == pytest.approx(values(a), rel=1e-9, abs=1e-8)


@given(st.lists(coefficient, min_size=2, max_size=7).map(np.array))
def test_derivative(a):
    step = 1e-5
    slope = (values(a, GRID + step) - values(a, GRID - step)) / (2 * step)
    assert values(bernstein.derivative(a, 0)) == pytest.approx(slope, rel=1e-5, abs=1e-4)


@given(polynomial)
def test_halving(a):
    left, right = (half @ a for half in bernstein.halving(len(a) - 1))
    u = np.linspace(0, 1, 7)
    assert values(left, u) == pytest.approx(values(a, u / 2), abs=1e-12)
    assert values(right, u) == pytest.approx(values(a, (1 + u) / 2), abs=1e-12)


def test_parameters_must_be_one_dimensional():
    with pytest.raises(ValueError, match=r"shape \(2, 2\); expected one dimension"):
        bernstein.basis(3, np.zeros((2, 2)))


def from_roots(places):
    """Return the Bernstein coefficients of the polynomial with these roots."""
    result = np.ones(1)
    for place in places:
        result = bernstein.product(result, np.array([-place, 1 - place]))
    return result


@given(st.lists(st.sampled_from([0.0, 0.125, 0.3, 0.5, 0.7, 0.99, 1.0]), max_size=5, unique=True))
def test_roots(places):
    beyond = bernstein.product(from_roots(places), from_roots([-2.0, 1.5]))
    assert sorted(bernstein.roots(beyond)) == pytest.approx(sorted(places), abs=1e-9)


@pytest.mark.parametrize("place", [0.0, 0.4, 1.0])
def test_a_double_root_is_found(place):
    found = bernstein.roots(from_roots([place, place, 0.8]))
    assert len(found) in (2, 3)
    assert {round(root, 5) for root in found.tolist()} == {place, 0.8}


def test_no_polynomial_has_all_roots():
    assert bernstein.roots(np.zeros(7)).size == 0
