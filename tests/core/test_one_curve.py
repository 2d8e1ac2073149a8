"""One curve and its parts: the blend of its parabolas, the places of its knots, and the fold-back of s."""

from fractions import Fraction

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from qovr_core import FORMULATIONS, Document, EvaluationError, Formulation, Knots, curve_network
from qovr_core.edits import Direction
from qovr_core.geometry import bernstein
from qovr_core.geometry.weights import CURVE_DEGREE
from qovr_core.laboratory.one_curve import OneCurve, curve_of
from qovr_core.laboratory.planes import View, plane_of
from support.algorithm1 import curve as algorithm1_curve
from support.documents import documents, knots, random_document, random_net, seeds

U = np.linspace(0, 1, 41)
ALL_CURVES = [(direction, number) for direction in Direction for number in range(5)]


def scale(curve):
    """Rounding is a part of the largest term that is summed: a parabola's coefficient by a power of its parameter."""
    at = np.array([-1.0, 0.0, 1.0])
    coefficients = [np.linalg.solve(np.vander(at), curve.parabola(p, at)) for p in range(3)]
    return 1 + np.abs(coefficients).max() * np.abs(curve.transformed(U)).max() ** 2


@given(documents(), st.sampled_from(ALL_CURVES))
def test_it_is_the_curve_of_the_network_and_the_blend_of_its_parabolas(document, which):
    curve = curve_of(document, *which)
    network = curve_network(document)
    family = network.rows if which[0] is Direction.ROWS else network.columns
    tolerance = 1e-12 * scale(curve)
    of_network = bernstein.basis(CURVE_DEGREE, U) @ family[which[1]]
    assert curve.at(U) == pytest.approx(of_network, abs=tolerance)
    r_s_t, w = curve.transformed(U), curve.blends(U)
    blend = sum(w[:, [p]] * curve.parabola(p, r_s_t[:, p]) for p in range(3))
    assert curve.at(U) == pytest.approx(blend, abs=tolerance)
    assert curve.at(U) == pytest.approx(curve.weights(U) @ curve.points, abs=tolerance)


@pytest.mark.parametrize("formulation", FORMULATIONS.values(), ids=str)
def test_it_is_the_curve_of_algorithm_1(formulation):
    document = random_document(11, formulation, low=0.2, high=0.8)
    cut = formulation is Formulation.PUBLISHED
    for direction, number in ALL_CURVES:
        curve = curve_of(document, direction, number)
        expected = [
            [algorithm1_curve(u, tuple(curve.knots), list(curve.points[:, axis]), cut) for axis in range(3)] for u in U
        ]
        assert curve.at(U) == pytest.approx(np.array(expected), abs=1e-10)


@given(st.builds(OneCurve, seeds.map(lambda seed: random_net(seed)[1]), knots))
def test_the_knots_lie_at_the_points(curve):
    tolerance = 1e-11 * scale(curve)
    assert curve.at(curve.landmarks) == pytest.approx(curve.points[1:4], abs=tolerance)
    for p, knot in enumerate(curve.internal_knots):
        assert curve.parabola(p, [0, knot, 1]) == pytest.approx(curve.points[p : p + 3], abs=tolerance)
    # What is blended begins or ends where the transformations stand at 0, u_ip and 1.
    r, s, t = curve.transformed(curve.landmarks).T
    assert (r[0], s[1], t[2]) == pytest.approx(curve.internal_knots, abs=1e-11)
    assert (r[1], s[0], s[2], t[1]) == pytest.approx((1, 0, 1, 0), abs=1e-11)
    assert curve.blended == ((curve.knots.r, 1.0), (0.0, 1.0), (0.0, curve.knots.t))
    assert curve.auxiliary[0] == (1.0, pytest.approx(r[2]))
    assert curve.auxiliary[2] == (pytest.approx(t[0]), 0.0)


@given(knots)
def test_fold_back_in_exact_arithmetic(knots):
    _, s, u, _ = (Fraction(value) for value in knots)
    a = (s - u) / (u * u - u)
    fold = OneCurve(np.zeros((5, 3)), knots).fold_back
    assume(abs(abs(a) - 1) > 1e-9)
    assert (fold is not None) == (abs(a) > 1)
    if fold is None:
        return

    def s_at(x):
        return a * x * x + (1 - a) * x

    def slope(x):
        return 2 * a * x + 1 - a

    low, high = (Fraction(value) for value in fold.backward)
    inside, tiny = (low + high) / 2, Fraction(1, 10**9)
    assert slope(inside) < 0
    assert {low, high} & {0, 1}
    turn = high if low == 0 else low
    assert abs(slope(turn)) < 1e-9 * abs(a)
    assert float(s_at(turn)) == pytest.approx(fold.turn, abs=1e-9)
    assert fold.turn < 0 or fold.turn > 1
    first, last = (Fraction(value) for value in fold.outside)
    assert not 0 <= s_at((first + last) / 2) <= 1
    edge = last + tiny if first == 0 else first - tiny
    assert 0 <= s_at(edge) <= 1
    assert first <= low <= high <= last


def test_fold_back_by_hand():
    points = np.zeros((5, 3))
    assert OneCurve(points, Knots(0.5, 0.5, 0.5, 0.5)).fold_back is None
    assert OneCurve(points, Knots(0.5, 0.25, 0.5, 0.5)).fold_back is None  # the last that is monotone
    assert OneCurve(points, Knots(0.5, 0.25, 0.5, 0.5)).auxiliary == ((1.0, 1.5), (0.0, 0.0), (-0.5, 0.0))
    low = OneCurve(points, Knots(0.5, 0.125, 0.5, 0.5)).fold_back  # a = 1.5
    assert OneCurve(points, Knots(0.5, 0.125, 0.5, 0.5)).auxiliary[1] == (low.turn, 0.0)
    assert OneCurve(points, Knots(0.5, 0.875, 0.5, 0.5)).auxiliary[1] == (1.0, pytest.approx(25 / 24))
    assert low.backward == (0, pytest.approx(1 / 6))
    assert low.outside == (0, pytest.approx(1 / 3))
    assert low.turn == pytest.approx(-1 / 24)
    high = OneCurve(points, Knots(0.5, 0.875, 0.5, 0.5)).fold_back
    assert high.backward == (pytest.approx(5 / 6), 1)
    assert high.outside == (pytest.approx(2 / 3), 1)
    assert high.turn == pytest.approx(25 / 24)


def test_names_and_refusals():
    document = Document(random_net(1))
    curve = curve_of(document, Direction.COLUMNS, 3)
    assert (curve.name, curve.parameter) == ("K_3", "v")
    assert np.array_equal(curve.points, document.control_points[:, 3])
    assert not curve.at(U).flags.writeable
    with pytest.raises(EvaluationError, match="C_0 has no finite coordinates"):
        OneCurve(curve.points, Knots(r=1e-309))


@given(seeds)
def test_the_best_plane_is_that_of_least_squares(seed):
    points = np.random.default_rng(seed).normal(size=(5, 3))
    plane = plane_of(points, View.BEST)
    assert plane.directions @ plane.directions.T == pytest.approx(np.eye(2), abs=1e-12)

    def seen(directions):
        drawn = (points - points.mean(axis=0)) @ directions.T
        return (drawn**2).sum()

    best = seen(plane.directions)
    for k in range(20):
        other, _ = np.linalg.qr(np.random.default_rng([seed, k]).normal(size=(3, 2)))
        assert seen(other.T) <= best * (1 + 1e-12)


def test_planes_of_the_papers_curves_are_coordinate_planes():
    net = random_net(3)
    net[..., 0], net[..., 1] = np.meshgrid(range(5), range(5))
    assert plane_of(net[2], View.BEST).labels == ("x", "z")
    assert plane_of(net[:, 2], View.BEST).labels == ("y", "z")
    assert plane_of(net[2], View.XY).labels == ("x", "y")
    assert plane_of(net[2], View.YZ).drawn(net[2]) == pytest.approx(net[2][:, 1:])


def test_tilted_and_degenerate_planes():
    flat = np.array([[0, 0, 0], [1, 0, 0], [2, 1, 0], [3, 3, 0], [4, 0, 0.0]])
    c, s = 0.8, 0.6
    tilted = flat @ np.array([[c, s, 0], [0, 0, 1], [s, -c, 0]])  # x to 0.8 x + 0.6 y, y to z
    plane = plane_of(tilted, View.BEST)
    assert plane.labels == ("0.80 x + 0.60 y", "z")
    assert plane.drawn(tilted) == pytest.approx(flat[:, :2], abs=1e-12)
    line = np.outer(np.arange(5), [1.0, 0.1, 2.0])
    assert plane_of(line, View.BEST).labels == ("x", "z")
    assert plane_of(np.ones((5, 3)), View.BEST).labels in {("x", "y"), ("x", "z"), ("y", "z")}
