"""Knots set by hand, as lists of intents: what goes with them, what a gesture gives back, where edits wait."""

import pytest

from qovr_app.state.intents import GestureBegun, GestureCancelled, GestureEnded, LiveSwitched, Undone
from qovr_app.state.knot_intents import KnotsSet, LinkSwitched
from qovr_app.state.looking_intents import ToolChosen
from qovr_core import QovrError
from qovr_core.edits import Direction, knots_of
from support.states import after

UNLINKED = LinkSwitched("curves", False)


def u_of(curve, value, gesture=0, **how):
    return KnotsSet(Direction.ROWS, curve, 0, "u", value, gesture, **how)


def knots_in(state, direction=Direction.ROWS):
    return [tuple(knots) for knots in knots_of(state.document, direction).in_window(0)]


def test_s_goes_with_u_while_the_two_are_one(start):
    state = after(start, u_of(2, 0.4, takes_s=True))
    assert knots_in(state) == [(0.5, 0.4, 0.4, 0.5)] * 5
    assert state.history.undo_text == "Set u_ip of C_0..C_4"
    state = after(start, u_of(2, 0.4), u_of(2, 0.3, takes_s=True))
    assert knots_in(state) == [(0.5, 0.5, 0.3, 0.5)] * 5


def test_among_linked_curves_each_decides_for_itself(start):
    state = after(start, UNLINKED, KnotsSet(Direction.ROWS, 1, 0, "s", 0.45), LinkSwitched("curves", True))
    state = after(state, u_of(3, 0.6, takes_s=True))
    assert knots_in(state) == [(0.5, 0.45 if curve == 1 else 0.6, 0.6, 0.5) for curve in range(5)]


def test_letting_s_go_and_taking_it_again_counts_from_where_the_gesture_began(start):
    state = after(start, GestureBegun(3), u_of(4, 0.6, 3, takes_s=True), u_of(4, 0.62, 3))
    assert knots_in(state)[4] == (0.5, 0.5, 0.62, 0.5)
    state = after(state, u_of(4, 0.64, 3, takes_s=True))
    assert knots_in(state)[4] == (0.5, 0.64, 0.64, 0.5)
    assert after(state, GestureCancelled(3)).document == start.document
    state = after(state, GestureEnded(3))
    assert after(state, Undone()).document == start.document


def test_on_all_curves_whatever_is_linked(start):
    state = after(start, UNLINKED, KnotsSet(Direction.COLUMNS, None, 0, "t", 0.7))
    assert knots_in(state, Direction.COLUMNS) == [(0.5, 0.5, 0.5, 0.7)] * 5
    assert knots_in(state) == knots_in(start)


def test_in_the_view_the_document_is_set_even_where_edits_wait(start):
    waiting = after(start, LiveSwitched(False))
    typed = after(waiting, u_of(2, 0.4))
    assert typed.document == start.document
    assert typed.has_pending
    pulled = after(typed, GestureBegun(5), KnotsSet(Direction.ROWS, 2, 0, "r", 0.3, 5, in_view=True), GestureEnded(5))
    assert knots_in(pulled) == [(0.3, 0.5, 0.5, 0.5)] * 5
    assert pulled.is_stale
    assert [tuple(knots) for knots in pulled.draft.row_knots.in_window(0)] == [(0.3, 0.5, 0.4, 0.5)] * 5


def test_symmetry_across_the_columns_reverses_the_knots(start):
    state = after(start, ToolChosen("symmetry_columns", True), KnotsSet(Direction.ROWS, 2, 0, "r", 0.3))
    assert knots_in(state) == [(0.3, 0.5, 0.5, 0.7)] * 5


@pytest.mark.parametrize(
    ("asked", "reason"),
    [
        (u_of(5, 0.4), "the curve is C_5; expected one of C_0 to C_4"),
        (KnotsSet(Direction.COLUMNS, 0, 1, "r", 0.4), "the window along K is 1; expected 0, the only one"),
        (u_of(0, 1.0), "strictly between 0 and 1"),
    ],
)
def test_what_is_not_there_is_refused(start, asked, reason):
    with pytest.raises(QovrError, match=reason):
        after(start, asked)
