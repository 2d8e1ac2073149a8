"""Joints made smooth, sharp and creases, and knots by the points' distances: judged by tangents on both sides."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from qovr_core import Document, Formulation, QovrError, build_patch
from qovr_core.edits import knots_of
from qovr_core.geometry.knots import Direction
from qovr_core.geometry.nodes import Spacing
from qovr_core.joints import Joint, can_be_smooth, window_lengths
from qovr_core.structure.joints import crease, make_sharp, make_smooth, space_knots
from qovr_core.structure.turning import transpose
from support.nets import R, S, T, U, closed_net, knots_of_nodes, node_net, nodes_of_knots, random_net_document

SEEDS = st.integers(0, 10_000)
DIRECTIONS = st.sampled_from(list(Direction))
CLOSED = st.sampled_from([(), ("u",), ("v",), ("u", "v")])
FEW = settings(max_examples=40)
V = np.linspace(0, 1, 17)


def net_of(seed, closed, smooth=0.5):
    return closed_net(seed, (3, 4), closed) if closed else random_net_document(seed, (3, 4), smooth=smooth)


def tangents(document, direction, joint):
    """Return S_u on both sides of a joint, by each window's own parameter, over all windows beside each other."""
    rows = document if direction is Direction.ROWS else transpose(document)
    patch, after = build_patch(rows), (joint + 1) % rows.windows[1]
    return (
        np.stack([patch.window(a, window).derivative([place], V, 1, 0)[0] for a in range(rows.windows[0])])
        for window, place in ((joint, 1.0), (after, 0.0))
    )


def angles(document, direction, joint):
    before, after = (
        each / np.linalg.norm(each, axis=-1, keepdims=True) for each in tangents(document, direction, joint)
    )
    return np.degrees(np.arctan2(np.linalg.norm(np.cross(before, after), axis=-1), (before * after).sum(axis=-1)))


@FEW
@given(SEEDS, CLOSED, DIRECTIONS, st.integers(0, 3))
def test_a_joint_made_smooth_is(seed, closed, direction, joint):
    document = net_of(seed, closed)
    joint %= len(document.joints.along(direction))
    after = make_smooth(document, direction, joint).document
    assert after.joints.along(direction)[joint] is Joint.SMOOTH
    knots = knots_of(after, direction).array
    u, tau, following = knots[0, :, U], knots[0, joint, T], (joint + 1) % knots.shape[1]
    ratio = u[following] * tau / ((1 - u[joint]) * (1 - tau))
    before, behind = tangents(after, direction, joint)
    assert np.abs(before - ratio * behind).max() <= 1e-12 * np.abs(before).max()
    others = [state for k, state in enumerate(after.joints.along(direction)) if k != joint]
    assert others == [state for k, state in enumerate(document.joints.along(direction)) if k != joint]


@FEW
@given(SEEDS, DIRECTIONS)
def test_smoothing_takes_means_and_keeps_what_another_smooth_joint_says(seed, direction):
    document = random_net_document(seed, (4, 4), smooth=0.0)
    document = make_smooth(document, direction, 0).document
    before = knots_of(document, direction).array
    change = make_smooth(document, direction, 1)
    after = knots_of(change.document, direction).array
    tau = np.concatenate([before[:, 1, T], before[:, 2, R]]).mean()
    assert (after[:, 1, T] == after[0, 1, T]).all()
    assert after[0, 1, T] == pytest.approx(tau, rel=1e-14)
    assert np.array_equal(after[:, 1, U], before[:, 1, U])
    assert after[0, 2, U] == pytest.approx(before[:, 2, U].mean(), rel=1e-14)
    changed = np.zeros_like(before, dtype=bool)
    changed[:, 1, T] = changed[:, 2, R] = changed[:, 2, U] = True
    assert np.array_equal(after[~changed], before[~changed])
    assert change.document.joints.along(direction)[:2] == (Joint.SMOOTH, Joint.SMOOTH)


def test_s_follows_u_where_a_curve_had_them_alike():
    document = random_net_document(3, (1, 2), smooth=0.0)
    knots = document.row_knots.array.copy()
    knots[2, :, S] = knots[2, :, U]
    after = make_smooth(replace(document, row_knots=knots), Direction.ROWS, 0).document.row_knots.array
    assert (after[2, :, S] == after[2, :, U]).all()
    assert np.array_equal(after[[0, 1, 3, 4]][..., S], knots[[0, 1, 3, 4]][..., S])


@FEW
@given(SEEDS, CLOSED, DIRECTIONS)
def test_only_the_two_windows_move_and_neither_the_joint_nor_their_far_sides(seed, closed, direction):
    document = net_of(seed, closed)
    change = make_smooth(document, direction, 1)
    was, now = (
        build_patch(each if direction is Direction.ROWS else transpose(each)).coefficients
        for each in (document, change.document)
    )
    moved = [k for k in range(was.shape[1]) if not np.array_equal(was[:, k], now[:, k])]
    assert set(moved) <= {1, 2}
    size = document.net_size
    for window in moved:
        for end in (0, -1):
            assert np.abs(was[:, window, end] - now[:, window, end]).max() < 1e-12 * size
    patches = [build_patch(each) for each in (document, change.document)]
    samples = [patch.samples(*(np.full(count, 24) for count in patch.windows[::-1])) for patch in patches]
    assert np.linalg.norm(samples[0] - samples[1], axis=-1).max() == pytest.approx(change.motion, rel=0.2, abs=1e-12)


@FEW
@given(SEEDS, CLOSED, DIRECTIONS)
def test_what_is_smooth_already_stays_to_the_last_bit(seed, closed, direction):
    document = make_smooth(net_of(seed, closed), direction, 0).document
    again = make_smooth(document, direction, 0)
    assert again.document == document
    assert again.motion == 0


@FEW
@given(SEEDS, CLOSED, DIRECTIONS)
def test_sharp_changes_no_number(seed, closed, direction):
    document = make_smooth(net_of(seed, closed), direction, 1).document
    sharp = make_sharp(document, direction, 1)
    assert sharp.joints.along(direction)[1] is Joint.SHARP
    assert replace(sharp, joints=document.joints) == document
    assert make_smooth(sharp, direction, 1).document == document


@FEW
@given(SEEDS, CLOSED, DIRECTIONS, st.floats(0, 0.45))
def test_a_crease_sets_t_and_r_of_all_curves_and_nothing_else(seed, closed, direction, strength):
    document = net_of(seed, closed)
    after = crease(document, direction, 1, strength).document
    expected = knots_of(document, direction).array.copy()
    expected[:, 1, T], expected[:, 2, R] = 0.5 - strength, 0.5 + strength
    assert np.allclose(knots_of(after, direction).array, expected, rtol=0, atol=1e-15)
    assert after.joints.along(direction)[1] is Joint.SHARP


@pytest.mark.parametrize(("strength", "t", "r"), [(0.2, 0.3, 0.7), (0.4, 0.1, 0.9), (0.45, 0.05, 0.95)])
def test_a_creases_knots_are_written_as_its_strength_is(strength, t, r):
    knots = crease(random_net_document(1, (1, 2)), Direction.ROWS, 0, strength).document.row_knots.array
    assert (knots[:, 0, T] == t).all()
    assert (knots[:, 1, R] == r).all()


@pytest.mark.parametrize(("strength", "degrees"), [(0, 0), (0.1, 42), (0.2, 69), (0.3, 83), (0.4, 89)])
@pytest.mark.parametrize("direction", Direction)
def test_a_right_angled_corner_kinks_as_its_crease_says(strength, degrees, direction):
    along = np.array([(-3, 0), (-2, 0), (-1, 0), (0, 0), (0, 1), (0, 2), (0, 3)], dtype=float)
    net = np.array([[(x, i, z) for x, z in along] for i in range(5)], dtype=float)
    document = Document(net, formulation="interpolating")
    document = document if direction is Direction.ROWS else transpose(document)
    after = crease(document, direction, 0, strength).document
    assert np.abs(angles(after, direction, 0) - degrees).max() < 0.5


@pytest.mark.parametrize("strength", [0.1, 0.45])
def test_evenly_spaced_points_do_not_fold_at_a_crease(strength):
    y, x = np.mgrid[:5.0, :7.0]
    document = Document(np.stack([x, y, 0 * x], axis=-1), formulation="interpolating")
    patch = build_patch(crease(document, Direction.ROWS, 0, strength).document)
    assert (patch.derivative(np.linspace(0, 2, 201), [0.5], 1, 0)[..., 0] > 0).all()


@pytest.mark.parametrize("formulation", [Formulation.PUBLISHED, Formulation.DOUBLE_SUM])
def test_windows_that_do_not_meet_are_not_smoothed(formulation):
    document = random_net_document(1, (1, 2), formulation=formulation)
    for edit in (
        lambda: make_smooth(document, Direction.ROWS, 0),
        lambda: crease(document, Direction.ROWS, 0, 0.2),
        lambda: space_knots(document, Direction.ROWS, Spacing.UNIFORM),
    ):
        with pytest.raises(QovrError, match=r"needs windows that meet.*choose interpolating first"):
            edit()
    with pytest.raises(QovrError, match=r"The crease is 0\.5; expected a number from 0 to 0\.45"):
        crease(random_net_document(1, (1, 2)), Direction.ROWS, 0, 0.5)
    assert make_sharp(document, Direction.ROWS, 0).joints.u == (Joint.SHARP,)


@FEW
@given(SEEDS, st.integers(1, 6))
def test_nodes_say_the_knots_and_knots_the_nodes(seed, windows):
    nodes = np.cumsum(np.random.default_rng(seed).uniform(0.1, 1, 2 * windows + 3))
    knots = knots_of_nodes(nodes)
    assert (knots[:-1, T] == knots[1:, R]).all()
    np.testing.assert_allclose(
        nodes_of_knots(knots), (nodes - nodes[1]) / (nodes[3] - nodes[1]), rtol=1e-12, atol=1e-13
    )
    document = node_net(seed, (1, windows))
    lengths = window_lengths(document.row_knots, document.joints.u)
    steps = np.diff(nodes_of_knots(document.row_knots.array[0])[1::2])
    np.testing.assert_allclose(lengths, steps / steps[0], rtol=1e-12)


@FEW
@given(SEEDS, CLOSED, DIRECTIONS, st.sampled_from(list(Spacing)))
def test_spaced_knots_are_shared_and_all_joints_smooth(seed, closed, direction, spacing):
    document = net_of(seed, closed)
    change = space_knots(document, direction, spacing)
    knots = knots_of(change.document, direction)
    assert can_be_smooth(knots, document.is_closed(direction)).all()
    assert set(change.document.joints.along(direction)) <= {Joint.SMOOTH}
    assert (knots.array == knots.array[:1]).all()
    assert (knots.array[..., S] == knots.array[..., U]).all()
    assert np.array_equal(change.document.control_points, document.control_points)
    if spacing is Spacing.UNIFORM:
        np.testing.assert_allclose(knots.array, 0.5, rtol=1e-14)


@pytest.mark.parametrize(("spacing", "power"), [(Spacing.CHORD_LENGTH, 1), (Spacing.CENTRIPETAL, 0.5)])
def test_spacing_is_a_power_of_the_distance(spacing, power):
    x = np.array([0, 1, 1.5, 4, 4.25, 6, 9])
    net = np.stack([*np.meshgrid(x, np.arange(5.0)), np.zeros((5, 7))], axis=-1)
    after = space_knots(Document(net, formulation="interpolating"), Direction.ROWS, spacing).document
    nodes = np.concatenate([[0], np.cumsum(np.diff(x) ** power)])
    np.testing.assert_allclose(after.row_knots.array[0], knots_of_nodes(nodes), rtol=1e-13)


def test_points_that_coincide_on_every_curve_have_no_chord_length():
    net = np.stack([*np.meshgrid([0.0, 1, 2, 2, 3], np.arange(5.0)), np.zeros((5, 5))], axis=-1)
    document = Document(net, formulation="interpolating")
    with pytest.raises(QovrError, match="The points 2 and 3 of every curve coincide"):
        space_knots(document, Direction.ROWS, Spacing.CHORD_LENGTH)
    assert space_knots(document, Direction.ROWS, Spacing.UNIFORM).document == document
