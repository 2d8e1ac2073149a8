"""More windows and fewer: what is inserted, removed and appended, measured window by window."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from qovr_core import Document, Formulation, QovrError, build_patch
from qovr_core.edits import extract_window, knots_of
from qovr_core.geometry.knots import Direction
from qovr_core.joints import Joint, can_be_smooth
from qovr_core.structure.turning import transpose
from qovr_core.structure.windows import append_window, insert_pair, remove_pair
from support.nets import R, S, T, U, closed_net, node_net, random_net_document

SEEDS = st.integers(0, 10_000)
DIRECTIONS = st.sampled_from(list(Direction))
CLOSED = st.sampled_from([(), ("u",), ("v",), ("u", "v")])
FEW = settings(max_examples=40)
PLACES = np.linspace(0, 1, 13)


def net_of(seed, closed, smooth=0.5):
    return closed_net(seed, (3, 4), closed) if closed else random_net_document(seed, (3, 4), smooth=smooth)


def columns_first(document, direction):
    """Return the net with the lines first that the curves of a direction cross."""
    return document.control_points if direction is Direction.COLUMNS else document.control_points.swapaxes(0, 1)


def window_points(document, direction, window, places):
    """Return points of all windows beside each other, at places along the curves in one of them."""
    rows = document if direction is Direction.ROWS else transpose(document)
    patch = build_patch(rows)
    return np.stack([patch.window(a, window).points(places, PLACES) for a in range(rows.windows[0])])


@FEW
@given(SEEDS, CLOSED, DIRECTIONS, st.integers(0, 2))
def test_a_window_removed_where_it_was_inserted_is_the_document(seed, closed, direction, window):
    document = net_of(seed, closed)
    inserted = insert_pair(document, direction, window).document
    assert knots_of(inserted, direction).windows == knots_of(document, direction).windows + 1
    again = remove_pair(inserted, direction, window).document
    assert np.array_equal(again.control_points, document.control_points)
    assert knots_of(again, direction.other) == knots_of(document, direction.other)
    assert (again.joints, again.samples, again.closed) == (document.joints, document.samples, document.closed)
    expected = knots_of(document, direction).array.copy()
    expected[:, window, S] = expected[:, window, U]
    np.testing.assert_allclose(knots_of(again, direction).array, expected, rtol=1e-14)


@FEW
@given(SEEDS, CLOSED, DIRECTIONS, st.integers(0, 2))
def test_old_points_stay_and_new_ones_lie_on_the_curves(seed, closed, direction, window):
    document = net_of(seed, closed)
    change = insert_pair(document, direction, window)
    old, new = columns_first(document, direction), columns_first(change.document, direction)
    stays = change.origin >= 0
    assert np.array_equal(new[stays], old[change.origin[stays]])
    assert np.array_equal(old[change.origin[[2 * window + 3]]], old[[2 * window + 2]])
    u = knots_of(document, direction).array[1, window, U]  # the edge of the first windows is curve 1
    edge = window_points(document, direction, window, np.array([u / 2, (1 + u) / 2]))[0, :, 0]
    np.testing.assert_allclose(new[[2 * window + 2, 2 * window + 4], 1], edge, atol=1e-12)


@FEW
@given(SEEDS, DIRECTIONS)
def test_the_knots_of_a_split_window(seed, direction):
    document = random_net_document(seed, (3, 3), smooth=0.5)
    before = knots_of(document, direction).array
    change = insert_pair(document, direction, 1)
    after = knots_of(change.document, direction).array
    r, u, t = (before[:, 1, name] for name in (R, U, T))
    left, right = before[:, 0, T], before[:, 2, R]
    halves = {(1, R): 2 * r / (1 + r), (1, T): u, (2, R): u, (2, T): t / (2 - t)}
    beside = {(0, T): 2 * left / (1 + left), (3, R): right / (2 - right)}
    for (window, name), expected in (halves | beside).items():
        np.testing.assert_allclose(after[:, window, name], expected, rtol=1e-14)
    assert (after[:, 1:3, [S, U]] == 0.5).all()
    assert np.array_equal(after[:, 0, :T], before[:, 0, :T])
    assert np.array_equal(after[:, 3, S:], before[:, 2, S:])
    shares_u = bool((u == u[0]).all())
    old = document.joints.along(direction)
    new = Joint.SMOOTH if shares_u else Joint.SHARP
    assert change.document.joints.along(direction) == (old[0], new, old[1])


@FEW
@given(SEEDS, DIRECTIONS, CLOSED)
def test_windows_that_an_insertion_does_not_touch_stay_to_the_last_bit(seed, direction, closed):
    document = closed_net(seed, (5, 6), closed) if closed else random_net_document(seed, (5, 6))
    after = insert_pair(document, direction, 1).document
    for window in range(3, knots_of(document, direction).windows):
        is_beside = document.is_closed(direction) and window == knots_of(document, direction).windows - 1
        if not is_beside:
            assert np.array_equal(
                window_points(document, direction, window, PLACES), window_points(after, direction, window + 1, PLACES)
            )


@FEW
@given(SEEDS, DIRECTIONS, st.integers(0, 2))
def test_points_quadratic_in_their_nodes_keep_their_surface(seed, direction, window):
    document = node_net(seed, (3, 3))
    change = insert_pair(document, direction, window)
    size = document.net_size
    assert change.motion < 1e-12 * size
    u = float(knots_of(document, direction).array[0, window, U])
    for half, places in ((window, u * PLACES), (window + 1, u + (1 - u) * PLACES)):
        was = window_points(document, direction, window, places)
        assert np.abs(window_points(change.document, direction, half, PLACES) - was).max() < 1e-12 * size
    assert remove_pair(change.document, direction, window).motion < 1e-12 * size


def test_random_heights_move_by_less_than_a_percent_and_the_motion_is_said():
    for seed in range(8):
        rng = np.random.default_rng(seed)
        y, x = np.mgrid[:9.0, :9.0]
        document = Document(np.stack([x, y, rng.uniform(-1, 1, x.shape)], axis=-1), formulation="interpolating")
        change = insert_pair(document, Direction.ROWS, 1)
        largest = max(
            np.linalg.norm(
                window_points(document, Direction.ROWS, 1, places)
                - window_points(change.document, Direction.ROWS, half, PLACES),
                axis=-1,
            ).max()
            for half, places in ((1, PLACES / 2), (2, 0.5 + PLACES / 2))
        )
        assert largest <= 1.1 * change.motion
        assert change.motion < 0.01 * document.net_size


@FEW
@given(SEEDS, DIRECTIONS, st.booleans(), st.booleans())
def test_appending_moves_no_old_window(seed, direction, at_start, is_closed_across):
    closed = (direction.other.parameter,) if is_closed_across else ()
    document = net_of(seed, closed)
    change = append_window(document, direction, at_start=at_start)
    windows, old, new = (
        knots_of(document, direction).windows,
        *(columns_first(d, direction) for d in (document, change.document)),
    )
    shift, appended, last = (1, 0, 0) if at_start else (0, windows, windows - 1)
    assert change.motion == 0
    assert np.array_equal(new[2 * shift : 2 * shift + len(old)], old)
    assert change.origin.tolist() == ([-1, -1] if at_start else []) + list(range(len(old))) + (
        [] if at_start else [-1, -1]
    )
    for window in range(windows):
        assert np.array_equal(
            window_points(document, direction, window, PLACES),
            window_points(change.document, direction, window + shift, PLACES),
        )
    knots, was = knots_of(change.document, direction).array[:, appended], knots_of(document, direction).array[:, last]
    near, far = (T, R) if at_start else (R, T)
    assert np.array_equal(knots[:, near], was[:, far])
    for name, mirrored in ((S, S), (U, U), (far, near)):
        assert np.array_equal(knots[:, name], 1 - was[:, mirrored])
    pivot = old[1] if at_start else old[-2]
    for place, k in zip((-2, -1) if not at_start else (1, 0), (2, 3), strict=True):
        partner = 1 + k if at_start else len(old) - 2 - k
        assert np.array_equal(new[place], 2 * pivot - old[partner])
        across = (knots_of(d, direction.other).array for d in (change.document, document))
        assert np.array_equal(next(across)[place], next(across)[partner])


@FEW
@given(SEEDS, DIRECTIONS, st.booleans())
def test_an_appended_joint_is_smooth_where_the_knots_allow_it(seed, direction, at_start):
    for document, expected in (
        (random_net_document(seed, (1, 1)), Joint.SHARP),
        (node_net(seed, (2, 2)), Joint.SMOOTH),
    ):
        after = append_window(document, direction, at_start=at_start).document
        joints = after.joints.along(direction)
        assert joints[0 if at_start else -1] is expected
        if expected is Joint.SMOOTH:
            assert can_be_smooth(knots_of(after, direction), is_closed=False).all()


def test_samples_keep_their_intervals_a_window_up_to_the_most_there_may_be():
    document = random_net_document(1, (1, 1), samples=(101, 51))
    along = append_window(document, Direction.ROWS).document
    assert along.samples == (201, 51)
    assert append_window(along, Direction.COLUMNS).document.samples == (201, 101)
    assert insert_pair(along, Direction.ROWS, 0).document.samples == (301, 51)
    assert remove_pair(along, Direction.ROWS, 0).document.samples == (101, 51)
    fine = random_net_document(1, (1, 1), samples=(4096, 51))
    assert append_window(fine, Direction.ROWS).document.samples == (4096, 51)


def test_what_is_extracted_from_a_closed_net_is_one_window_of_it():
    document = closed_net(1, (3, 4), ("u", "v"))
    alone = extract_window(document, (2, 3))
    assert (alone.windows, alone.closed) == ((1, 1), ())
    assert np.array_equal(build_patch(alone).coefficients[0, 0], build_patch(document).coefficients[2, 3])


@pytest.mark.parametrize(
    ("edit", "text"),
    [
        (
            lambda: insert_pair(net_of(1, ()), Direction.ROWS, 4),
            "There is no window 4 along u; expected one from 0 to 3",
        ),
        (
            lambda: remove_pair(net_of(1, ()), Direction.COLUMNS, 2),
            "There is no joint 2 along v; expected one from 0 to 1",
        ),
        (
            lambda: remove_pair(random_net_document(1, (1, 2)), Direction.COLUMNS, 0),
            "The net has one window along v, so no joint; append a window first",
        ),
        (
            lambda: remove_pair(closed_net(1, (2, 3), ("v",)), Direction.COLUMNS, 1),
            "The net closes along v with two windows; insert one before removing one",
        ),
        (
            lambda: append_window(closed_net(1, (2, 3), ("u",)), Direction.ROWS),
            "The net closes along u, so it has no end to append to; insert a window instead",
        ),
        (
            lambda: append_window(random_net_document(1, (1, 1), formulation=Formulation.PUBLISHED), Direction.ROWS),
            "Appending needs windows that meet; those of the published formulation do not: choose interpolating first",
        ),
        (
            lambda: insert_pair(random_net_document(1, (1, 1), formulation=Formulation.DOUBLE_SUM), Direction.ROWS, 0),
            "Inserting needs windows that meet; those of the double-sum formulation do not: choose interpolating first",
        ),
        (
            lambda: insert_pair(random_net_document(1, (1, 100), samples=(120, 9)), Direction.ROWS, 0),
            "The net has 100 windows along u, the most there may be; remove one first",
        ),
    ],
)
def test_what_cannot_be_done_is_refused_with_the_way_out(edit, text):
    with pytest.raises(QovrError) as refused:
        edit()
    assert str(refused.value) == text


def test_windows_of_a_formulation_that_jumps_can_be_removed():
    document = random_net_document(1, (1, 3), formulation=Formulation.PUBLISHED)
    change = remove_pair(document, Direction.ROWS, 0)
    assert (change.document.windows, change.motion) == ((1, 2), None)
