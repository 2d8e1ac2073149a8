"""The three surfaces against literal loops, and what must not move."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from qovr_core import (
    FORMULATIONS,
    Document,
    Edge,
    EvaluationError,
    Formulation,
    Knots,
    build_patch,
    curve_network,
    edits,
)
from qovr_core.edits import Direction
from qovr_core.geometry import bernstein
from qovr_core.geometry.weights import weight_coefficients
from support import algorithm1
from support.documents import documents, knots, random_document, random_net, seeds, size, with_knot

U = np.linspace(0, 1, 7)
V = np.linspace(0, 1, 5)


def literal(document):
    rows, columns = (knots.array[:, 0].tolist() for knots in (document.row_knots, document.column_knots))
    net = document.control_points.tolist()
    name = str(document.formulation)
    return np.array([[algorithm1.point(net, rows, columns, name, u, v) for v in V] for u in U])


@given(documents())
@settings(max_examples=150, deadline=None)
def test_every_formulation_is_algorithm_1(document):
    expected = literal(document)
    assert np.abs(build_patch(document).points(U, V) - expected).max() <= 1e-11 * size(expected)


@given(seeds)
@settings(max_examples=50, deadline=None)
def test_the_interpolating_surface_is_bounded_by_its_curves(seed):
    document = random_document(seed)
    patch, network = build_patch(document), curve_network(document)
    tolerance = 1e-12 * size(network.rows)
    edges = {
        Edge.U0: network.columns[1, 0],
        Edge.U1: network.columns[3, 0],
        Edge.V0: network.rows[1, 0],
        Edge.V1: network.rows[3, 0],
    }
    for edge, curve in edges.items():
        along = np.linspace(0, 1, 33)
        basis = bernstein.basis(6, along)
        at_edge = patch.points([0.0 if edge == Edge.U0 else 1.0], along)[0]
        if edge in (Edge.V0, Edge.V1):
            at_edge = patch.points(along, [0.0 if edge == Edge.V0 else 1.0])[:, 0]
        assert np.abs(at_edge - basis @ curve).max() <= tolerance


@given(knots, knots, seeds)
@settings(deadline=None)
def test_the_interpolating_surface_runs_through_the_inner_points(row_knots, column_knots, seed):
    """With the same knots on all curves of a direction, at u = 0, u_ip, 1 and v = 0, v_ip, 1."""
    net = random_net(seed)
    document = Document(net, (row_knots,) * 5, (column_knots,) * 5, Formulation.INTERPOLATING)
    points = build_patch(document).points([0, row_knots.u, 1], [0, column_knots.u, 1])
    assert np.abs(points - net[1:4, 1:4].transpose(1, 0, 2)).max() < 1e-9


@given(knots, knots, seeds)
@settings(deadline=None)
def test_with_equal_knots_the_interpolating_surface_is_the_tensor_product(row_knots, column_knots, seed):
    net = random_net(seed)
    document = Document(net, (row_knots,) * 5, (column_knots,) * 5, Formulation.INTERPOLATING)
    along_u, along_v = weight_coefficients(tuple(row_knots)), weight_coefficients(tuple(column_knots))
    tensor = np.einsum("aj,bi,ijd->abd", along_u, along_v, net)
    assert np.abs(build_patch(document).coefficients[0, 0] - tensor).max() <= 1e-12 * max(1, np.abs(tensor).max())


@pytest.mark.parametrize("seed", range(10))
def test_affine_maps_of_the_net_map_the_interpolating_surface(seed):
    rng = np.random.default_rng(seed)
    linear, shift = rng.uniform(-2, 2, (3, 3)), rng.uniform(-5, 5, 3)
    document = random_document(seed)
    mapped = edits.set_points(document, document.control_points @ linear.T + shift)
    expected = build_patch(document).points(U, V) @ linear.T + shift
    assert np.abs(build_patch(mapped).points(U, V) - expected).max() <= 1e-11 * size(expected)


def edge_motion(before, after):
    """Return the largest motion of each edge between two documents."""
    patches = build_patch(before), build_patch(after)
    return {edge: np.abs(patches[1].edge(edge)[0] - patches[0].edge(edge)[0]).max() for edge in Edge}


def scale(document):
    return np.abs(build_patch(document).coefficients[0, 0]).max()


@pytest.mark.parametrize("name", ["r", "s", "u", "t"])
@pytest.mark.parametrize("curve", range(5))
@pytest.mark.parametrize("direction", list(Direction))
def test_which_edges_a_knot_moves(direction, curve, name):
    document = random_document(17, low=0.3, high=0.6)
    value = getattr(edits.knots_of(document, direction)[curve, 0], name)
    moved = edge_motion(document, with_knot(document, direction, name, value + 0.1, curve=curve))
    own_edge = {
        (Direction.ROWS, 1): Edge.V0,
        (Direction.ROWS, 3): Edge.V1,
        (Direction.COLUMNS, 1): Edge.U0,
        (Direction.COLUMNS, 3): Edge.U1,
    }.get((direction, curve))
    for edge, motion in moved.items():
        if edge == own_edge:
            assert motion > 1e-3
        else:
            assert motion <= 1e-12 * scale(document)


def test_the_middle_point_leaves_all_edges_and_moves_the_inside():
    document = random_document(23)
    after = edits.set_point(document, 2, 2, document.control_points[2, 2] + [0.3, -0.2, 5])
    assert max(edge_motion(document, after).values()) <= 1e-12 * scale(document)
    assert np.abs(build_patch(after).points([0.5], [0.5]) - build_patch(document).points([0.5], [0.5])).max() > 0.5


@given(seeds, st.sampled_from(["r", "s", "u", "t"]), st.integers(0, 3))
@settings(max_examples=25, deadline=None)
def test_published_knows_no_row_curve_but_the_last(seed, name, curve):
    document = random_document(seed, Formulation.PUBLISHED)
    after = with_knot(document, Direction.ROWS, name, 0.123, curve=curve)
    assert np.array_equal(build_patch(after).coefficients[0, 0], build_patch(document).coefficients[0, 0])
    net = document.control_points.copy()
    last = with_knot(document, Direction.ROWS, name, 0.123, curve=4)
    assert not np.array_equal(build_patch(last).coefficients[0, 0], build_patch(document).coefficients[0, 0])
    assert np.array_equal(document.control_points, net)


def test_degree_is_6_where_one_curve_that_counts_has_other_s_than_u():
    net = random_net(0)
    quartic, sextic = Knots(0.3, 0.4, 0.4, 0.7), Knots(0.3, 0.4, 0.5, 0.7)
    rows = (quartic, sextic, quartic, quartic, quartic)
    for formulation, degree in {"published": (4, 4), "double-sum": (6, 4), "interpolating": (6, 4)}.items():
        patch = build_patch(Document(net, rows, (quartic,) * 5, FORMULATIONS[formulation]))
        assert patch.degree == degree
        for axis, true_degree in enumerate(degree):
            highest = np.abs(np.diff(patch.coefficients[0, 0], n=6, axis=axis)).max()
            assert (highest < 1e-9) == (true_degree == 4)


def test_a_surface_without_finite_coordinates_is_refused_in_words():
    document = random_document(1)
    near = replace(document, row_knots=(Knots(r=1e-320), *document.row_knots.in_window(0)[1:]))
    with pytest.raises(EvaluationError, match=r"row_knots\[0\]\.r = 1e-320 is only 1e-320 away"):
        build_patch(near)
