"""What is asked of a net's structure: one step each, with what is selected and in focus following its points."""

import random
from dataclasses import replace

import numpy as np
import pytest

from qovr_app.state import intents, net_intents
from qovr_app.state.display import DisplaySettings
from qovr_app.state.editor_state import DocumentFile, first_state
from qovr_app.state.looking_intents import Picking, PointsPutAway, Selected, WindowFocused
from qovr_core import QovrError
from qovr_core.edits import CoordinatePlace, knots_of
from qovr_core.geometry.knots import Direction
from qovr_core.geometry.nodes import Spacing
from qovr_core.joints import Joint
from qovr_core.shapes import SHAPES
from support.nets import closed_net, random_net_document
from support.states import after

ROWS, COLUMNS = Direction


def opened(document):
    return after(first_state(document, DocumentFile("net"), DisplaySettings()), intents.Configured())


def net(windows=(2, 3), **more):
    return opened(random_net_document(1, windows, **more))


def picked(state):
    """Return what is selected, hidden and in focus, as places in space."""
    places = state.document.control_points
    return [
        sorted(tuple(places[index]) for index in indices)
        for indices in (state.selection.points, [state.selection.last], state.put_away)
    ]


EDITS = {
    "insert u": net_intents.WindowInserted(ROWS, 0),
    "insert v": net_intents.WindowInserted(COLUMNS, 0),
    "append u": net_intents.WindowAppended(ROWS),
    "append v": net_intents.WindowAppended(COLUMNS),
    "prepend u": net_intents.WindowAppended(ROWS, at_start=True),
    "prepend v": net_intents.WindowAppended(COLUMNS, at_start=True),
    "reverse u": net_intents.NetReversed(ROWS),
    "reverse v": net_intents.NetReversed(COLUMNS),
    "transpose": net_intents.NetTransposed(),
}


@pytest.mark.parametrize("intent", EDITS.values(), ids=EDITS)
def test_the_selection_follows_its_points_and_the_focus_its_window(intent):
    state = net()
    state = after(state, Selected((3, 5), ((0, 0), (6, 8))), PointsPutAway(((2, 2),)), WindowFocused((1, 2)))
    done = after(state, intent)
    assert picked(done) == picked(state)
    a, b = done.window
    middle = done.document.control_points[2 * a + 2, 2 * b + 2]
    assert np.array_equal(middle, state.document.control_points[4, 6])
    assert done.history.index == 1
    assert not done.is_stale
    back = after(done, intents.Undone())
    assert back.document == state.document
    assert (back.selection, back.put_away, back.window) == (state.selection, state.put_away, state.window)
    again = after(back, intents.Redone())
    assert again.document == done.document
    assert (again.selection, again.put_away, again.window) == (done.selection, done.put_away, done.window)


def test_what_is_removed_is_no_longer_selected():
    state = after(net(), Selected((0, 4), ((0, 5), (0, 6), (0, 7))))
    done = after(state, net_intents.WindowRemoved(ROWS, 1))
    assert done.selection.points == {(0, 4), (0, 5)}
    assert picked(done)[0] == sorted(tuple(state.document.control_points[0, j]) for j in (5, 7))


@pytest.mark.parametrize(("focus", "expected"), [(0, 0), (1, 1), (2, 1), (3, 2)])
def test_the_focus_stays_in_what_windows_are_joined_to(focus, expected):
    state = after(net((1, 4)), WindowFocused((0, focus)), net_intents.WindowRemoved(ROWS, 1))
    assert state.window == (0, expected)


@pytest.mark.parametrize(("focus", "expected"), [(0, 0), (1, 1), (2, 2), (3, 0)])
def test_at_the_seam_the_last_window_joins_the_first(focus, expected):
    state = opened(closed_net(1, (2, 4), ("u",)))
    state = after(state, WindowFocused((1, focus)), net_intents.WindowRemoved(ROWS, 3))
    assert state.window == (1, expected)


def test_an_extracted_window_is_the_net():
    state = after(net(), Selected((3, 5), ((0, 0),)), net_intents.WindowExtracted((1, 2)))
    assert (state.document.windows, state.window) == ((1, 1), (0, 0))
    assert state.selection.points == {(1, 1)}
    back = after(state, intents.Undone())
    assert (back.document.windows, back.window) == ((2, 3), (1, 2))
    assert back.selection.points == {(3, 5)}


def test_the_history_is_gone_through_in_one_go_as_step_by_step():
    state = after(net(), Selected((3, 5)), WindowFocused((1, 2)))
    edits = EDITS["prepend u"], EDITS["transpose"], EDITS["prepend v"], EDITS["reverse u"], EDITS["insert u"]
    done = after(state, *edits)
    assert picked(done)[0] == picked(state)[0]
    back = after(done, intents.WentTo(0))
    assert (back.document, back.selection, back.window) == (state.document, state.selection, state.window)
    there = after(back, intents.WentTo(len(edits)))
    assert (there.document, there.selection, there.window) == (done.document, done.selection, done.window)


def test_messages_say_how_far_the_surface_moves():
    state = net(smooth=0.0)
    smooth = after(state, net_intents.JointSmoothed(ROWS, 1))
    assert smooth.message.text.startswith("The surface moves by at most ")
    assert smooth.message.text.endswith(" % of the net's size.")
    assert smooth.history.undo_text == "Make joint 1 along u smooth"
    assert after(smooth, net_intents.JointSharpened(ROWS, 1)).message.text.endswith("nothing moves yet.")
    assert after(smooth, net_intents.WindowAppended(ROWS)).message.text == "No point of the surface moves."
    flat = opened(SHAPES["flat"].document())
    assert after(flat, net_intents.WindowInserted(ROWS, 0)).message.text == "No point of the surface moves."
    fine = after(net((1, 1), samples=(4000, 5)), net_intents.WindowAppended(ROWS))
    assert fine.message.text.endswith("It has 4096 samples along u, the most there may be.")


def test_a_gesture_counts_from_the_net_with_which_it_began_and_can_be_cancelled():
    state = after(net(), intents.GestureBegun(7))
    twice = after(state, net_intents.JointCreased(ROWS, 0, 0.4, 7), net_intents.JointCreased(ROWS, 0, 0.1, 7))
    assert twice.history.index == 1
    assert twice.document == after(state, net_intents.JointCreased(ROWS, 0, 0.1)).document
    assert after(twice, intents.GestureCancelled(7)).document == state.document
    finer = after(state, net_intents.NetResampled((4, 4), gesture=7), net_intents.NetResampled((3, 5), gesture=7))
    assert (finer.history.index, finer.document.windows) == (1, (3, 5))
    back = after(finer, intents.GestureCancelled(7))
    assert back.document == state.document
    assert back.history.index == 0


def test_a_net_resampled_to_its_own_windows_and_nodes_is_itself():
    state = net(smooth=1.0)
    for direction in Direction:
        state = after(state, net_intents.KnotsSpaced(direction, Spacing.CHORD_LENGTH))
    again = after(state, net_intents.NetResampled((2, 3), is_even=False))
    inner = (slice(1, -1), slice(1, -1))
    size = state.document.net_size
    np.testing.assert_allclose(
        again.document.control_points[inner], state.document.control_points[inner], atol=1e-12 * size
    )
    for direction in Direction:
        now, was = (knots_of(each.document, direction).array for each in (again, state))
        np.testing.assert_allclose(now[:, :, 2], was[:, :, 2], rtol=1e-12)
    even = after(state, net_intents.NetResampled((2, 3)))
    assert (even.document.row_knots.array == 0.5).all()


def test_formulations_whose_windows_do_not_meet_are_refused_with_the_way_out():
    state = net(formulation="published")
    for intent in (
        net_intents.WindowInserted(ROWS, 0),
        net_intents.WindowAppended(ROWS),
        net_intents.JointSmoothed(ROWS, 0),
        net_intents.NetResampled((2, 2)),
    ):
        with pytest.raises(QovrError, match="choose interpolating first"):
            after(state, intent)
    assert after(state, net_intents.WindowRemoved(ROWS, 0)).document.windows == (2, 2)


@pytest.mark.parametrize(
    "intent", [*EDITS.values(), net_intents.WindowExtracted((0, 0)), net_intents.NetResampled((1, 1))]
)
def test_no_number_that_waits_comes_to_stand_elsewhere(intent):
    state = after(net(), intents.LiveSwitched(False), intents.ValuesEdited({CoordinatePlace(0, 1, 2): 5.0}))
    with pytest.raises(QovrError, match="Numbers are typed that are not set; set them"):
        after(state, intent)
    done = after(state, intents.PendingSet(), intent)
    assert done.history.index == 2
    assert not done.has_pending


def some(rng, state):
    """Return a random intent; many of them are to be refused."""
    direction, k = rng.choice(list(Direction)), rng.randrange(4)
    rows, columns, _ = state.document.control_points.shape
    return rng.choice(
        [
            net_intents.WindowInserted(direction, k),
            net_intents.WindowRemoved(direction, k),
            net_intents.WindowRemoved(direction, k),
            net_intents.WindowAppended(direction, rng.random() < 0.5),
            net_intents.WindowExtracted((rng.randrange(2), rng.randrange(2))),
            net_intents.JointSmoothed(direction, k),
            net_intents.JointSharpened(direction, k),
            net_intents.JointCreased(direction, k, rng.uniform(0, 0.5)),
            net_intents.KnotsSpaced(direction, rng.choice(list(Spacing))),
            net_intents.NetReversed(direction),
            net_intents.NetTransposed(),
            net_intents.NetMirrored(rng.randrange(3)),
            net_intents.NetResampled((rng.randrange(4), rng.randrange(4)), rng.random() < 0.5),
            Selected((rng.randrange(rows), rng.randrange(columns)), (), rng.choice(list(Picking))),
            WindowFocused((rng.randrange(3), rng.randrange(3))),
            intents.Undone(),
            intents.Redone(),
        ]
    )


@pytest.mark.parametrize("closed", [(), ("u",), ("u", "v")])
def test_whatever_is_asked_in_whatever_order_the_state_holds_together(closed):
    rng = random.Random(len(closed))
    start = opened(closed_net(3, (2, 3), closed) if closed else random_net_document(3, (1, 2)))
    state = start
    for _ in range(250):
        try:
            state = after(state, some(rng, state))
        except QovrError:
            continue
        (m, n), (a, b) = state.document.windows, state.window
        assert 0 <= a < m
        assert 0 <= b < n
        for i, j in state.selection.points:
            assert i <= 2 * m + 2
            assert j <= 2 * n + 2
        assert state.selection.last is None or state.selection.last in state.selection.points
        assert not state.is_stale
    while state.history.index:
        state = after(state, intents.Undone())
    assert state.document == start.document


def test_joints_after_a_crease_are_sharp():
    state = after(net(), net_intents.JointCreased(COLUMNS, 0, 0.3))
    assert state.document.joints.v == (Joint.SHARP,)
    assert replace(state.document.joints, v=()) == replace(net().document.joints, v=())


@pytest.mark.parametrize(
    "step",
    [
        intents.Undone(),
        net_intents.NetTransposed(),
        net_intents.NetMirrored(2),
        net_intents.WindowExtracted((0, 0)),
        intents.PointsMoved(((1, 1),), ((0.0, 0.0, 0.5),), gesture=9),
    ],
    ids=lambda step: type(step).__name__,
)
def test_what_is_said_of_a_step_is_over_with_the_next(step):
    smooth = after(net(smooth=0.0), net_intents.JointSmoothed(ROWS, 1))
    done = after(smooth, step)
    assert done.message is None or "moves by at most" not in done.message.text


def test_one_window_can_be_compared_under_every_formulation():
    state = after(opened(SHAPES["dome"].document()), intents.FormulationChosen("published"))
    spaced = after(state, net_intents.KnotsSpaced(ROWS, Spacing.CHORD_LENGTH))
    assert spaced.message.text.startswith("The surface moves by at most ")
