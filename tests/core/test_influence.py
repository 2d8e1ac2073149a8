"""What a point or a knot moves, against the weights, the pipeline, and places that must not move."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from qovr_core import FORMULATIONS, Document, DocumentError, Edge, Formulation, Knots, Layer, configure
from qovr_core.edits import Direction, KnotPlace, set_formulation
from qovr_core.geometry import bernstein
from qovr_core.geometry.weights import weight_coefficients
from qovr_core.laboratory.falloff import EXPONENTIAL_MISFIT, fit_exponential
from qovr_core.laboratory.influence import (
    KnotMove,
    PointMove,
    default_amount,
    influence,
)
from qovr_core.laboratory.levels import areas_above, level_line
from qovr_core.presets import preset
from support.documents import documents, knots, random_document, random_net, seeds

indices = st.integers(0, 4)
steps = st.floats(-2, 2).filter(lambda x: abs(x) > 1e-3)
vectors = st.tuples(steps, steps, steps)
layers = st.sampled_from(list(Layer))
FINE = np.linspace(0, 1, 173)
KNOTS = [KnotPlace(direction, k, name) for direction in Direction for k in range(5) for name in "rsut"]


def interpolating(seed=1, rows=None, columns=None):
    """Return a document with the same knots on all rows, and on all columns."""
    rows, columns = rows or Knots(), columns or Knots()
    return Document(random_net(seed), (rows,) * 5, (columns,) * 5, Formulation.INTERPOLATING)


def of(document, change, layer=Layer.RAW):
    return influence(document, change, layer)


def magnitude_at(found, u, v):
    return np.linalg.norm(found.displacement.points(u, v), axis=-1)


@given(knots, knots, indices, indices, vectors, seeds)
@settings(max_examples=60, deadline=None)
def test_a_point_moves_the_surface_by_its_weight(along_u, along_v, i, j, vector, seed):
    found = of(interpolating(seed, along_u, along_v), PointMove(i, j, vector))
    b, beta = (
        bernstein.basis(6, found.u) @ weight_coefficients(np.array([tuple(k)]))[0, :, index]
        for k, index in ((along_u, j), (along_v, i))
    )
    expected = np.linalg.norm(vector) * np.abs(np.outer(b, beta))
    assert found.magnitude == pytest.approx(expected, abs=1e-9)


@given(documents(), indices, indices, vectors, layers)
@settings(max_examples=60, deadline=None)
def test_the_displacement_is_that_of_two_whole_pipelines(document, i, j, vector, layer):
    change = PointMove(i, j, vector)
    before, after = configure(document), configure(change.applied(document))
    name = "raw" if layer is Layer.RAW else "transformed"
    found = influence(document, change, layer)
    expected = getattr(after, name) - getattr(before, name)
    scale = np.abs(getattr(after, name)).max() + np.abs(getattr(before, name)).max()
    assert np.abs(found.displacement.points(before.u, before.v) - expected).max() <= 1e-9 * scale


@given(documents(), indices, indices, vectors, layers)
@settings(max_examples=60, deadline=None)
def test_nothing_moves_more_than_the_largest_displacement(document, i, j, vector, layer):
    found = of(document, PointMove(i, j, vector), layer)
    u, v = found.place
    assert magnitude_at(found, [u], [v]).item() == pytest.approx(found.largest, rel=1e-12)
    assert magnitude_at(found, FINE, FINE).max() <= found.largest * (1 + 1e-9)
    ends = [0, 1]
    assert found.corners == pytest.approx(magnitude_at(found, ends, ends))
    for edge, lines in (
        (Edge.U0, magnitude_at(found, [0], FINE)),
        (Edge.U1, magnitude_at(found, [1], FINE)),
        (Edge.V0, magnitude_at(found, FINE, [0])),
        (Edge.V1, magnitude_at(found, FINE, [1])),
    ):
        assert lines.max() * (1 - 1e-9) <= found.edges[edge] <= found.largest * (1 + 1e-9)


@given(seeds, vectors, st.floats(0.01, 50))
@settings(max_examples=40, deadline=None)
def test_the_interpolating_surface_follows_a_point_linearly(seed, vector, factor):
    document = random_document(seed)
    once = of(document, PointMove(2, 3, vector))
    more = of(document, PointMove(2, 3, tuple(factor * x for x in vector)))
    expected = factor * once.displacement.coefficients[0, 0]
    assert more.displacement.coefficients[0, 0] == pytest.approx(expected, abs=1e-9 * (1 + np.abs(expected).max()))
    assert [reach.area for reach in more.reaches] == pytest.approx([reach.area for reach in once.reaches], abs=1e-6)


@given(seeds, vectors, st.sampled_from([0.0, 1e3, 1e6]))
@settings(max_examples=40, deadline=None)
def test_the_middle_point_leaves_all_edges_exactly(seed, vector, shift):
    document = random_document(seed)
    document = Document(
        document.control_points + shift, document.row_knots, document.column_knots, document.formulation
    )
    found = of(document, PointMove(2, 2, vector))
    assert set(found.edges.values()) == {0.0}
    assert not found.corners.any()
    assert found.still_u == found.still_v == (0.0, 1.0)
    assert found.largest > 0


def test_lines_on_which_a_weight_vanishes_stay():
    document = interpolating(rows=Knots(0.3, 0.45, 0.4, 0.7), columns=Knots(0.6, 0.5, 0.65, 0.35))
    beside = of(document, PointMove(1, 2, (0, 0, 1)))
    assert beside.still_u == pytest.approx((0, 1))
    assert beside.still_v == pytest.approx((0.65, 1))
    corner = of(document, PointMove(0, 4, (0, 0, 1)))
    assert corner.still_u == pytest.approx((0, 0.4, 1))  # b_4 touches 0 at u = 0 and crosses it at u_ip
    assert corner.still_v == pytest.approx((0, 0.65, 1))


def test_the_double_sum_moves_in_a_whole_cross():
    document = set_formulation(preset("fig5").document, Formulation.DOUBLE_SUM)
    found = of(document, PointMove(2, 2, (0, 0, 0.5)))
    assert not found.corners.any()
    assert min(found.edges.values()) > 0.2 * found.largest
    assert found.still_u == found.still_v == ()
    assert magnitude_at(found, [0.5], FINE).min() > 0.2 * found.largest
    assert magnitude_at(found, FINE, [0.5]).min() > 0.2 * found.largest
    assert found.reaches[0].area > 0.9


def test_the_published_surface_moves_in_a_whole_band():
    found = of(preset("fig5").document, PointMove(2, 2, (0, 0, 0.5)))
    assert (found.still_u, found.still_v) == ((), (0, 1))
    assert magnitude_at(found, FINE, [0.5]).min() > 0.7 * found.largest


@pytest.mark.parametrize("place", KNOTS, ids=str)
def test_knots_move_only_their_own_edge_of_the_interpolating_surface(place):
    own = {
        (Direction.ROWS, 1): Edge.V0,
        (Direction.ROWS, 3): Edge.V1,
        (Direction.COLUMNS, 1): Edge.U0,
        (Direction.COLUMNS, 3): Edge.U1,
    }
    document = random_document(5, low=0.2, high=0.7)
    found = of(document, KnotMove(place, 0.1))
    moved = {edge for edge, motion in found.edges.items() if motion > 0}
    assert (
        moved == {own[place.direction, place.curve]} & set(Edge) if (place.direction, place.curve) in own else not moved
    )
    assert not found.corners.any()
    assert found.largest > 0


def test_knots_move_the_crossing_edges_of_a_product_surface():
    document = random_document(5, Formulation.DOUBLE_SUM, low=0.2, high=0.7)
    found = of(document, KnotMove(KnotPlace(Direction.ROWS, 2, "s"), 0.1))
    assert found.edges[Edge.U0] == found.edges[Edge.U1] == 0
    assert found.edges[Edge.V0] > 0 < found.edges[Edge.V1]
    assert not found.corners.any()


@pytest.mark.parametrize("curve", range(5))
@pytest.mark.parametrize("layer", Layer)
def test_only_the_last_row_s_knots_move_the_published_surface(curve, layer):
    found = of(preset("fig6c").document, KnotMove(KnotPlace(Direction.ROWS, curve, "s"), 0.1), layer)
    if curve == 4:
        assert found.largest > 0.01
        assert found.falloff is not None
        return
    assert found.largest == 0
    assert not found.magnitude.any()
    assert set(found.edges.values()) == {0.0}
    assert found.falloff is None
    assert [(reach.area, reach.distance) for reach in found.reaches] == [(0, 0), (0, 0)]


def test_the_transformation_moves_what_the_point_does_not():
    document = random_document(4, samples=(101, 101))
    raw, transformed = (of(document, PointMove(2, 2, (0, 0, 1)), layer) for layer in Layer)
    assert not raw.corners.any()
    assert transformed.corners.min() > 0


@given(st.floats(1e-3, 1e3), st.floats(0.02, 20))
@settings(deadline=None)
def test_an_exponential_is_recognised(amplitude, length):
    distance = np.linspace(0, 1.4, 60)
    found = fit_exponential(distance, amplitude * np.exp(-distance / length))
    assert found.amplitude == pytest.approx(amplitude, rel=1e-5)
    assert found.length == pytest.approx(length, rel=1e-5)
    assert found.misfit < 1e-5
    assert found.fits
    assert found.at(np.array([length])) == pytest.approx([amplitude / np.e], rel=1e-4)


@given(documents(), indices, indices, vectors)
@settings(max_examples=40, deadline=None)
def test_no_other_exponential_is_nearer_and_no_sample_lies_above_the_envelope(document, i, j, vector):
    found = of(document, PointMove(i, j, vector))
    fall = found.falloff
    distance, displacement = fall.envelope.T
    assert (distance[0], displacement[0]) == (0, found.largest)
    assert (np.diff(distance) >= 0).all()
    bins = (fall.distance / 0.025).astype(int)
    for d, most in fall.envelope[1:]:
        assert found.magnitude[bins == int(d / 0.025)].max() == most
    best = fall.exponential

    def misfit(amplitude, length):
        return np.sqrt(np.mean((amplitude * np.exp(-distance / length) - displacement) ** 2)) / displacement.max()

    assert misfit(best.amplitude, best.length) == pytest.approx(best.misfit)
    for a, b in ((1.05, 1), (0.95, 1), (1, 1.05), (1, 0.95), (1.05, 1.05), (0.95, 0.95), (1.05, 0.95)):
        if best.length * b < 1e3:
            assert misfit(best.amplitude * a, best.length * b) >= best.misfit * (1 - 1e-9)


@pytest.mark.parametrize("formulation", FORMULATIONS.values(), ids=str)
@pytest.mark.parametrize(("i", "j"), [(2, 2), (1, 2), (0, 0), (4, 3)])
def test_the_displacement_is_not_exponential(formulation, i, j):
    document = random_document(3, formulation, low=0.3, high=0.7)
    exponential = of(document, PointMove(i, j, (0, 0, 0.5))).falloff.exponential
    assert exponential.misfit > 2 * EXPONENTIAL_MISFIT
    assert not exponential.fits


@pytest.mark.parametrize("layer", Layer)
def test_of_places_that_move_equally_the_first_is_told(layer):
    ridge = set_formulation(preset("fig5").document, "published")  # along u, as long as the surface
    assert influence(ridge, KnotMove(KnotPlace(Direction.COLUMNS, 1, "s"), 0.1), layer).place[0] == 0
    symmetric = set_formulation(preset("fig5").document, "double-sum")
    assert influence(symmetric, KnotMove(KnotPlace(Direction.ROWS, 2, "r"), 0.1), layer).place[1] == 0.5


def test_shares_of_the_area():
    u = np.linspace(0, 1, 101)
    grid_u, grid_v = np.meshgrid(u, u, indexing="ij")
    assert areas_above(grid_u + grid_v, [1.0]) == pytest.approx((0.5,), abs=1e-12)
    assert areas_above(grid_u - 0.3 * grid_v, [0.4]) == pytest.approx((0.45,), abs=1e-12)
    disc = 0.16 - (grid_u - 0.5) ** 2 - (grid_v - 0.5) ** 2
    assert areas_above(disc, [0]) == pytest.approx((np.pi * 0.16,), abs=2e-4)
    assert (*areas_above(grid_u, [2.0, -1.0]), *areas_above(0 * grid_u, [0.0])) == (0, 1, 0)


@pytest.mark.parametrize("formulation", FORMULATIONS)
def test_area_and_line_of_a_level_agree(formulation):
    """What the lines enclose with the border is the area: Green's theorem, side by side along the unit square."""
    document = random_document(5, formulation, low=0.3, high=0.7)
    found = of(document, PointMove(1, 3, (0.2, 0, 0.5)))
    for reach in found.reaches:
        level = reach.part * found.largest
        lines = level_line(found.magnitude, level)
        on_left = is_above_on_left(found, lines, level)
        forward = np.where(on_left[:, None, None], lines, lines[:, ::-1])
        (u0, v0), (u1, v1) = forward[:, 0].T, forward[:, 1].T
        enclosed = ((u0 + u1) * (v1 - v0)).sum() / 2 + length_above(found.magnitude[-1], level)  # u = 0 adds nothing
        assert enclosed == pytest.approx(areas_above(found.magnitude, [level])[0], abs=1e-9)


def is_above_on_left(found, lines, level):
    """Return for each segment whether the displacement is larger on its left; a hair away from its middle."""
    along = lines[:, 1] - lines[:, 0]
    normal = np.stack([-along[:, 1], along[:, 0]], axis=1)
    normal *= 1e-3 / np.maximum(np.linalg.norm(normal, axis=1, keepdims=True), 1e-300)
    middles = lines.mean(axis=1)
    left, right = (bilinear(found.magnitude, np.clip(middles + side * normal, 0, 1)) for side in (1, -1))
    return left > right


def bilinear(values, at):
    cells = np.minimum((at * 100).astype(int), 99)
    (i, j), (a, b) = cells.T, (at * 100 - cells).T
    low = (1 - b) * values[i, j] + b * values[i, j + 1]
    return (1 - a) * low + a * ((1 - b) * values[i + 1, j] + b * values[i + 1, j + 1])


def length_above(values, level):
    """Return how much of a side of the unit square lies above a level, linear between the samples."""
    a, b = values[:-1] - level, values[1:] - level
    parts = np.where((a > 0) & (b > 0), 1.0, 0.0)
    crossed = (a > 0) != (b > 0)
    parts[crossed] = np.maximum(a, b)[crossed] / np.abs(a - b)[crossed]
    return parts.sum() / len(parts)


def test_the_line_of_a_level():
    u = np.linspace(0, 1, 101)
    grid_u, grid_v = np.meshgrid(u, u, indexing="ij")
    straight = level_line(grid_u - 0.3 * grid_v, 0.4)
    assert straight[..., 0] - 0.3 * straight[..., 1] == pytest.approx(0.4, abs=1e-12)
    assert lengths_of(straight).sum() == pytest.approx(np.hypot(1, 0.3))
    circle = level_line(0.16 - (grid_u - 0.5) ** 2 - (grid_v - 0.6) ** 2, 0)
    assert np.hypot(circle[..., 0] - 0.5, circle[..., 1] - 0.6) == pytest.approx(0.4, abs=1e-4)
    assert lengths_of(circle).sum() == pytest.approx(2 * np.pi * 0.4, rel=1e-3)
    assert level_line(grid_u, 2.0).shape == (0, 2, 2)


def lengths_of(segments):
    return np.linalg.norm(segments[:, 1] - segments[:, 0], axis=1)


def test_the_reach_is_that_of_the_weight():
    found = of(interpolating(), PointMove(2, 2, (0, 0, 3.0)))
    weight = (bernstein.basis(6, FINE) @ weight_coefficients(np.full((1, 4), 0.5))[0, :, 2]).ravel()
    product = np.abs(np.outer(weight, weight))
    assert found.place == pytest.approx((0.5, 0.5), abs=1e-6)
    assert found.largest == pytest.approx(3.0, rel=1e-12)
    for reach in found.reaches:
        moved = product > reach.part
        assert reach.area == pytest.approx(moved.mean(), abs=0.01)
        distances = np.hypot(FINE[:, None] - 0.5, FINE[None, :] - 0.5)
        assert reach.distance == pytest.approx(distances[moved].max(), abs=0.02)


def test_what_is_no_document_is_refused():
    document = interpolating()
    place = KnotPlace(Direction.COLUMNS, 2, "u")
    with pytest.raises(DocumentError, match=r"column_knots\[2\].v is 1.1; expected a number strictly between 0 and 1"):
        of(document, KnotMove(place, 0.6))
    with pytest.raises(DocumentError, match=r"control_points\[2\]\[2\]\[0\]"):
        of(document, PointMove(2, 2, (1e13, 0, 0)))


@pytest.mark.parametrize(("layer", "least", "most"), [(Layer.RAW, 1e150, np.inf), (Layer.TRANSFORMED, 1e3, 1e8)])
def test_enormous_displacements_are_measured_without_overflow(layer, least, most):
    """After T they are as large as the net, some millions."""
    knot = Knots(1e-100, 0.5, 0.5, 0.5)
    document = Document(1e6 * random_net(2), (knot,) * 5, (knot,) * 5, Formulation.DOUBLE_SUM, (7, 5))
    found = of(document, KnotMove(KnotPlace(Direction.ROWS, 4, "r"), 0.1), layer)
    assert least < found.largest < most
    assert np.isfinite(found.magnitude).all()
    assert np.isfinite([*found.edges.values(), found.falloff.exponential.misfit]).all()


@given(documents(), st.sampled_from(KNOTS))
@settings(max_examples=50, deadline=None)
def test_the_default_change_of_a_knot_stays_inside(document, place):
    amount = default_amount(document, place)
    assert abs(amount) == 0.1
    KnotMove(place, amount).applied(document)


def test_the_size_of_the_net_is_the_diagonal_of_its_box():
    assert preset("fig5").document.net_size == pytest.approx(np.sqrt(4**2 + 4**2 + 0.1**2))


def test_results_are_locked():
    found = of(interpolating(), PointMove(2, 2, (0, 0, 1)))
    for array in (found.magnitude, found.corners, found.falloff.distance, found.falloff.envelope):
        assert not array.flags.writeable
