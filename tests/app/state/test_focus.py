"""The window of the net in focus, without a window on the screen: it is always one that the document has."""

import numpy as np
import pytest

from qovr_app.state import intents, knot_intents, looking_intents, net_intents
from qovr_app.state.display import DisplaySettings
from qovr_app.state.editor_state import DocumentFile, first_state
from qovr_app.state.focus import beside, has_point, in_window, nearest_window
from qovr_app.state.looking_intents import FieldFocused, Picking, Selected, WindowFocused
from qovr_app.state.names import in_window_words
from qovr_core import DocumentError, Evaluation
from qovr_core.edits import CoordinatePlace, Direction, KnotPlace, Zone, extract_window, value_at
from qovr_core.presets import preset
from support.nets import closed_net, random_net_document
from support.states import after

NET = random_net_document(5, (2, 3), smooth=0.0)
"""7 x 9 points, whose joints are all sharp."""

R_OF_C1 = KnotPlace(Direction.ROWS, 1, "r")


def opened(document=NET):
    start = first_state(document, DocumentFile("net"), DisplaySettings())
    return after(start, intents.Configured())


def reloaded(document):
    return intents.Reloaded(document, None)


def test_a_window_shows_the_numbers_that_it_has_when_it_stands_alone():
    for a, b in np.ndindex(NET.windows):
        alone = extract_window(NET, (a, b))
        for direction in Direction:
            for curve in range(5):
                place = KnotPlace(direction, curve, "t")
                assert value_at(NET, in_window(place, (a, b))) == value_at(alone, place)
        point = CoordinatePlace(3, 1, 2)
        assert value_at(NET, in_window(point, (a, b))) == value_at(alone, point)


@pytest.mark.parametrize("window", [(2, 0), (0, 3), (-1, 0)])
def test_a_window_that_the_net_has_not_is_refused(window):
    with pytest.raises(DocumentError, match="one of 0,0 to 1,2"):
        after(opened(), WindowFocused(window))


def test_the_fields_stay_where_they_are_while_the_window_moves():
    state = after(opened(), FieldFocused(R_OF_C1), WindowFocused((1, 2)))
    assert state.window == (1, 2)
    assert state.knot == state.fields[Zone.ROW_KNOTS] == KnotPlace(Direction.ROWS, 3, "r", 2)
    back = after(state, WindowFocused((0, 0)))
    assert back.knot == R_OF_C1


@pytest.mark.parametrize(
    ("point", "window"), [((0, 0), (0, 0)), ((2, 4), (0, 1)), ((2, 2), (0, 1)), ((6, 8), (1, 2)), ((5, 1), (1, 0))]
)
def test_a_point_that_is_selected_brings_the_nearest_window_that_has_it(point, window):
    state = after(opened(), WindowFocused((0, 1)), Selected(point))
    assert state.window == window
    assert has_point(window, point)


def test_what_is_selected_in_the_window_leaves_it_where_it_is():
    state = after(opened(), WindowFocused((1, 1)))
    assert after(state, Selected((0, 0), ((4, 4),))).window == (1, 1)
    assert after(state, Selected(None)).window == (1, 1)
    added = after(state, Selected((4, 4)), Selected((0, 0), picking=Picking.ADD))
    assert added.window == (0, 0)
    taken = after(added, WindowFocused((1, 1)), Selected((0, 0), picking=Picking.TOGGLE))
    assert taken.window == (1, 1)


def test_the_neighbours_of_a_window_end_with_the_net_and_go_round_where_it_is_closed():
    state = after(opened(), WindowFocused((1, 2)))
    assert beside(state, (0, 1)) is beside(state, (1, 0)) is None
    assert beside(state, (0, -1)) == (1, 1)
    assert beside(state, (-1, 0)) == (0, 2)
    ring = after(opened(closed_net(3, (2, 3), ("u",))), WindowFocused((1, 2)))
    assert beside(ring, (0, 1)) == (1, 0)
    assert beside(ring, (1, 0)) is None


def test_a_field_of_another_window_brings_it():
    place = KnotPlace(Direction.COLUMNS, 7, "u", 1)
    assert after(opened(), FieldFocused(place)).window == (1, 2)
    assert nearest_window(NET, (0, 0), place) == (1, 2)


def test_a_smaller_net_keeps_the_nearest_window_and_what_it_has_of_the_selection():
    state = after(opened(), WindowFocused((1, 2)), FieldFocused(KnotPlace(Direction.ROWS, 6, "s", 2)))
    state = after(state, Selected((4, 4), ((6, 8),)), looking_intents.PointsPutAway(((0, 0), (6, 7))))
    small = after(state, reloaded(extract_window(NET, (0, 0))))
    assert small.window == (0, 0)
    assert small.knot == KnotPlace(Direction.ROWS, 4, "s", 0)
    assert small.selection.points == {(4, 4)}
    assert small.selection.last == (4, 4)
    assert small.put_away == {(0, 0)}
    assert small.evaluation.document is small.document
    back = after(small, intents.Undone())
    assert back.document == NET
    assert back.window == (0, 0)


@pytest.mark.parametrize("is_live", [True, False])
def test_undo_across_shapes_holds_together(is_live):
    state = after(opened(preset("fig5").document), intents.LiveSwitched(is_live), reloaded(NET))
    state = after(state, WindowFocused((1, 2)), intents.TextTyped(KnotPlace(Direction.ROWS, 6, "s", 2), "0.6"))
    state = after(state, looking_intents.Selected((6, 8)))
    undone = after(state, intents.Undone())
    assert undone.window == (0, 0)
    assert not undone.texts
    assert undone.selection.last is None
    assert undone.shown_document is not None
    redone = after(undone, intents.Redone(), intents.Configured())
    assert redone.document == NET
    assert redone.shown_document == NET


def test_pending_knots_do_not_stand_in_the_way_of_another_joint():
    waiting = after(opened(), intents.LiveSwitched(False), knot_intents.LinkSwitched("curves", False))
    t, z = KnotPlace(Direction.ROWS, 1, "t"), CoordinatePlace(0, 0, 2)
    pending = after(waiting, intents.ValuesEdited({t: 0.33}), intents.ValuesEdited({z: 0.44}))
    smooth = after(pending, net_intents.JointSmoothed(Direction.ROWS, 0))
    assert value_at(smooth.draft, t) == value_at(smooth.document, t)
    assert value_at(smooth.draft, z) == 0.44
    assert after(smooth, intents.Undone()).document == NET


def test_numbers_that_the_net_has_not_are_refused():
    for place in (KnotPlace(Direction.ROWS, 7, "t"), KnotPlace(Direction.COLUMNS, 0, "t", 2), CoordinatePlace(7, 0, 0)):
        for intent in (
            intents.ValuesEdited({place: 0.5}),
            intents.ValuesPasted({place: 0.5}),
            intents.TextTyped(place, "0.5"),
            FieldFocused(place),
        ):
            with pytest.raises(DocumentError, match="a net"):
                after(opened(), intent)


def test_another_document_begins_with_its_first_window():
    state = after(opened(), WindowFocused((1, 1)), intents.Opened(NET, "again"))
    assert state.window == (0, 0)


def test_a_knot_is_set_in_its_window_alone():
    state = after(opened(), knot_intents.LinkSwitched("curves", False))
    state = after(state, knot_intents.KnotsSet(Direction.ROWS, 4, 1, "s", 0.61))
    assert value_at(state.document, KnotPlace(Direction.ROWS, 4, "s", 1)) == 0.61
    assert (state.document.row_knots.array != NET.row_knots.array).sum() == 1
    every = after(state, knot_intents.KnotsSet(Direction.COLUMNS, None, 1, "u", 0.3))
    assert (every.document.column_knots.array[:, 1, 2] == 0.3).all()
    assert (every.document.column_knots.array[:, 0] == NET.column_knots.array[:, 0]).all()


def test_linked_windows_share_a_knot():
    state = after(opened(), knot_intents.LinkSwitched("curves", False), knot_intents.LinkSwitched("windows", True))
    state = after(state, knot_intents.KnotsSet(Direction.ROWS, 4, 1, "s", 0.61))
    assert (state.document.row_knots.array[4, :, 1] == 0.61).all()
    assert (state.document.row_knots.array != NET.row_knots.array).sum() == 3


def test_an_edit_gives_the_surface_that_a_whole_evaluation_gives():
    state = after(opened(), intents.PointsMoved(((0, 0), (4, 4)), ((0.1, 0, 0.2), (0, 0, 0.3))))
    assert (state.evaluation.patch.coefficients == Evaluation(state.document).patch.coefficients).all()


def test_a_knot_of_a_window_is_called_as_the_window_calls_it():
    assert in_window_words("column_knots[2][1].v is 1") == "v_ip of K_2 in window 1 along v is 1"
    assert in_window_words("row_knots[2].s is 1") == "s_ip of C_2 is 1"
