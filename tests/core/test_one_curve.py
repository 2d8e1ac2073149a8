"""One curve and its parts: the blend of its parabolas, and the places of its knots."""

import numpy as np
import pytest
from hypothesis import given
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
    of_network = bernstein.basis(CURVE_DEGREE, U) @ family[which[1], 0]
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


def test_what_is_used_of_the_middle_parabola_beyond_its_points():
    """Where s(u) = a u^2 + (1 - a) u turns round outside [0, 1]; a = (u - s) / (u - u^2), so 1, 1.5 and -1.5 here."""
    used = [OneCurve(np.zeros((5, 3)), Knots(s=s)).auxiliary for s in (0.25, 0.125, 0.875)]
    assert used[0] == ((1.0, 1.5), (0.0, 0.0), (-0.5, 0.0))
    assert used[1][1] == (pytest.approx(-1 / 24), 0.0)
    assert used[2][1] == (1.0, pytest.approx(25 / 24))


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
