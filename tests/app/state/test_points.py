"""Selecting and moving several control points, as lists of intents."""

import numpy as np
import pytest

from qovr_app.state import intents, looking_intents
from qovr_app.state.display import DisplaySettings
from qovr_app.state.editor_state import DocumentFile, EditorState, first_state
from qovr_app.state.looking_intents import Picking
from qovr_app.state.next_state import next_state
from qovr_core import QovrError
from qovr_core.edits import CoordinatePlace
from qovr_core.presets import preset


@pytest.fixture
def start() -> EditorState:
    """The editor with Figure 5."""
    state = first_state(preset("fig5").document, DocumentFile("fig5"), DisplaySettings())
    return next_state(state, intents.Configured())


def after(state: EditorState, *asked: intents.Intent) -> EditorState:
    for intent in asked:
        state = next_state(state, intent)
    return state


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
        (((1, 1), (2, 2)), ((0, 0, 1),), "1 x 3"),
        (((1, 1),), ((0, 0, float("nan")),), r"control_points\[1\]\[1\]\[2\]"),
    ],
)
def test_a_move_that_cannot_be_is_refused(start, indices, displacements, said):
    with pytest.raises(QovrError, match=said):
        after(start, intents.PointsMoved(indices, displacements, 1))
