"""Proofs in exact arithmetic: of the formulas that the program computes with, and not of wrong ones."""

from fractions import Fraction
from itertools import product
from math import comb

import numpy as np
import pytest
from hypothesis import given, settings

from qovr_core import FORMULATIONS, Formulation
from qovr_core.construction import window_arrays
from qovr_core.geometry import bernstein
from qovr_core.geometry.kernels import inverse_kernels, kernels
from qovr_core.geometry.weights import weight_coefficients
from qovr_core.laboratory import exact, identities, mirror_identities
from qovr_core.laboratory.claims import CLAIMS
from support.documents import knots, random_document

U, V = Fraction(1, 3), Fraction(4, 7)

PROOFS = {
    f"{claim.name}, {formulation}": proof for claim in CLAIMS.values() for formulation, proof in claim.proofs.items()
}
KERNELS, TRANSFORMATIONS, BLENDS, BOOLEAN_SUM = "inverse_kernel", "transformation", "BLENDS", "boolean_share"
CURVE, ALL = (KERNELS, TRANSFORMATIONS, BLENDS), (KERNELS, TRANSFORMATIONS, BLENDS, BOOLEAN_SUM)

RESTS_ON = {
    **dict.fromkeys(("inverse, double-sum", "inverse, interpolating"), (KERNELS,)),
    **dict.fromkeys(("unity, double-sum", "unity, interpolating"), (KERNELS, BLENDS)),
    "unity, published": (BLENDS,),
    **dict.fromkeys((f"quartic, {name}" for name in FORMULATIONS), (TRANSFORMATIONS,)),
    **dict.fromkeys(
        (f"{name}, interpolating" for name in ("C0", "C1", "G1", "C2", "edges", "edges'", "symmetry")), ALL
    ),
    **dict.fromkeys(("C2, double-sum", "symmetry, double-sum", "symmetry, published"), CURVE),
    **dict.fromkeys((f"boxes, {name}" for name in FORMULATIONS), ()),
}
"""The formulas without which there is no proof."""


def forget():
    """Forget what was found, as after a change of a formula."""
    for module in (exact, identities, mirror_identities):
        for function in vars(module).values():
            if hasattr(function, "cache_clear"):
                function.cache_clear()


@pytest.fixture
def fresh():
    forget()
    yield
    forget()


def wrong_inverse_kernel(k):
    table = exact_inverse_kernel(k).copy()
    table[0, 1] = -table[0, 1]
    return table


def wrong_transformation(p, own, middle):
    return exact_transformation(p, own, middle) + np.array([1, 0, 1], dtype=object) * Fraction(1, 10**6)


def wrong_share(mean_across, along, mean_along, across):
    return mean_across * along + mean_along * across


exact_inverse_kernel, exact_transformation = exact.inverse_kernel, exact.transformation
WRONG = {
    KERNELS: wrong_inverse_kernel,
    TRANSFORMATIONS: wrong_transformation,
    BLENDS: ((1, -2, 1), (0, 2, -1), (0, 0, 1)),
    BOOLEAN_SUM: wrong_share,
}


@pytest.mark.parametrize("name", PROOFS)
def test_every_proof_holds(name):
    assert PROOFS[name].statement
    assert PROOFS[name].identities
    assert PROOFS[name].holds()


@pytest.mark.parametrize(("name", "formula"), [(name, formula) for name in PROOFS for formula in RESTS_ON[name]])
def test_no_proof_holds_of_a_wrong_formula(name, formula, fresh, monkeypatch):
    monkeypatch.setattr(exact, formula, WRONG[formula])
    assert not PROOFS[name].holds()


def test_what_the_paper_prints_of_the_ends_cannot_be_proved():
    printed = {
        0: [[0, 0, 1, 0, 0]] * 2,  # (46), (48)
        1: [[0, Fraction(-1, 2), 0, Fraction(1, 2), 0]] * 2,  # (51), (53)
        2: [[0, 0, 2, -4, 2], [2, -4, 2, 0, 0]],  # (55), (57)
    }
    for order, rows in printed.items():
        assert not identities.vanishes_for_all_curves(
            lambda *knots, order=order, rows=rows: exact.end_rows(exact.weights(*knots), order) - rows
        )


def test_a_polynomial_is_told_from_zero_by_one_more_value_than_its_degree():
    def zero_on_the_first(count):
        return lambda x, y: np.prod([x - 2 - k for k in range(count)]) * y

    assert identities.vanishes(zero_on_the_first(3), 2, 1)  # a degree that is too low sees nothing
    assert not identities.vanishes(zero_on_the_first(3), 3, 1)


@pytest.mark.parametrize("name", PROOFS)
def test_proofs_hold_on_larger_grids_too(name, fresh, monkeypatch):
    """So they would if a degree were counted too low by two."""
    vanishes = identities.vanishes
    for module in (identities, mirror_identities):
        monkeypatch.setattr(
            module, "vanishes", lambda function, *degrees: vanishes(function, *(d + 2 for d in degrees))
        )
    assert PROOFS[name].holds()


def numerator(p, k, u, order, end):
    """An entry row of a parabola's weights, or of their derivatives, times what it divides by."""
    row = exact.end_rows(exact.parabola(p, k, u), order)[end]
    return row * k * (1 - k) * u**2 * (1 - u) ** 2


@pytest.mark.parametrize(("p", "order", "end"), list(product(range(3), range(3), range(2))))
def test_weights_are_of_no_higher_degree_than_is_said(p, order, end):
    """Differences of a polynomial of degree d vanish from the order d + 1 on, wherever they are taken."""
    in_own, in_middle = identities.PARABOLA_DEGREES
    for start in (2, 11, 30):
        for other in (Fraction(5), Fraction(1, 3)):
            own = [numerator(p, Fraction(start + n), other, order, end) for n in range(in_own + 2)]
            middle = [numerator(p, other, Fraction(start + n), order, end) for n in range(in_middle + 2)]
            assert not difference(own).any()
            assert not difference(middle).any()


def difference(rows):
    degree = len(rows) - 1
    return sum((-1) ** n * comb(degree, n) * row for n, row in enumerate(rows))


@given(knots)
@settings(max_examples=40, deadline=None)
def test_the_exact_weights_are_those_that_the_program_computes_with(curve):
    r, s, u, t = map(Fraction, curve)
    found = exact.weights(r, s, u, t).astype(float)
    along = np.linspace(0, 1, 7)
    computed = bernstein.basis(6, along) @ weight_coefficients(tuple(curve))
    assert np.allclose(np.vander(along, 7, increasing=True) @ found, computed, rtol=1e-7, atol=1e-7)
    for k in (r, s, t):
        assert np.allclose(exact.kernel(k).astype(float), kernels(float(k)))
        assert np.allclose(exact.inverse_kernel(k).astype(float), inverse_kernels(float(k)))


def test_the_exact_boolean_sum_is_the_one_that_the_program_computes_with():
    net, rows, columns = window_arrays(random_document(3))
    along, across = [
        [exact.values(exact.weights(*map(Fraction, curve)), x) for curve in family]
        for family, x in ((rows, U), (columns, V))
    ]
    mean_along, mean_across = (
        exact.values(exact.weights(*[sum(map(Fraction, knot)) / 5 for knot in family.T]), x)
        for family, x in ((rows, U), (columns, V))
    )
    point = sum(
        float(exact.boolean_share(mean_across[i], along[i][j], mean_along[j], across[j][i])) * net[i, j]
        for i, j in np.ndindex(5, 5)
    )
    coefficients = Formulation.INTERPOLATING.build(net, rows, columns)
    basis = [bernstein.basis(6, [float(x)])[0] for x in (U, V)]
    assert np.allclose(point, np.einsum("a,b,abk->k", *basis, coefficients), rtol=1e-12, atol=1e-12)


def test_the_tangents_at_the_ends_are_those_of_the_weights():
    r, s, u, t = 0.3, 0.45, 0.6, 0.55
    rows = bernstein.derivative(weight_coefficients([r, s, u, t]), 0)[[0, -1]]
    assert np.allclose(identities.start_tangent(Fraction(r), Fraction(u)).astype(float), rows[0])
    assert np.allclose(identities.end_tangent(Fraction(u), Fraction(t)).astype(float), rows[1])
