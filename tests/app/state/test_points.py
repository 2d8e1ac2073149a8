"""Selecting and moving several control points, as lists of intents."""

from pathlib import Path

import numpy as np
import pytest

from qovr_app.state import intents, looking_intents, point_intents
from qovr_app.state.editor_state import EditorState
from qovr_app.state.knot_intents import LinkSwitched
from qovr_app.state.looking_intents import Picking
from qovr_core import QovrError
from qovr_core.edits import CoordinatePlace, value_at
from qovr_core.geometry.knots import Direction, KnotPlace
from qovr_core.net_edits import Align, Flatten, Smooth, Transform
from qovr_core.symmetry import Source
from support.states import after


def moved(start: EditorState, state: EditorState):
    """Return by how much every point has moved, (5, 5, 3)."""
    return state.document.control_points - start.document.control_points


def test_points_are_added_toggled_and_replaced(start):
    pick, add, toggle = looking_intents.Selected, Picking.ADD, Picking.TOGGLE
    state = after(start, pick((1, 1)), pick((2, 3), picking=add), pick((4, 0), ((4, 1),), add))
    assert state.selection.points == {(1, 1), (2, 3), (4, 0), (4, 1)}
    assert state.selection.last == (4, 0)
    state = after(state, pick((4, 0), picking=toggle))
    assert state.selection.points == {(1, 1), (2, 3), (4, 1)}
    assert state.selection.last in state.selection.points
    assert state.message.text == "3 points are selected."
    assert after(state, pick(None, picking=add)).selection == state.selection
    assert after(state, pick((0, 0))).selection.points == {(0, 0)}
    emptied = after(start, pick((1, 1)), pick((1, 1), picking=toggle))
    assert emptied.selection.points == set()
    assert emptied.selection.last is None


def test_a_gesture_moves_from_where_it_began_and_lets_go_of_what_it_no_longer_moves(start):
    first = intents.PointsMoved(((1, 1), (3, 3)), ((0, 0, 0.1), (0, 0, 0.2)), 5)
    second = intents.PointsMoved(((1, 1),), ((0.5, 0, 0.3),), 5)
    state = after(start, first, second, intents.GestureEnded(5))
    assert state.history.index == 1
    expected = np.zeros((5, 5, 3))
    expected[1, 1] = 0.5, 0, 0.3
    np.testing.assert_allclose(moved(start, state), expected, atol=1e-15)
    assert after(state, intents.Undone()).document == start.document
    assert after(start, first, intents.GestureCancelled(5)).history.steps == start.history.steps


def test_without_a_gesture_every_move_is_a_step_from_where_the_points_are(start):
    once = intents.PointsMoved(((1, 1), (3, 3)), ((0, 0, 0.1), (0, 0, 0.2)))
    state = after(start, once, once)
    assert state.history.index == 2
    assert state.history.undo_text == "Move 2 points"
    assert moved(start, state)[3, 3, 2] == pytest.approx(0.4)


def test_what_is_pending_over_a_moved_point_stays_pending(start):
    x, z = CoordinatePlace(2, 2, 0), CoordinatePlace(2, 2, 2)
    state = after(start, intents.LiveSwitched(False), intents.ValuesEdited({z: 0.9}))
    state = after(state, intents.PointsMoved(((2, 2),), ((0.25, 0, 0.1),), 4), intents.GestureEnded(4))
    assert state.document.control_points[2, 2].tolist() == [2.25, 2, 0.6]
    assert state.draft.control_points[2, 2].tolist() == [2.25, 2, 0.9]
    assert state.is_pending(z)
    assert not state.is_pending(x)


@pytest.mark.parametrize(
    ("indices", "displacements", "said"),
    [
        (((5, 0),), ((0, 0, 1),), "P 5,0"),
        (((-1, 0),), ((0, 0, 1),), "P -1,0"),
        (((1, 1), (2, 2)), ((0, 0, 1),), "one for each point"),
        (((1, 1),), ((0, 0, float("nan")),), r"control_points\[1\]\[1\]\[2\]"),
    ],
)
def test_a_move_that_cannot_be_is_refused(start, indices, displacements, said):
    with pytest.raises(QovrError, match=said):
        after(start, intents.PointsMoved(indices, displacements, 1))


def tools(**settings):
    return [looking_intents.ToolChosen(name, value) for name, value in settings.items()]


def test_what_is_dragged_is_mirrored_and_its_surroundings_follow_softly(start):
    drag = intents.PointsMoved(((1, 0),), ((0.25, 0, 1.0),), 3)
    state = after(start, *tools(symmetry_columns=True), drag)
    expected = np.zeros((5, 5, 3))
    expected[1, 0], expected[1, 4] = (0.25, 0, 1), (-0.25, 0, 1)
    np.testing.assert_allclose(moved(start, state), expected, atol=1e-15)
    state = after(state, *tools(symmetry_columns=False, soft=True, soft_radius=2.0), drag)
    assert moved(start, state)[1, 0, 2] == pytest.approx(1)
    np.testing.assert_allclose(moved(start, state)[[0, 1], [0, 1], 2], 0.5)
    assert moved(start, state)[1, 4].tolist() == [0, 0, 0]
    state = after(state, *tools(soft_radius=1.0), drag)
    assert np.count_nonzero(moved(start, state).any(axis=-1)) == 1
    assert state.history.index == 1


def test_symmetry_across_both_moves_four(start):
    state = after(
        start, *tools(symmetry_columns=True, symmetry_rows=True), intents.PointsMoved(((1, 0),), ((0.1, 0.2, 0.3),))
    )
    signs = {(1, 0): (1, 1), (1, 4): (-1, 1), (3, 0): (1, -1), (3, 4): (-1, -1)}
    for index, (x, y) in signs.items():
        np.testing.assert_allclose(moved(start, state)[index], [0.1 * x, 0.2 * y, 0.3], atol=1e-15)
    assert np.count_nonzero(moved(start, state)) == 12


def test_fields_edit_their_mirror_images_too(start):
    r, t = KnotPlace(Direction.ROWS, 1, "r"), KnotPlace(Direction.ROWS, 1, "t")
    state = after(start, LinkSwitched("curves", False), *tools(symmetry_columns=True))
    state = after(state, intents.ValuesEdited({r: 0.375}), intents.ValuesEdited({CoordinatePlace(1, 0, 2): 0.9}))
    assert value_at(state.document, t) == 0.625
    assert moved(start, state)[1, 4, 2] == pytest.approx(0.5)
    assert state.history.undo_text == "Move control points"
    with pytest.raises(QovrError, match="as symmetry has it"):
        after(state, intents.ValuesEdited({CoordinatePlace(1, 2, 0): 2.5}))
    waiting = after(state, intents.LiveSwitched(False), intents.ValuesEdited({CoordinatePlace(1, 0, 2): 1.9}))
    assert value_at(waiting.draft, CoordinatePlace(1, 4, 2)) == pytest.approx(1.9)


def test_nudges_within_a_second_are_one_step(start):
    def nudge(at, index=(2, 2)):
        return point_intents.PointsNudged((index,), (0.0, 0.0, 0.01), at)

    state = after(start, *map(nudge, (10.0, 10.9, 11.5)))
    assert state.history.index == 1
    assert moved(start, state)[2, 2, 2] == pytest.approx(0.03)
    assert after(state, nudge(12.6)).history.index == 2
    assert after(state, nudge(11.6, (1, 1))).history.index == 2
    assert after(state, nudge(3.0)).history.index == 2
    assert after(state, intents.Undone(), nudge(11.7)).history.index == 1
    saved = after(state, intents.Saved(Path("a.qovr"), "a", state.history.serial), nudge(11.7))
    assert saved.history.index == 2


@pytest.mark.parametrize(
    ("edit", "text"),
    [
        (Transform((0.0, 0.0, 0.1)), "Move 2 points"),
        (Transform(factors=(2.0, 2.0, 1.0)), "Scale 2 points"),
        (Transform(degrees=30.0), "Rotate 2 points"),
        (Transform((1.0, 0.0, 0.0), degrees=30.0), "Transform 2 points"),
        (Flatten(), "Flatten 2 points"),
        (Align(0), "Align 2 points"),
        (Smooth(), "Smooth 2 points"),
    ],
)
def test_an_edit_of_the_selection_is_one_step_that_sets_the_document(start, edit, text):
    intent = point_intents.PointsEdited(edit, ((1, 1), (3, 2)))
    state = after(start, intents.LiveSwitched(False), intent)
    assert state.history.undo_text == text
    assert {tuple(index) for index in np.argwhere(moved(start, state).any(axis=-1))} <= {(1, 1), (3, 2)}
    assert state.draft == state.document
    assert after(state, intents.Undone()).document == start.document


def test_making_symmetric_is_one_step(start):
    state = after(start, point_intents.MadeSymmetric(Direction.COLUMNS, Source.FIRST))
    assert state.document == start.document
    state = after(start, intents.PointsMoved(((1, 0),), ((0.1, 0.2, 0.3),)))
    state = after(state, point_intents.MadeSymmetric(Direction.COLUMNS, Source.FIRST))
    assert state.history.undo_text == "Make symmetric across columns"
    np.testing.assert_allclose(moved(start, state)[1, 4], [-0.1, 0.2, 0.3], atol=1e-15)


@pytest.mark.parametrize("index", [(5, 0), (0, -1)])
def test_a_point_that_is_none_is_not_selected(start, index):
    with pytest.raises(QovrError, match="a net of 5 x 5"):
        after(start, looking_intents.Selected((1, 1), (index,)))


@pytest.mark.parametrize("size", [0.0, -1.0, float("inf"), float("nan"), "2"])
def test_a_step_or_radius_that_is_none_is_refused(start, size):
    for setting in ("snap_step", "soft_radius"):
        with pytest.raises(QovrError, match="a number above 0"):
            after(start, *tools(**{setting: size}))
