"""What counts as rounding, and so as flat, is measured by what is added up, not by what comes out of it."""

from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest

from qovr_core import FORMULATIONS, Document, Evaluation, Formulation, Knots, Layer
from qovr_core.construction import document_arrays
from qovr_core.edits import Direction, KnotPlace, set_point
from qovr_core.geometry import bernstein
from qovr_core.geometry.weights import weight_coefficients
from qovr_core.laboratory.influence import KnotMove, influence
from qovr_core.presets import preset
from qovr_core.report import facts_text, surface_facts
from support.algorithm1 import point
from support.documents import random_document
from support.exact import weights as exact_weights

EVERY = pytest.mark.parametrize("formulation", FORMULATIONS.values(), ids=str)
PLACES = [(Fraction(0), Fraction(1)), (Fraction(1, 4), Fraction(3, 4)), (Fraction(1, 2), Fraction(1, 2))]


def moved_paper(formulation, x=-2, y=-2, z=0.0):
    document = preset("fig5").document
    return replace(document, control_points=document.control_points + np.array([x, y, z]), formulation=formulation)


def exact_point(document, u, v):
    """Return S(u, v) as three Fractions."""
    net, rows, columns = (
        [[list(map(Fraction, p)) for p in r] for r in document.control_points.tolist()],
        *(
            [[Fraction(knot) for knot in curve] for curve in knots.array[:, 0].tolist()]
            for knots in (document.row_knots, document.column_knots)
        ),
    )
    return point(net, rows, columns, str(document.formulation), u, v)


def extreme_document(seed, formulation):
    """Return a document about the origin, or far from it, whose knots may all lie near 0 and 1."""
    rng = np.random.default_rng(seed)
    net = rng.uniform(-1, 1, (5, 5, 3)) * [1e-3, 1, 1e3]
    net = net - net.mean(axis=(0, 1)) if seed % 2 else net + 1e3
    margin = [0.2, 0.05, 1e-3, 1e-6][seed % 4]
    knots = rng.uniform(margin, 1 - margin, (2, 5, 4))
    if seed % 3 == 0:
        knots = np.broadcast_to(np.where(rng.random((2, 1, 4)) < 0.5, margin, 1 - margin), (2, 5, 4))
    rows, columns = (tuple(Knots(*curve) for curve in family) for family in knots.tolist())
    return Document(net, rows, columns, formulation, (5, 5))


@EVERY
@pytest.mark.parametrize("seed", range(6))
def test_the_rounding_of_a_surface_stays_far_below_its_bound(seed, formulation):
    document = extreme_document(seed, formulation)
    if formulation is Formulation.PUBLISHED:  # cut kernels of knots this near an end are cut elsewhere by exact ones
        document = replace(document, row_knots=(Knots(0.3, 0.4, 0.6, 0.7),) * 5, column_knots=(Knots(s=0.2),) * 5)
    evaluation = Evaluation(document)
    for u, v in PLACES:
        found = evaluation.patch.points([float(u)], [float(v)])[0, 0].tolist()
        for value, exact, rounding in zip(found, exact_point(document, u, v), evaluation.rounding, strict=True):
            assert abs(Fraction(value) - exact) <= rounding / 8


@EVERY
@pytest.mark.parametrize("seed", range(40))
def test_an_axis_is_flat_exactly_where_exact_arithmetic_has_no_extent(seed, formulation):
    """Heights that are antisymmetric, from row to row or within each, have sums that cancel."""
    rng = np.random.default_rng(seed)
    net = rng.uniform(-1, 1, (5, 5, 3)) * 10.0 ** rng.integers(-8, 8)
    turned = net[::-1] if seed % 2 else net[:, ::-1]
    net[..., 2] -= turned[..., 2]
    row, column = (Knots(*rng.uniform(0.1, 0.9, 4).tolist()) for _ in range(2))
    evaluation = Evaluation(Document(net, (row,) * 5, (column,) * 5, formulation, (4, 4)))
    cancels = {"published": seed % 2 == 0, "double-sum": True, "interpolating": False}[str(formulation)]
    assert evaluation.flat_axes == (("z",) if cancels else ())
    assert evaluation.matrix[2, 2] == 1 or not cancels


@pytest.mark.parametrize(
    ("formulation", "flat"), [("published", ("x",)), ("double-sum", ("x", "y")), ("interpolating", ())]
)
def test_the_papers_net_about_the_origin(formulation, flat):
    evaluation = Evaluation(moved_paper(formulation))
    assert evaluation.flat_axes == flat
    assert np.abs(evaluation.matrix).max() < 100
    assert all(evaluation.matrix["xyz".index(axis), "xyz".index(axis)] == 1 for axis in flat)
    text = facts_text(surface_facts(evaluation))
    assert (f"no extent along {', '.join(flat)}:" in text) == bool(flat)


@EVERY
def test_what_is_larger_than_rounding_is_no_flat_axis(formulation):
    document = preset("fig5").document
    net = document.control_points.copy()
    net[..., 2] = 1 + 1e-11 * (net[..., 0] + net[..., 1])
    assert Evaluation(replace(document, control_points=net, formulation=formulation)).flat_axes == ()


@EVERY
def test_one_from_outside_without_summands_has_a_safe_bound(formulation):
    unknown = replace(formulation, summands=None)
    for document in (moved_paper(formulation), *(random_document(seed, formulation) for seed in range(5))):
        arrays = document_arrays(document)
        assert (unknown.rounding(*arrays) >= formulation.rounding(*arrays)).all()
        assert (unknown.rounding(*arrays) <= 100 * formulation.rounding(*arrays)).all()
        assert Evaluation(replace(document, formulation=unknown)).flat_axes == Evaluation(document).flat_axes


@pytest.mark.parametrize("u_ip", [1 - 1e-3, 1 - 1e-6, 1 - 1e-9, 1e-9])
def test_weights_keep_their_digits_where_the_middle_knot_is_near_an_end(u_ip):
    knots = (0.5, 0.25, u_ip, 0.5)
    weights = weight_coefficients(knots)
    for u in (0.0, 0.25, 0.75):
        exact = np.array([float(weight) for weight in exact_weights(*knots, u)])
        assert bernstein.basis(6, [u])[0] @ weights == pytest.approx(exact, rel=1e-13, abs=1e-14 * abs(weights).max())


def test_a_knot_without_effect_moves_nothing_where_sums_cancel():
    document = moved_paper("double-sum")
    found = influence(document, KnotMove(KnotPlace(Direction.ROWS, 2, "r"), 0.1), Layer.RAW)
    assert not found.displacement.coefficients[0, 0][..., :2].any()
    assert found.largest > 0.001


def test_after_any_row_of_edits_only_the_windows_they_touched_are_rounded():
    """Several moves may come before anybody asks."""
    computed = []

    def counted(net, row_knots, column_knots):
        computed.append(net.shape[:-3])
        return Formulation.INTERPOLATING.summands(net, row_knots, column_knots)

    formulation = replace(Formulation.INTERPOLATING, name="counted", summands=counted)
    document = Document(np.random.default_rng(4).normal(size=(13, 15, 3)), formulation=formulation)
    evaluation = Evaluation(document)
    assert evaluation.rounding.shape == (3,)
    for i, j in ((1, 1), (1, 1), (5, 5)):
        evaluation = Evaluation(set_point(evaluation.document, i, j, (9, 9, 9)), evaluation)
    assert np.array_equal(evaluation.rounding, Evaluation(evaluation.document).rounding)
    assert computed == [(5, 6), (5,), (5, 6)]  # P 1,1 is in one window, P 5,5 in four
