"""The comparison's measures against closed forms and against what must not change them."""

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest

from qovr_core import (
    FORMULATIONS,
    Document,
    DocumentError,
    Edge,
    Evaluation,
    EvaluationError,
    Formulation,
    Knots,
    Layer,
)
from qovr_core.edits import set_points
from qovr_core.geometry.closest import ClosestSearch
from qovr_core.laboratory.comparison import ComparisonInput, compare, compared_names
from qovr_core.laboratory.comparison_report import comparison_facts, comparison_text
from qovr_core.laboratory.comparison_surfaces import COMPARISON_SURFACES, ComparisonSurface
from qovr_core.laboratory.shape_measures import bending_energy, joints, largest_distance
from qovr_core.laboratory.splines import Basis, TensorSurface, b_spline, bezier, catmull_rom
from qovr_core.presets import presets
from support.documents import random_document, random_net
from support.surfaces import SphericalPatch

Y, X = np.mgrid[:5, :5].astype(float)
FLAT = np.stack([X, Y, 0 * X], axis=-1)
STEP = 0.1 * np.sqrt(32)  # of a net of 4 x 4


def flat(formulation=Formulation.INTERPOLATING, **options):
    return Document(FLAT, formulation=formulation, **options)


def quarter_cylinder(radius, length):
    """Return a quarter of a circular cylinder: the rational quadratic quarter circle, raised to degree 4."""
    circle = np.array([[1, 0, 1], [1, 1, 1], [0, 1, 1]]) * np.array([1, np.sqrt(0.5), 1])[:, None]
    raised = np.array([[1, 0, 0], [1 / 2, 1 / 2, 0], [1 / 6, 2 / 3, 1 / 6], [0, 1 / 2, 1 / 2], [0, 0, 1]]) @ circle
    x, z = radius * raised[:, 0] / raised[:, 2], radius * raised[:, 1] / raised[:, 2]
    net = np.stack([np.tile(x, (5, 1)), Y * length / 4, np.tile(z, (5, 1))], axis=-1)
    return TensorSurface(net, bezier(net).basis_u, bezier(net).basis_v, np.tile(raised[:, 2], (5, 1)))


# --- bending energy ---------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("radius", [0.01, 1.0, 300.0])
def test_the_energy_of_a_quarter_cylinder(radius):
    surface = quarter_cylinder(radius, length=5.0)
    on_it = surface.points(np.linspace(0, 1, 5), [0.0, 1.0])
    assert np.hypot(on_it[..., 0], on_it[..., 2]) == pytest.approx(np.full((5, 2), radius))
    assert bending_energy(surface) == pytest.approx(np.pi / 2 * 5.0 / radius, rel=1e-9)


def test_the_energy_of_a_piece_of_a_sphere_is_twice_its_solid_angle():
    sphere = SphericalPatch(radius=7.0, longitude=1.1, latitude=0.8)
    assert bending_energy(sphere) == pytest.approx(2 * 1.1 * np.sin(0.8), rel=1e-10)


def test_a_plane_has_no_energy():
    assert bending_energy(bezier(FLAT)) == pytest.approx(0, abs=1e-20)


def energy_by_quadrature(surface, ends, nodes=200):
    """Return the integral of k_1^2 + k_2^2 over a surface, Gauss-Legendre between the ends of its pieces each way."""
    x, weights = np.polynomial.legendre.leggauss(nodes)
    total = 0.0
    for a, b in pairwise(ends):
        for c, d in pairwise(ends):
            u, v = a + (b - a) * (x + 1) / 2, c + (d - c) * (x + 1) / 2
            curvature = surface.curvature(u, v)
            area = np.linalg.norm(np.cross(surface.derivative(u, v, 1, 0), surface.derivative(u, v, 0, 1)), axis=2)
            squares = (curvature.largest**2 + curvature.smallest**2) * area
            total += (b - a) * (d - c) / 4 * weights @ squares @ weights
    return total


def test_the_energy_counts_every_piece():
    surface = catmull_rom(random_net(4))
    assert bending_energy(surface) == pytest.approx(energy_by_quadrature(surface, (0.0, 0.5, 1.0)), rel=1e-6)


def test_a_fold_has_no_finite_energy():
    folding = Knots(s=0.9, u=0.3)
    document = Document(random_net(2), (folding,) * 5, formulation=Formulation.INTERPOLATING)
    assert np.isnan(bending_energy(Evaluation(document).patch))


# --- joints -----------------------------------------------------------------------------------------------------------


def hats(x, order):
    """The five hat functions, linear between the knots 0, 1/4 .. 1, with their derivatives from the right."""
    if order == 0:
        return np.array([np.interp(x, np.linspace(0, 1, 5), unit) for unit in np.eye(5)]).T
    piece = np.minimum((4 * x).astype(int), 3)
    slopes = 4.0 * (np.eye(5)[piece + 1] - np.eye(5)[piece])
    return slopes if order == 1 else 0 * slopes


def test_the_tangent_jump_of_a_roof():
    roof = FLAT.copy()
    roof[:, :, 2] = np.minimum(X, 4 - X) * np.tan(np.radians(30))
    surface = TensorSurface(roof, *[Basis(5, hats, np.array([0.25, 0.5, 0.75]))] * 2)
    found = joints(surface)
    assert found.tangent == pytest.approx(60, abs=1e-9)
    assert found.curvature == pytest.approx(0, abs=1e-9)


@pytest.mark.parametrize("along_rows", [True, False])
def test_the_curvature_jump_of_catmull_rom(along_rows):
    """At P_2 the second derivatives differ by P_0 - 2 P_1 + 2 P_3 - P_4, and the tangent is (P_3 - P_1) / 2."""
    net = FLAT.copy()
    net[:, 4, 2] = 0.3
    if not along_rows:
        net = net.transpose(1, 0, 2)
    surface = catmull_rom(net)
    found = joints(surface)
    assert found.curvature == pytest.approx(0.3, abs=1e-12)
    assert found.tangent == pytest.approx(0, abs=1e-9)


def test_a_b_spline_is_smooth_at_its_joints_and_one_polynomial_has_none():
    surface = b_spline(random_net(5))
    found = joints(surface)
    assert found.tangent == pytest.approx(0, abs=1e-9)
    assert found.curvature == pytest.approx(0, abs=1e-9)
    measures = compare(random_document(5, low=0.3, high=0.7)).measures
    assert {contender for contender, measure in measures.items() if measure.joints is None} == {
        "qovr",
        "bezier",
    }


# --- displacement -----------------------------------------------------------------------------------------------------


def test_the_displacement_of_a_flat_net_is_the_point_s_weight():
    measures = compare(flat()).measures
    centre = {"qovr": 1, "bezier": (3 / 8) ** 2, "b-spline": 1 / 4, "nurbs": 4 / (4 + 3), "catmull-rom": 1}
    for contender, weight in centre.items():
        assert measures[contender].largest_motion == pytest.approx(weight * STEP, abs=1e-12)


def test_the_moved_area_of_the_bezier_surface():
    """Of a flat net the area is u, v; it moves as (16 u^2 (1-u)^2 v^2 (1-v)^2) of its largest."""
    x = (np.arange(4000) + 0.5) / 4000
    one_way = 16 * x**2 * (1 - x) ** 2
    shares = compare(flat()).measures["bezier"].shares
    for share, part in zip((0.01, 0.1), shares, strict=True):
        assert part == pytest.approx((np.outer(one_way, one_way) > share).mean(), abs=5e-3)


def test_the_moved_area_counts_area_and_not_parameters():
    """The same surface drawn together on the left: what moves there counts less."""
    net = FLAT.copy()
    net[:, :, 0] = [0, 0.02, 0.04, 0.06, 4]
    x = np.linspace(0, 1, 1001)
    surface = bezier(net)
    motion = 16 * np.outer(x**2 * (1 - x) ** 2, x**2 * (1 - x) ** 2)
    area = np.linalg.norm(np.cross(surface.derivative(x, x, 1, 0), surface.derivative(x, x, 0, 1)), axis=2)
    shares = compare(Document(net, formulation=Formulation.INTERPOLATING)).measures["bezier"].shares
    expected = area[motion > 0.1 / 16].sum() / area.sum()
    assert shares[1] == pytest.approx(expected, abs=5e-3)
    assert abs(expected - (motion > 0.1 / 16).mean()) > 0.02


def test_edges_and_corners():
    middle = compare(flat()).measures
    for measures in middle.values():  # P_22 moves no edge of any of them
        assert max(measures.edge_motion.values()) == pytest.approx(0, abs=1e-14)
    corner = compare(flat(), point=(1, 3)).measures  # row 1 is v = 0, column 3 is u = 1
    for contender in ("qovr", "catmull-rom"):
        edges = corner[contender].edge_motion
        assert edges[Edge.V0] == edges[Edge.U1] == pytest.approx(STEP)
        assert edges[Edge.V1] == pytest.approx(0, abs=1e-14)
        assert corner[contender].corner_motion == pytest.approx(np.array([[0, 0], [STEP, 0]]), abs=1e-14)
    outer = compare(flat(), point=(0, 4)).measures["bezier"]
    assert outer.corner_motion == pytest.approx(np.array([[0, 0], [STEP, 0]]), abs=1e-14)


def test_t_is_computed_again_after_the_move():
    """P_22 rises out of the box: the published surface is stretched with the box, and moves everywhere."""
    document = presets()["fig5"].document
    net = document.control_points.copy()
    step = 0.1 * np.linalg.norm(np.ptp(net.reshape(-1, 3), axis=0))
    net[2, 2, 2] += step
    u = np.linspace(0, 1, 201)
    before, after = (
        Evaluation(each).layer_patch(Layer.TRANSFORMED).points(u, u) for each in (document, set_points(document, net))
    )
    measures = compare(document).measures["qovr"]
    assert measures.largest_motion == pytest.approx(np.linalg.norm(after - before, axis=2).max())
    assert measures.edge_motion[Edge.U0] > 0.1


# --- distances --------------------------------------------------------------------------------------------------------


def test_the_distances_of_flat_surfaces_are_those_of_their_corners():
    measures = compare(flat()).measures
    for contender in ("bezier", "b-spline", "nurbs"):
        assert measures[contender].distance_from_qovr == pytest.approx(np.sqrt(2), abs=1e-12)
        assert measures[contender].distance_of_qovr == pytest.approx(0, abs=1e-12)
    assert measures["catmull-rom"].distance_from_qovr == pytest.approx(0, abs=1e-12)


def test_the_distance_of_two_planes():
    above = bezier(FLAT + np.array([0, 0, 2.5]))
    assert largest_distance(above, ClosestSearch(bezier(FLAT))) == pytest.approx(2.5, abs=1e-13)


def test_the_largest_distance_is_met_between_samples():
    bumpy = FLAT.copy()
    bumpy[1, 1, 2], bumpy[2, 3, 2], bumpy[3, 1, 2] = 1.0, 0.7, -0.4
    fine = np.linspace(0, 1, 1201)
    highest = np.abs(bezier(bumpy).points(fine, fine)[..., 2]).max()  # over the plane z = 0, which reaches as far
    assert largest_distance(bezier(bumpy), ClosestSearch(bezier(FLAT))) == pytest.approx(highest, rel=1e-4)


def test_which_surfaces_run_through_the_inner_points():
    document = Document(random_net(6), formulation=Formulation.INTERPOLATING)
    measures = compare(document).measures
    distance = {contender: measure.distance_from_points for contender, measure in measures.items()}
    assert distance["qovr"] < 1e-12
    assert distance["catmull-rom"] < 1e-12
    assert min(distance["bezier"], distance["b-spline"], distance["nurbs"]) > 1e-2


def test_a_great_weight_draws_the_nurbs_surface_to_its_point():
    document = random_document(7, low=0.3, high=0.7)
    heavy = ComparisonInput(document, (2, 2), 1e9)
    middle = heavy.surface("nurbs").points([0.5], [0.5])[0, 0]
    assert middle == pytest.approx(document.control_points[2, 2], abs=1e-6)
    plain = compare(document, weight=1.0).measures
    for name, value in vars(plain["b-spline"]).items():
        if name not in ("joints", "corner_motion"):
            assert vars(plain["nurbs"])[name] == pytest.approx(value, abs=1e-9)


# --- what must not change it ------------------------------------------------------------------------------------------


def numbers(comparison, scale=1.0):
    """Return every number of a comparison in units of a scale; the energy and the shares have none."""
    rows = []
    for measures in comparison.measures.values():
        lengths = [
            measures.largest_motion,
            *measures.edge_motion.values(),
            *measures.corner_motion.ravel(),
            measures.distance_from_points,
            measures.distance_from_qovr,
            measures.distance_of_qovr,
        ]
        jump = 0 if measures.joints is None else measures.joints.curvature
        rows.append([*np.array(lengths) / scale, jump * scale, *measures.shares, measures.bending_energy])
    return np.array(rows)


def turned(angle):
    c, s = np.cos(angle), np.sin(angle)
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])


def test_turning_about_z_and_moving_change_nothing_of_the_interpolating_surface():
    """Its net's box turns with it only by right angles, and the box measures the step."""
    document = random_document(8, low=0.42, high=0.58)
    before = numbers(compare(document))
    moved = set_points(document, document.control_points @ turned(np.pi / 2).T + [3, -2, 5])
    assert numbers(compare(moved)) == pytest.approx(before, rel=1e-6, abs=1e-9)


@pytest.mark.parametrize("formulation", FORMULATIONS.values(), ids=str)
@pytest.mark.parametrize("scale", [1e-4, 1e5])
def test_every_measure_scales(formulation, scale):
    document = replace(presets()["fig6b"].document, formulation=formulation)
    larger = set_points(document, scale * document.control_points)
    assert numbers(compare(larger), scale) == pytest.approx(numbers(compare(document)), rel=1e-6, abs=1e-9)


def test_transposing_the_net_transposes_the_measures():
    document = replace(random_document(9, low=0.42, high=0.58), formulation=Formulation.INTERPOLATING)
    mirrored = replace(
        document,
        control_points=document.control_points.transpose(1, 0, 2),
        row_knots=document.column_knots,
        column_knots=document.row_knots,
    )
    across = {Edge.U0: Edge.V0, Edge.V0: Edge.U0, Edge.U1: Edge.V1, Edge.V1: Edge.U1}
    here, there = compare(document, point=(1, 2)).measures, compare(mirrored, point=(2, 1)).measures
    for contender in compared_names():
        for edge in Edge:
            assert there[contender].edge_motion[across[edge]] == pytest.approx(here[contender].edge_motion[edge])
        assert there[contender].bending_energy == pytest.approx(here[contender].bending_energy, rel=1e-6)
        assert there[contender].distance_of_qovr == pytest.approx(here[contender].distance_of_qovr, rel=1e-9)


# --- how it is told, and surfaces from outside -----------------------------------------------------------------------


def test_every_surface_is_reported_as_soon_as_it_is_measured():
    told = []
    comparison = compare(flat(), report=lambda name, measures: told.append((name, measures)))
    assert told == list(comparison.measures.items())
    assert [name for name, _ in told] == ["qovr", "bezier", "b-spline", "nurbs", "catmull-rom"]


def test_what_the_report_raises_ends_the_work():
    told = []

    def cancel(name, _measures):
        told.append(name)
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        compare(flat(), report=cancel)
    assert told == ["qovr"]


def test_a_surface_from_outside_is_compared_by_its_record():
    def ruled(net, _point, _weight):
        """Between the first and the last column."""
        return bezier(np.linspace(0, 1, 5)[:, None] * net[:, -1:] + np.linspace(1, 0, 5)[:, None] * net[:, :1])

    record = ComparisonSurface("ruled", "Ruled", "The ruled surface between the outer columns.", ruled)
    document = random_document(6, low=0.4, high=0.6)
    with COMPARISON_SURFACES.register(record):
        comparison = compare(document)
        assert list(comparison.measures)[-1] == "ruled"
        assert comparison.measures["ruled"].joints is None
        assert comparison_text(comparison).splitlines()[4].split()[-1] == "Ruled"
        assert list(comparison_facts(comparison)["surfaces"])[-1] == "ruled"
    assert "ruled" not in compare(document).measures


# --- special nets, and refusals ---------------------------------------------------------------------------------------


def test_a_net_on_a_line_has_no_area_and_is_compared_all_the_same():
    result = compare(Document(np.stack([X + Y, 0 * X, 0 * X], axis=-1), formulation=Formulation.INTERPOLATING))
    bezier_measures = result.measures["bezier"]
    assert np.isnan(bezier_measures.bending_energy)
    assert np.isnan(bezier_measures.shares).all()
    assert comparison_facts(result)["surfaces"]["bezier"]["bending_energy"] is None
    assert bezier_measures.distance_from_points == pytest.approx(0, abs=1e-12)


def test_the_table_fits_a_terminal():
    text = comparison_text(compare(random_document(10)))
    assert max(map(len, text.splitlines())) <= 100
    assert "no joints" in text


@pytest.mark.parametrize("point", [(5, 0), (0, -1), (2,), (1.5, 2)])
def test_points_that_are_none(point):
    with pytest.raises(DocumentError, match=r"the point is .*; expected i and j, each from 0 to 4"):
        compare(flat(), point)


@pytest.mark.parametrize("weight", [0, -1, np.nan, np.inf, 1e13])
def test_weights_that_are_none(weight):
    with pytest.raises(DocumentError, match=r"the weight is .*; expected a positive number"):
        compare(flat(), weight=weight)


@pytest.mark.parametrize("u", [1e-16, 1e-100])
def test_a_surface_blown_up_by_its_knots_is_measured_without_a_warning(u):
    blown_up = replace(flat(), row_knots=(Knots(0.5, 0.5, u, 0.5),) * 5, column_knots=(Knots(0.5, u, 0.5, 0.5),) * 5)
    for formulation in FORMULATIONS.values():
        measures = compare(replace(blown_up, formulation=formulation)).measures["qovr"]
        assert np.isfinite([measures.largest_motion, measures.distance_from_points, *measures.shares]).all()


def test_a_very_small_net_has_a_size():
    net = 1e-200 * random_document(3).control_points
    small, unit = compare(Document(net)), compare(Document(1e200 * net))
    assert small.measures["bezier"].shares == pytest.approx(unit.measures["bezier"].shares)


def test_a_net_in_one_place():
    with pytest.raises(EvaluationError, match=r"all lie in one place, \(1, 1, 1\)"):
        compare(Document(np.ones((5, 5, 3))))


def test_what_it_hands_out_is_read_only():
    assert not compare(flat()).measures["qovr"].corner_motion.flags.writeable
