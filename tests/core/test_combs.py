"""Curvature combs and the sum of their changes, against closed forms and against finite differences of points."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from qovr_core import Evaluation, Formulation
from qovr_core.geometry.bernstein import basis
from qovr_core.geometry.combs import comb, comb_changes, curvature_vectors, isolines
from qovr_core.report import fairness_facts
from support.documents import random_document, seeds
from support.nets import random_net_document

PARABOLA = np.array([[-1, 1, 0], [-1 / 3, -1 / 3, 0], [1 / 3, -1 / 3, 0], [1, 1, 0.0]])
"""y = x^2 from -1 to 1, elevated to degree 3."""


def curvature_of_circles(points):
    """Return the curvature of the circles through each three neighbours: 4 area / (a b c)."""
    a, b, c = points[:-2], points[1:-1], points[2:]
    area = np.linalg.norm(np.cross(b - a, c - a), axis=1) / 2
    return 4 * area / np.prod([np.linalg.norm(p - q, axis=1) for p, q in ((a, b), (b, c), (c, a))], axis=0)


def test_a_parabola():
    """k = 2 / (1 + 4 x^2)^(3/2) rises from x = -1 to 0 and falls to 1."""
    assert comb_changes([PARABOLA]) == pytest.approx([2 * (2 - 2 / 5**1.5)], rel=1e-12)
    made = comb(PARABOLA, [0.5, 1.0])
    assert made.feet == pytest.approx(np.array([[0, 0, 0], [1, 1, 0]]), abs=1e-14)
    towards = np.array([-2, 1, 0]) / 5**0.5
    assert made.curvature == pytest.approx(np.array([[0, 2, 0], 2 / 5**1.5 * towards]), abs=1e-13)


def test_lines_and_circles_are_perfectly_fair():
    line = np.linspace(0, 1, 7)[:, None] * np.array([3.0, -1, 2]) + 1e3
    assert comb_changes([line]).tolist() == [0]
    t = np.linspace(0, 2, 50)
    place, first = (np.stack([f(t), g(t), 0 * t], -1) for f, g in ((np.cos, np.sin), (lambda x: -np.sin(x), np.cos)))
    assert curvature_vectors(5 * first, -5 * place) == pytest.approx(-place / 5, abs=1e-15)


def test_a_curve_that_stops_has_no_number():
    cusp = np.array([[0, 0, 0], [1, 1, 0], [0, 1, 0], [1, 0, 0.0]])  # x' = y' = 0 at 1/2
    assert comb_changes([cusp, np.ones((4, 3))]).tolist() == [np.inf, np.inf]


@given(seeds, st.floats(0.01, 100))
def test_it_is_what_the_circles_through_close_points_give_and_scales_as_curvature(seed, scale):
    curve = np.random.default_rng(seed).normal(size=(7, 3)) + 3 * np.linspace(0, 1, 7)[:, None] * [1, 2, 3]
    (changes,) = comb_changes([curve])
    k = curvature_of_circles(basis(6, np.linspace(0, 1, 20001)) @ curve)
    assert changes == pytest.approx(np.abs(np.diff(k)).sum(), rel=5e-3)
    turn, _ = np.linalg.qr(np.random.default_rng([seed, 1]).normal(size=(3, 3)))
    assert comb_changes([scale * curve @ turn + 1])[0] == pytest.approx(changes / scale, rel=1e-6)
    assert comb_changes([curve, curve[::-1]]) == pytest.approx([changes, changes], rel=1e-6)


def test_isolines_are_those_of_the_surface_and_are_summed():
    evaluation = Evaluation(random_document(5, Formulation.INTERPOLATING, low=0.3, high=0.7))
    patch, u = evaluation.patch, np.linspace(0, 1, 11)
    along_u, along_v = isolines(patch, 5)
    few = np.linspace(0, 1, 5)
    assert basis(6, u) @ along_u[:, 0] == pytest.approx(patch.points(u, few).transpose(1, 0, 2), abs=1e-12)
    assert basis(6, u) @ along_v[:, 0] == pytest.approx(patch.points(few, u), abs=1e-12)
    facts = fairness_facts(evaluation)
    lines_u, lines_v = isolines(patch, facts["isolines"])
    assert (facts["layer"], facts["isolines"]) == ("raw", 9)
    assert facts["u"] == pytest.approx(sum(comb_changes([line])[0] for line in lines_u[:, 0]))
    assert facts["v"] == pytest.approx(sum(comb_changes([line])[0] for line in lines_v[:, 0]))


@given(st.integers(0, 1000))
def test_a_curve_in_pieces_changes_as_its_teeth_do(seed):
    """Against curvatures at many parameters of the whole, on both sides of every joint."""
    patch = Evaluation(random_net_document(seed, (2, 3), smooth=0.5, margin=0.35, flatness=0.5)).patch
    lines, _ = isolines(patch, 3)
    u = np.linspace(0, 1, 4001)
    for line in lines:
        first, second = (basis(6 - k, u) @ np.diff(line, k, axis=-2) * (1, 6, 30)[k] for k in (1, 2))
        teeth = np.linalg.norm(curvature_vectors(first, second), axis=-1).ravel()
        assert comb_changes([line])[0] == pytest.approx(np.abs(np.diff(teeth)).sum(), rel=1e-3)


def test_isolines_of_a_net_run_through_all_its_windows():
    patch = Evaluation(random_net_document(5, (2, 3))).patch
    few_u, few_v = (np.linspace(*ends, 5) for ends in patch.domain)
    along_u, along_v = isolines(patch, 5)
    starts_u, starts_v = (ends[:-1] for ends in patch.breakpoints)
    assert along_u[:, :, 0] == pytest.approx(patch.points(starts_u, few_v).transpose(1, 0, 2), abs=1e-12)
    assert along_v[:, :, 0] == pytest.approx(patch.points(few_u, starts_v), abs=1e-12)
