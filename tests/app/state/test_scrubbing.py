"""Numbers that are dragged sideways, without a window."""

import pytest

from qovr_app.state import field_intents, intents
from qovr_app.state.looking_intents import ToolChosen
from qovr_app.state.scrubbing import Scrub
from qovr_core.edits import CoordinatePlace, value_at
from qovr_core.geometry.knots import Direction, KnotPlace
from support.states import after, opened

HEIGHTS = tuple(CoordinatePlace(2, j, 2) for j in range(5))


def any_number(_value):
    return True


def inside(value):
    return 0 < value < 1


@pytest.mark.parametrize(
    ("start", "pixels", "value"),
    [(0.5, 20, 0.6), (0.5, -20, 0.4), (0.7123, 1, 0.715), (-0.1, 20, 0.0), (0.0, 0, 0.0), (0.123, 0, 0.123)],
)
def test_a_number_is_rounded_to_what_a_pixel_means(start, pixels, value):
    assert Scrub(start, 0.005, 0.01, any_number).value(pixels) == value


def test_it_snaps_to_multiples_of_the_step_and_goes_a_tenth_of_the_way():
    scrub = Scrub(0.512, 0.005, 0.05, any_number)
    assert (scrub.value(5, snaps=True), scrub.value(0, snaps=True)) == (0.55, 0.5)
    fine = scrub.gone_on(10, 0.56, is_fine=True)
    assert fine.value(11) == 0.5605
    assert fine.value(9) == 0.5595


@pytest.mark.parametrize("pixels", [101, 5000, 1e6])
def test_it_stops_at_the_last_number_that_may_be(pixels):
    scrub = Scrub(0.5, 0.005, 0.01, inside)
    assert (scrub.value(pixels), scrub.value(-pixels)) == (0.995, 0.005)
    assert (scrub.value(pixels, snaps=True), scrub.value(-pixels, snaps=True)) == (0.99, 0.01)


def test_no_number_is_worse_than_the_one_where_it_began():
    assert Scrub(1e-7, 1e-3, 1e-3, inside).value(-40) == 1e-7


def test_a_row_changes_by_one_amount_as_one_step_and_comes_back():
    begun = after(opened(), intents.GestureBegun(7))
    state = after(begun, field_intents.ValuesShifted(HEIGHTS, 0.1, 7), field_intents.ValuesShifted(HEIGHTS, 0.25, 7))
    for place in HEIGHTS:
        assert value_at(state.document, place) == pytest.approx(value_at(begun.document, place) + 0.25, abs=1e-15)
    assert len(state.history.steps) == 1
    back = after(state, intents.GestureCancelled(7))
    assert back.document == begun.document
    assert not back.history.steps
    assert after(state, intents.GestureEnded(7), intents.Undone()).document == begun.document


def test_with_live_off_a_drag_is_pending_and_what_was_pending_comes_back():
    knot = KnotPlace(Direction.ROWS, 1, "t")
    state = after(opened(), intents.LiveSwitched(is_live=False), intents.ValuesEdited({HEIGHTS[0]: 3.0}))
    dragged = after(
        state,
        intents.GestureBegun(8),
        field_intents.ValuesShifted((*HEIGHTS, knot), 0.125, 8),
    )
    assert dragged.document == state.document
    assert value_at(dragged.draft, HEIGHTS[0]) == 3.125
    assert value_at(dragged.draft, knot) == 0.625
    assert after(dragged, intents.GestureCancelled(8)).draft == state.draft


def test_knots_of_a_line_keep_their_differences_and_take_linked_curves_along():
    places = tuple(KnotPlace(Direction.ROWS, 3, name) for name in "rt")
    alone = after(opened(), *(intents.ValuesPasted({places[0]: 0.3}),))
    state = after(alone, field_intents.ValuesShifted(places, 0.05))
    for curve in range(5):
        assert value_at(state.document, KnotPlace(Direction.ROWS, curve, "r")) == 0.35
        assert value_at(state.document, KnotPlace(Direction.ROWS, curve, "t")) == 0.55


def test_a_mirrored_column_goes_the_other_way():
    column = tuple(CoordinatePlace(i, 0, 0) for i in range(5))
    state = after(opened(), ToolChosen("symmetry_columns", value=True))
    moved = after(state, field_intents.ValuesShifted(column, -0.5))
    change = moved.document.control_points - state.document.control_points
    assert change[:, 0, 0].tolist() == [-0.5] * 5
    assert change[:, 4, 0].tolist() == [0.5] * 5
    assert not change[:, 1:4].any()


def test_samples_that_are_dragged_are_one_step():
    state = after(opened(), *(intents.SamplesChosen((n, 50), 9) for n in (51, 52, 60)))
    assert state.document.samples == (60, 50)
    assert len(state.history.steps) == 1
