"""The paper's claims: the verdicts that are expected, and each measurement against another way to compute it."""

import pickle
from dataclasses import replace
from itertools import product

import numpy as np
import pytest
from hypothesis import given, settings

from qovr_core import FORMULATIONS, Document, Edge, Evaluation, Formulation, Knots, Patch, build_patch, edits
from qovr_core.edits import Direction, set_all_knots
from qovr_core.geometry import bernstein
from qovr_core.geometry.weights import weight_coefficients
from qovr_core.laboratory import curve_claims, fairness, joint_claims, knot_claims, shape_claims
from qovr_core.laboratory.claims import CLAIMS, Claim
from qovr_core.laboratory.claims_report import findings_markdown, findings_text
from qovr_core.laboratory.jumps import jumps
from qovr_core.laboratory.measurement import Condition, Measurement
from qovr_core.laboratory.neighbours import Continuation, continued
from qovr_core.laboratory.proofs import Proof
from qovr_core.laboratory.splines import catmull_rom
from qovr_core.laboratory.trials import SAMPLES
from qovr_core.laboratory.verify import Ground, Verdict, decide, verify
from qovr_core.presets import preset
from support.documents import knots, random_document, random_net, seeds, with_knot

TRUE, TRUE_IF, FALSE = Verdict

EXPECTED = {
    "inverse": (TRUE, TRUE, FALSE),
    "unity": (TRUE, TRUE, TRUE_IF),
    "quartic": (TRUE_IF, TRUE_IF, TRUE_IF),
    "ends": (FALSE, FALSE, FALSE),
    "tangents": (FALSE, FALSE, FALSE),
    "curvatures": (FALSE, FALSE, FALSE),
    "C0": (TRUE, FALSE, FALSE),
    "C1": (TRUE_IF, FALSE, FALSE),
    "G1": (TRUE_IF, FALSE, FALSE),
    "C2": (TRUE, TRUE, TRUE),
    "edges": (TRUE_IF, FALSE, FALSE),
    "edges'": (TRUE_IF, FALSE, FALSE),
    "local": (FALSE, FALSE, FALSE),
    "symmetry": (TRUE, TRUE, TRUE_IF),
    "boxes": (TRUE, TRUE, TRUE),
}
"""Verdicts for interpolating, double-sum, published; ``fairness`` is decided by every document for itself."""

INTERPOLATING, DOUBLE_SUM, PUBLISHED = Formulation.INTERPOLATING, Formulation.DOUBLE_SUM, Formulation.PUBLISHED
KEEPS_EDGES = "C_0, C_2, C_4, K_0, K_2, K_4"


def with_all(document, *values):
    return set_all_knots(document, Knots(*values))


def of_conditions():
    """Documents that meet a condition and documents that just do not, by name."""
    document = random_document(31, samples=(9, 9))
    yield "0.5", with_all(document)
    yield "kernels hold", with_all(document, 0.4, 0.6, 0.7, 0.4)
    yield "kernels do not", with_all(document, 0.3, 0.5, 0.5, 0.7)
    for name, made in (
        ("degree", curve_claims.degree_examples(document)),
        ("crossing", joint_claims.crossing_examples(document)),
        ("smooth", joint_claims.smooth_examples(document)),
        ("symmetry", shape_claims.symmetry_examples(document)),
        ("box", knot_claims.box_examples(document)),
    ):
        yield from ((f"{name} {k}", entry) for k, entry in enumerate(made))


DOCUMENTS = {
    **{name: preset(name).document for name in ("fig5", "fig6b", "fig6c", "fig6d", "fig8")},
    **{f"random {seed}": random_document(seed) for seed in range(20)},
    **dict(of_conditions()),
}


@pytest.mark.parametrize("name", DOCUMENTS)
def test_the_verdicts_are_those_of_the_table(name):
    document = DOCUMENTS[name]
    found = {(finding.claim.name, finding.formulation): finding for finding in verify(document)}
    verdicts = {
        claim: tuple(found[claim, formulation].verdict for formulation in (INTERPOLATING, DOUBLE_SUM, PUBLISHED))
        for claim in EXPECTED
    }
    assert verdicts == EXPECTED
    assert found["edges", INTERPOLATING].condition == f"the knot belongs to {KEEPS_EDGES}"
    assert found["edges'", INTERPOLATING].condition.startswith(f"the knot belongs to {KEEPS_EDGES}, and the box")
    for (claim, formulation), finding in found.items():
        assert finding.ground is expected_ground(claim, formulation, finding.verdict)
        assert bool(finding.proof) == (finding.ground is Ground.PROVED)
        assert (finding.verdict is TRUE_IF) == bool(finding.condition)
        assert (finding.verdict is FALSE) == (finding.counterexample is not None)
        if finding.counterexample is not None:
            assert finding.counterexample.formulation == formulation
            assert not finding.claim.measure(finding.counterexample).holds
            if not finding.here.holds:
                assert finding.counterexample == replace(document, formulation=formulation)


def expected_ground(claim, formulation, verdict):
    if claim == "fairness":
        return Ground.DOCUMENT
    if verdict is FALSE:
        return Ground.COUNTEREXAMPLE
    return Ground.TRIALS if (claim, formulation) == ("C2", PUBLISHED) else Ground.PROVED


def test_the_verdicts_do_not_depend_on_the_net_s_size_or_place():
    document = random_document(4)
    for size, shift in ((1e-6, 0.0), (1e6, 0.0), (1.0, 1e4)):
        moved = edits.set_points(document, size * document.control_points + shift)
        verdicts = [finding.verdict for finding in verify(moved)]
        assert verdicts == [finding.verdict for finding in verify(document)]


def test_every_finding_is_reported_as_soon_as_it_is_known():
    told = []
    findings = verify(random_document(5), report=told.append)
    assert tuple(told) == findings
    assert [(finding.claim.name, finding.formulation.name) for finding in told] == list(product(CLAIMS, FORMULATIONS))


def test_what_the_report_raises_ends_the_work():
    told = []

    def cancel(finding):
        told.append(finding)
        if len(told) == 2:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        verify(random_document(5), report=cancel)
    assert len(told) == 2


def test_a_claim_from_outside_is_decided_by_its_record():
    text = "the net has five rows"
    claim = Claim("rows", text, "5.1", lambda document: Measurement(len(document.control_points), "rows", holds=True))
    with CLAIMS.register(claim):
        findings = verify(random_document(6))
        assert [(finding.claim, finding.verdict) for finding in findings[-3:]] == [(claim, TRUE)] * 3
        assert findings_text(findings).splitlines()[-4:-3] == ["  rows"]
        assert (
            findings_markdown(findings).splitlines()[-1].startswith(f"| {text} | 5.1 | **not refuted by 3 trials** |")
        )
    assert all(finding.claim != claim for finding in verify(random_document(6)))


# --- how a verdict comes about ----------------------------------------------------------------------------------------


def claim_that(holds, **options):
    return Claim("x", "", "", lambda document: Measurement(0.0, "", holds(document)), **options)


def is_wide(document):
    return document.samples[0] > 50


def test_a_verdict_needs_trials_that_meet_the_condition_and_trials_that_do_not():
    document = random_document(1, samples=(9, 9))
    wide = replace(document, samples=(99, 9))
    condition = Condition("it is wide", is_wide)
    cases = (
        (claim_that(lambda _: True), TRUE, ""),
        (claim_that(is_wide), FALSE, ""),
        (claim_that(is_wide, condition=condition), FALSE, ""),  # nothing tried meets it
        (claim_that(is_wide, condition=condition, examples=lambda _: (wide,)), TRUE_IF, "it is wide"),
        (claim_that(lambda _: False, condition=condition, examples=lambda _: (wide,)), FALSE, ""),
    )
    for claim, verdict, text in cases:
        finding = decide(claim, document, document.formulation)
        assert (finding.verdict, finding.condition) == (verdict, text)
        assert finding.counterexample == (document if verdict is FALSE else None)
        assert finding.ground is (Ground.COUNTEREXAMPLE if verdict is FALSE else Ground.TRIALS)


def test_what_only_trials_support_says_how_many_there_were():
    measured = []

    def measure(document):
        measured.append(document)
        return Measurement(0.0, "", holds=True)

    document = random_document(1, samples=(9, 9))
    wide = tuple(replace(document, samples=(99, k)) for k in range(9, 12))
    finding = decide(Claim("x", "", "", measure, examples=lambda _: wide), document, INTERPOLATING)
    assert (finding.trials, finding.words) == (len(measured), f"not refuted by {len(measured)} trials")
    condition = Condition("it is wide", is_wide)
    of_wide = claim_that(is_wide, condition=condition, examples=lambda _: wide)
    finding = decide(of_wide, document, INTERPOLATING)
    assert finding.trials == 2 * len(wide)  # made from the document, and from the first random one
    assert finding.words == f"not refuted by {finding.trials} trials if"


def test_a_proof_counts_only_where_it_holds_and_speaks_of_all_that_is_claimed():
    document = random_document(1)
    held, refuted = Proof("so it is", (lambda: True,)), Proof("so it is", (lambda: True, lambda: False))
    for proof, ground in ((held, Ground.PROVED), (refuted, Ground.TRIALS)):
        finding = decide(claim_that(lambda _: True, proofs={INTERPOLATING: proof}), document, INTERPOLATING)
        assert (finding.ground, finding.proof) == (ground, "so it is" if proof is held else "")
        finding = decide(claim_that(lambda _: True, proofs={INTERPOLATING: proof}), document, PUBLISHED)
        assert finding.ground is Ground.TRIALS
        finding = decide(claim_that(lambda _: False, proofs={INTERPOLATING: proof}), document, INTERPOLATING)
        assert finding.ground is Ground.COUNTEREXAMPLE
    edges = CLAIMS["edges"]
    proof = edges.proofs[INTERPOLATING]
    fewer = replace(edges, proofs={INTERPOLATING: replace(proof, parts=proof.parts - {"C_2"})})
    assert decide(edges, document, INTERPOLATING).ground is Ground.PROVED
    assert decide(fewer, document, INTERPOLATING).ground is Ground.TRIALS


def test_what_is_decided_by_the_document_alone_asks_no_other():
    claim = claim_that(is_wide, is_general=False)
    document = random_document(1, samples=(99, 9))
    assert decide(claim, document, PUBLISHED).verdict is TRUE
    assert decide(claim, replace(document, samples=(9, 9)), PUBLISHED).verdict is FALSE


# --- curves -----------------------------------------------------------------------------------------------------------


@given(knots, seeds)
@settings(max_examples=60, deadline=None)
def test_the_published_weights_sum_to_one_exactly_where_the_condition_says(curve, seed):
    document = replace(with_all(random_document(seed), *curve), formulation=PUBLISHED)
    assert curve_claims.unity(document).holds == curve_claims.KERNELS_HOLD.is_met(document)


def test_the_published_kernels_of_the_paper_s_cases():
    for name, holds in (("fig5", True), ("fig6b", False), ("fig6c", True)):
        assert curve_claims.unity(preset(name).document).holds == holds
    assert curve_claims.unity(preset("fig6b").document).value == pytest.approx(2.1e-5, rel=0.2)
    assert curve_claims.inverse(preset("fig6b").document).value < 1e-4


@given(knots)
@settings(max_examples=60, deadline=None)
def test_every_formulation_is_quartic_exactly_where_s_is_u(curve):
    for s in (curve.s, curve.u):
        document = with_all(random_document(1), curve.r, s, curve.u, curve.t)
        measured = curve_claims.quartic(document)
        assert measured.holds == (abs(s - curve.u) < 1e-9)


def test_the_degree_of_known_polynomials():
    for degree in range(7):
        powers = np.polynomial.Polynomial([0] * degree + [1.0])
        values = powers(np.linspace(0, 1, 7))
        coefficients = np.linalg.solve(bernstein.basis(6, np.linspace(0, 1, 7)), values)
        assert curve_claims.polynomial_degree(coefficients[:, None], np.array([1e-12])) == degree


def test_the_rows_at_the_ends_are_printed_as_found():
    document = preset("fig5").document
    assert curve_claims.ends(document).note.endswith("has [0 1 0 0 0] at 0 and [0 0 0 1 0] at 1")
    assert curve_claims.tangents(document).note.endswith("has [-1 0 1 0 0] at 0 and [0 0 -1 0 1] at 1")
    assert curve_claims.curvatures(document).note.endswith("has [8 -22 22 -10 2] at 0 and [2 -10 22 -22 8] at 1")


# --- neighbours -------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("seed", range(5))
def test_neighbours_meet_to_rounding_and_share_their_points_and_knots(seed):
    document = random_document(seed)
    for joint in continued(document, Continuation.DRAWN):
        first, second = joint.first, joint.second
        end, start = build_patch(first), build_patch(second)
        if joint.across is Direction.ROWS:
            assert np.array_equal(second.control_points[:, :3], first.control_points[:, 2:])
            assert second.column_knots.in_window(0)[:3] == first.column_knots.in_window(0)[2:]
            gap = end.edge(Edge.U1)[0] - start.edge(Edge.U0)[0]
        else:
            assert np.array_equal(second.control_points[:3], first.control_points[2:])
            assert second.row_knots.in_window(0)[:3] == first.row_knots.in_window(0)[2:]
            gap = end.edge(Edge.V1)[0] - start.edge(Edge.V0)[0]
        assert np.abs(gap).max() <= 1e-12 * np.abs(end.coefficients[0, 0]).max()
        assert jumps([joint.sides()]).by_order[0].is_rounding


def cross_derivatives(document, order, along):
    """Yield the cross derivative on both sides of both joints, of the exact patches."""
    for joint in continued(document, Continuation.DRAWN):
        first, second = build_patch(joint.first), build_patch(joint.second)
        if joint.across is Direction.ROWS:
            yield first.derivative([1.0], along, order, 0)[0], second.derivative([0.0], along, order, 0)[0]
        else:
            yield first.derivative(along, [1.0], 0, order)[:, 0], second.derivative(along, [0.0], 0, order)[:, 0]


@pytest.mark.parametrize("seed", range(5))
def test_c1_holds_to_1e_9_where_its_condition_is_met_and_nowhere_else(seed):
    met = 0
    for document in (random_document(seed), *joint_claims.crossing_examples(random_document(seed))):
        jumps = [
            np.abs(end - start).max() / np.abs(end).max()
            for end, start in cross_derivatives(document, 1, np.linspace(0, 1, 17))
        ]
        if joint_claims.KNOTS_CROSS_ALIKE.is_met(document):
            met += 1
            assert max(jumps) <= 1e-9
        else:
            assert max(jumps) >= 1e-3
        assert joint_claims.c1(document).holds == joint_claims.KNOTS_CROSS_ALIKE.is_met(document)
    assert met == 3


def test_the_jumps_are_those_of_the_exact_derivatives_and_of_differences():
    document = random_document(6)
    along, step = np.linspace(0, 1, 41), 1e-5
    size = max(
        np.ptp(build_patch(part).coefficients[0, 0], axis=(0, 1)).max()
        for joint in continued(document, Continuation.DRAWN)
        for part in (joint.first, joint.second)
    )
    for order, measure in ((1, joint_claims.c1), (2, joint_claims.c2)):
        jumps = [np.linalg.norm(end - start, axis=-1).max() for end, start in cross_derivatives(document, order, along)]
        assert measure(document).value * size == pytest.approx(max(jumps), rel=0.3)
    joint = continued(document, Continuation.DRAWN)[0]
    first, second = build_patch(joint.first), build_patch(joint.second)
    left = (first.points([1.0], along) - first.points([1 - step], along))[0] / step
    right = (second.points([step], along) - second.points([0.0], along))[0] / step
    exact = next(end - start for end, start in cross_derivatives(document, 1, along))
    assert np.abs(left - right - exact).max() <= 1e-3 * np.abs(exact).max()


def test_a_net_without_a_jump_of_the_second_derivative_is_found():
    found = joint_claims.c2(random_document(2))
    assert found.holds
    assert found.example is not None
    for joint in continued(found.example, Continuation.REFLECTED):
        assert jumps([joint.sides()]).are_rounding
    again = joint_claims.c2(found.example)
    assert again.example == found.example
    assert "this net" in again.note
    assert joint_claims.c2(replace(found.example, formulation=DOUBLE_SUM)).example is None


# --- knots and edges --------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("formulation", FORMULATIONS.values(), ids=str)
def test_the_moves_of_knots_are_those_of_edited_documents(formulation):
    document = random_document(8, formulation, low=0.2, high=0.8)
    moves = knot_claims.knot_moves(document)
    before = build_patch(document)
    size = np.ptp(before.coefficients[0, 0], axis=(0, 1)).max()
    basis = bernstein.basis(6, np.linspace(0, 1, SAMPLES[0]))
    for k, (direction, curve, name) in enumerate(
        (direction, curve, name) for direction in Direction for curve in range(5) for name in "rsut"
    ):
        value = getattr(edits.knots_of(document, direction)[curve, 0], name) + knot_claims.KNOT_STEP
        after = build_patch(with_knot(document, direction, name, value, curve=curve))
        expected = [
            np.linalg.norm(basis @ (after.edge(edge)[0] - before.edge(edge)[0]), axis=-1).max() / size for edge in Edge
        ]
        assert np.allclose(moves.raw.parts[k], expected, rtol=1e-6, atol=1e-12)
        assert moves.curve[k] == curve + 5 * (direction is Direction.COLUMNS)


def test_which_edge_moves_under_which_curve():
    note = knot_claims.edges(random_document(3)).note
    assert "u=0 moves under K_1; u=1 moves under K_3; v=0 moves under C_1; v=1 moves under C_3; corners keep" in note
    crossing = knot_claims.edges(random_document(3, DOUBLE_SUM)).note
    assert "u=0 moves under K_0, K_1, K_2, K_3, K_4; " in crossing
    assert "v=0 moves under C_0, C_1, C_2, C_3, C_4; " in crossing
    assert not {"C_0", "C_1", "C_2", "C_3"} & set(knot_claims.edges(random_document(3, PUBLISHED)).parts)


def test_a_knot_near_the_end_of_its_range_is_moved_inside_it():
    document = with_all(random_document(3), 0.95, 0.5, 0.5, 0.04)
    assert np.isfinite(knot_claims.knot_moves(document).raw.parts).all()


# --- shape ------------------------------------------------------------------------------------------------------------


def test_the_influence_of_a_point_is_a_product_of_weights_where_knots_are_equal():
    document = with_all(random_document(9), 0.4, 0.5, 0.6, 0.3)
    weights = bernstein.basis(6, np.linspace(0, 1, 21)) @ weight_coefficients([0.4, 0.5, 0.6, 0.3])
    step = shape_claims.POINT_STEP * document.net_size
    expected = np.abs(np.einsum("uj,vi->ijuv", weights, weights)) * step
    moved = shape_claims.point_displacements(document)
    assert np.allclose(moved, expected, atol=1e-9)
    centre = moved[2, 2]
    assert max(centre[0].max(), centre[-1].max(), centre[:, 0].max(), centre[:, -1].max()) <= 1e-12


def test_an_exponential_is_recognised():
    u = np.linspace(0, 1, 21)
    distance = np.hypot(u[:, None] - 0.5, u - 0.25)
    assert shape_claims.misfit_of_exponential(3 * np.exp(-distance / 0.2)) <= 0.02
    assert shape_claims.misfit_of_exponential(np.maximum(1 - 4 * distance**2, 0)) >= shape_claims.FITS


@pytest.mark.parametrize("formulation", FORMULATIONS.values(), ids=str)
def test_symmetric_nets_are_symmetric(formulation):
    made = shape_claims.symmetric_documents(random_document(10, formulation))
    mirrored = made["mirror in u"].control_points
    assert np.allclose(mirrored[:, ::-1, 1:], mirrored[..., 1:])
    assert np.allclose(mirrored[:, ::-1, 0] + mirrored[..., 0], mirrored[0, 0, 0] + mirrored[0, 4, 0])
    turned = made["half-turn"].control_points
    assert np.allclose(turned[::-1, ::-1, 2], turned[..., 2])
    assert not np.allclose(turned[:, ::-1, 2], turned[..., 2])


def test_the_published_surface_is_symmetric_exactly_where_row_4_is():
    for seed in range(10):
        for document in shape_claims.symmetry_examples(random_document(seed, PUBLISHED)):
            assert shape_claims.symmetry(document).holds == shape_claims.ROW_4_SYMMETRIC.is_met(document)


def test_half_a_turn_in_space_is_kept_by_the_interpolating_surface_alone():
    u, v = np.linspace(0, 1, 7), np.linspace(0, 1, 5)
    for formulation in FORMULATIONS.values():
        measured = shape_claims.symmetry(random_document(12, formulation))
        assert (measured.example is None) == (formulation is INTERPOLATING)
    example = shape_claims.symmetry(random_document(12, DOUBLE_SUM)).example
    net = example.control_points
    middle = net.mean(axis=(0, 1))
    assert np.allclose(net[::-1, ::-1] - middle, (net - middle) * [-1, -1, 1])
    points = build_patch(example).points(u, v)
    sums = points[::-1, ::-1] + points
    assert np.ptp(sums[..., 0]) > 1e-3 * np.ptp(points[..., 0])


def test_a_flat_raw_surface_has_no_scale():
    net = random_net(1)
    net[4, :, 2] = 0
    document = Document(net)
    finding = decide(CLAIMS["boxes"], document, PUBLISHED)
    assert finding.verdict is TRUE_IF
    assert not finding.here.holds
    assert "no extent along z" in finding.here.note
    assert decide(CLAIMS["boxes"], document, INTERPOLATING).verdict is TRUE


# --- fairness ---------------------------------------------------------------------------------------------------------


def graph(height):
    """Return a polynomial patch z = height(x, y) over the unit square, x = u, y = v."""
    places = np.linspace(0, 1, 7)
    u, v = np.meshgrid(places, places, indexing="ij")
    inverse = np.linalg.inv(bernstein.basis(6, places))
    return Patch(np.einsum("ai,bj,ijk->abk", inverse, inverse, np.stack([u, v, height(u, v)], axis=-1)))


@pytest.mark.parametrize(
    ("height", "changes"),
    [
        (lambda x, y: 2 + 3 * x - y, 0),  # a plane
        (lambda x, y: x**2 - y**2, 0),  # a saddle bends one way along every isoline
        (lambda x, y: (x - 0.5) ** 3 + y**2, 9),  # one inflection on each line of one direction
        (lambda x, y: (x - 0.5) ** 3 * (y - 0.5) ** 3, 16),  # both ways, but not on the middle line
        (lambda x, y: (x - 0.3) ** 4 - 0.1 * (x - 0.3) ** 2, 18),  # two on each
    ],
)
def test_waves_are_counted(height, changes):
    patch = graph(height)
    assert fairness.sign_changes(patch) == changes
    assert fairness.sign_changes(patch.transformed(np.diag([3.0, 0.5, 40.0, 1.0]))) == changes


@pytest.mark.parametrize("seed", range(5))
def test_fairness_is_decided_by_the_document_against_catmull_rom(seed):
    document = random_document(seed)
    others = fairness.sign_changes(catmull_rom(document.control_points))
    for formulation in FORMULATIONS.values():
        finding = decide(CLAIMS["fairness"], document, formulation)
        own = fairness.sign_changes(build_patch(replace(document, formulation=formulation)))
        assert finding.here.value == own
        assert finding.verdict is (TRUE if own <= others else FALSE)
        assert str(others) in finding.here.note
        aligned = Evaluation(replace(document, formulation=formulation))
        assert fairness.sign_changes(aligned.transformed_patch) == own


def test_findings_can_go_to_another_process():
    for finding in verify(random_document(5)):
        copy = pickle.loads(pickle.dumps(finding))
        assert copy.claim in CLAIMS.values()
        assert (copy.formulation, copy.verdict, copy.largest) == (finding.formulation, finding.verdict, finding.largest)
        assert copy.counterexample == finding.counterexample
