"""Nets of many windows: what they are made of, where their windows meet, and that each is a patch by itself."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from qovr_core import FORMULATIONS, Document, DocumentError, Evaluation, Formulation, build_patch, edits
from qovr_core.edits import KnotPlace, extract_window
from qovr_core.files.qovr_document import document_from_json, document_to_json
from qovr_core.geometry.closest import closest_points
from qovr_core.geometry.knots import Direction
from qovr_core.geometry.locate import spread
from qovr_core.joints import Joint, Joints
from support.nets import closed_net, random_net_document

WINDOWS = [(1, 1), (1, 3), (2, 1), (3, 4), (6, 5)]
EVERY = pytest.mark.parametrize("formulation", FORMULATIONS.values(), ids=str)


def windows_of(document):
    return list(np.ndindex(document.windows))


@EVERY
@pytest.mark.parametrize("windows", WINDOWS)
def test_each_window_is_a_patch_by_itself_bit_for_bit(windows, formulation):
    document = random_net_document(1, windows, formulation=formulation)
    patch = build_patch(document)
    assert patch.windows == windows
    for a, b in windows_of(document):
        alone = build_patch(extract_window(document, (a, b)))
        assert np.array_equal(patch.coefficients[a, b], alone.coefficients[0, 0])


@given(st.integers(0, 10_000), st.sampled_from(WINDOWS))
def test_smooth_nets_are_c1_in_their_own_parameter(seed, windows):
    patch = build_patch(random_net_document(seed, windows))
    for axis, (breaks, order) in enumerate(zip(patch.breaks, ((1, 0), (0, 1)), strict=True)):
        along = np.linspace(*patch.domain[1 - axis], 37)
        size = np.abs(patch.derivative(*(np.linspace(*ends, 60) for ends in patch.domain), *order)).max()
        for k, at in enumerate(breaks):
            sides = jump_sides(patch, axis, k, at, along, order)
            assert np.abs(sides[0] - sides[1]).max() <= 1e-12 * max(size, np.abs(sides[0]).max())


def jump_sides(patch, axis, joint, at, along, order):
    """Return a derivative on both sides of a joint: from the window before it, and from the one that begins there."""
    ends = (at, along) if axis == 0 else (along, at)
    after = patch.derivative(*map(np.atleast_1d, ends), *order)
    coefficients = patch.coefficients
    cut = coefficients[:, : joint + 1] if axis == 0 else coefficients[: joint + 1]
    lengths = tuple(
        each[: joint + 1] if k == axis else each for k, each in enumerate(np.diff(ends) for ends in patch.breakpoints)
    )
    before = type(patch)(cut, patch.degree, lengths).derivative(*map(np.atleast_1d, ends), *order)
    return before, after


@given(st.integers(0, 10_000), st.sampled_from(WINDOWS[1:]))
def test_joints_of_any_knots_have_no_gap(seed, windows):
    document = random_net_document(seed, windows, smooth=0.0)
    patch = build_patch(document)
    size = np.abs(patch.coefficients).max()
    c = patch.coefficients
    assert np.abs(c[:, :-1, -1] - c[:, 1:, 0]).max(initial=0) <= 1e-13 * size
    assert np.abs(c[:-1, :, :, -1] - c[1:, :, :, 0]).max(initial=0) <= 1e-13 * size


@pytest.mark.parametrize("windows", WINDOWS)
def test_a_document_reads_back_to_the_last_bit(windows):
    document = random_net_document(4, windows, smooth=0.5)
    text = document_to_json(document)
    assert f'"version": {1 if windows == (1, 1) else 2}' in text
    assert document_from_json(text) == document
    assert hash(document_from_json(text)) == hash(document)


@pytest.mark.parametrize("along", [("u",), ("v",), ("u", "v")])
def test_a_closed_net_meets_itself(along):
    document = closed_net(2, (3, 4), along)
    assert document_from_json(document_to_json(document)) == document
    c = build_patch(document).coefficients
    if "u" in along:
        assert np.abs(c[:, -1, -1] - c[:, 0, 0]).max() < 1e-13
    if "v" in along:
        assert np.abs(c[-1, :, :, -1] - c[0, :, :, 0]).max() < 1e-13
    moved = edits.set_point(
        document, document.control_points.shape[0] - 1, document.control_points.shape[1] - 1, (1, 2, 3)
    )
    i, j = (2 if letter in along else -1 for letter in "vu")
    assert moved.control_points[i, j].tolist() == [1, 2, 3]


def test_nothing_that_is_handed_out_of_a_net_can_be_written_to():
    document = random_net_document(1, (2, 3))
    network = Evaluation(document).network
    arrays = [*document.intervals, network.rows, network.columns, document.joints.smooth(Direction.ROWS)]
    assert not any(array.flags.writeable for array in arrays)


def test_samples_are_shared_out_over_the_windows():
    document = random_net_document(3, (2, 3), samples=(12, 6))
    evaluation = Evaluation(document)
    assert spread(12, 3).tolist() == [4, 4, 3]
    assert evaluation.u.tolist()[:6] == [0, 0.25, 0.5, 0.75, 1, 1.25]
    assert (evaluation.u[-1], len(evaluation.v)) == (3, 6)
    for a, b in windows_of(document):
        alone = Evaluation(extract_window(document, (a, b)))
        start_u, start_v = int(sum(spread(12, 3)[:b])), int(sum(spread(6, 2)[:a]))
        n, m = alone.document.samples
        last_u, last_v = (0 if last else 1 for last in (b == 2, a == 1))
        part = evaluation.raw[start_u : start_u + n - last_u, start_v : start_v + m - last_v]
        assert part == pytest.approx(alone.raw[: n - last_u, : m - last_v], abs=1e-13)
    assert evaluation.raw_box == pytest.approx(
        np.stack([evaluation.raw.min(axis=(0, 1)), evaluation.raw.max(axis=(0, 1))], axis=1), abs=1e-13
    )


@EVERY
@given(st.integers(0, 10_000))
def test_the_box_of_samples_is_that_of_all(formulation, seed):
    rng = np.random.default_rng(seed)
    windows = tuple(rng.integers(1, 6, 2).tolist())
    samples = tuple((np.array(windows)[::-1] + rng.integers(1, 90, 2)).tolist())
    evaluation = Evaluation(random_net_document(seed, windows, formulation=formulation, samples=samples, smooth=0.5))
    full = np.stack([evaluation.raw.min(axis=(0, 1)), evaluation.raw.max(axis=(0, 1))], axis=1)
    slack = 8 * np.finfo(float).eps * np.abs(evaluation.patch.coefficients).max(axis=(0, 1, 2, 3))
    if formulation is Formulation.INTERPOLATING:  # where windows jump, the sample on a joint is that which begins
        assert (np.abs(full - evaluation.raw_box) <= slack[:, None]).all()


@EVERY
def test_an_edit_computes_the_windows_it_touches_and_no_other(formulation):
    document = random_net_document(6, (4, 5), formulation=formulation)
    before = Evaluation(document)
    changes = [
        edits.set_point(document, 4, 6, (1.0, 2.0, 3.0)),
        edits.set_values(document, {KnotPlace(Direction.ROWS, 3, "s", 2): 0.31}),
        edits.set_values(document, {KnotPlace(Direction.COLUMNS, 0, "u", 1): 0.44}),
        edits.set_formulation(document, Formulation.DOUBLE_SUM),
        edits.set_points(document, document.control_points + 1),
    ]
    for changed in changes:
        light, whole = Evaluation(changed, before), Evaluation(changed)
        assert np.array_equal(light.patch.coefficients, whole.patch.coefficients)
        assert light.degree == whole.degree
        assert np.array_equal(light.raw, whole.raw)


def test_knots_at_a_smooth_joint_stay_alike():
    document = random_net_document(8, (2, 3))
    for name, window, shared in (("t", 0, [("t", 0), ("r", 1)]), ("r", 2, [("r", 2), ("t", 1)]), ("u", 1, [("u", 1)])):
        changed = edits.set_values(document, {KnotPlace(Direction.ROWS, 3, name, window): 0.37})
        for each, at in shared:
            assert {edits.value_at(changed, KnotPlace(Direction.ROWS, k, each, at)) for k in range(7)} == {0.37}
    free = edits.set_values(document, {KnotPlace(Direction.ROWS, 3, "s", 1): 0.37})
    assert (free.row_knots.array != document.row_knots.array).sum() == 1
    sharp = replace(document, joints=Joints((Joint.SHARP, Joint.SHARP), document.joints.v))
    lone = edits.set_values(sharp, {KnotPlace(Direction.ROWS, 3, "t", 0): 0.37})
    assert (lone.row_knots.array != sharp.row_knots.array).sum() == 1


def test_the_closest_point_is_found_in_every_window():
    document = random_net_document(9, (3, 4), flatness=0.2)
    patch = build_patch(document)
    u, v = (np.linspace(*ends, 23)[1:-1] for ends in patch.domain)
    points = patch.points(u, v)
    normals = patch.normals(u, v)
    found = closest_points(patch, (points + 1e-3 * normals).reshape(-1, 3))
    assert found.distance.max() <= 1.0000001e-3
    assert patch.derivative_at(found.u, found.v, 0, 0) == pytest.approx(found.points, abs=1e-9)


NET = np.stack([*np.meshgrid(np.arange(9.0), np.arange(7.0)), np.zeros((7, 9))], axis=-1)


@pytest.mark.parametrize(
    ("changes", "text"),
    [
        ({"control_points": NET[:, :8]}, "control_points[0] is a list of 8 entries; expected a list of 5, 7, 9"),
        ({"control_points": np.zeros((5, 205, 3))}, "control_points[0] is a list of 205 entries; expected"),
        ({"row_knots": np.full((7, 2, 4), 0.5)}, "row_knots is an array of 7 x 2 x 4; expected one of 7 x 3 x 4"),
        ({"samples": (101, 2)}, "samples[1] is 2; expected at least 3, for the net has 2 windows there"),
        ({"joints": Joints(("smooth",), ("sharp",))}, "joints.u is a list of 1 entries; expected a list of 2 entries"),
        ({"joints": Joints(("smooth", "round"), ("sharp",))}, "joints.u[1] is 'round'; expected one of smooth, sharp"),
        ({"closed": ["w"]}, "closed[0] is 'w'; expected one of u, v"),
        ({"closed": ["u"]}, "control_points is another column 6; expected that of column 0"),
    ],
)
def test_what_is_no_net_is_refused_at_its_place(changes, text):
    with pytest.raises(DocumentError) as refused:
        Document(**{"control_points": NET, "formulation": "interpolating", **changes})
    assert str(refused.value).startswith(text)


def test_a_smooth_joint_whose_knots_are_not_is_refused():
    knots = np.full((7, 3, 4), 0.5)
    knots[4, 1, 0] = np.nextafter(0.5, 1)
    sharp = Document(NET, knots)
    assert sharp.joints.u == (Joint.SHARP, Joint.SMOOTH)
    with pytest.raises(DocumentError, match=r"joints.u\[0\] is smooth; expected sharp, or one value on all rows for t"):
        replace(sharp, joints=Joints((Joint.SMOOTH,) * 2, sharp.joints.v))
    wild = knots.copy()
    wild[2, 1, 3] = 1.0
    with pytest.raises(DocumentError, match=r"row_knots\[2\]\[1\].t is 1.0; expected a number strictly between"):
        Document(NET, wild)
