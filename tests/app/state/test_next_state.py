"""The editor's logic as lists of intents: no window, no Qt."""

from dataclasses import replace

import pytest

from qovr_app.state import intents, knot_intents, looking_intents
from qovr_app.state.display import ColourRange, LayerChoice, Placement
from qovr_app.state.editor_state import first_state
from qovr_app.store import Store
from qovr_core import Formulation, QovrError
from qovr_core.edits import CoordinatePlace, Direction, KnotPlace, Zone, value_at
from qovr_core.files.sources import read_source
from qovr_core.presets import preset
from support.states import after

S_OF_C2 = KnotPlace(Direction.ROWS, 2, "s")
Z_OF_P22 = CoordinatePlace(2, 2, 2)
UNLINKED = knot_intents.LinkSwitched("curves", False)
BOTH_DIRECTIONS = knot_intents.LinkSwitched("directions", True)


def dragged(z: float, gesture: int = 7) -> intents.PointsMoved:
    """Return what drags P 2,2 of Figure 5 to a height."""
    return intents.PointsMoved(((2, 2),), ((0.0, 0.0, z - 0.5),), gesture)


def test_a_step_changes_no_state_it_was_given(start):
    document, draft = start.document, start.draft
    after(start, intents.ValuesEdited({S_OF_C2: 0.6}), dragged(0.9))
    assert start.document is document
    assert start.draft is draft


def test_an_edit_is_set_and_the_surface_follows(start):
    state = after(start, intents.ValuesEdited({Z_OF_P22: 0.9}))
    assert value_at(state.document, Z_OF_P22) == 0.9
    assert not state.is_stale
    assert state.evaluation.document is state.document
    assert state.history.undo_text == "Move P 2,2"


@pytest.mark.parametrize(
    ("links", "reached"),
    [
        ([UNLINKED], {("row_knots", 2)}),
        ([], {("row_knots", k) for k in range(5)}),
        ([UNLINKED, BOTH_DIRECTIONS], {("row_knots", 2), ("column_knots", 2)}),
        ([BOTH_DIRECTIONS], {(d, k) for d in ("row_knots", "column_knots") for k in range(5)}),
    ],
)
def test_a_knot_is_edited_with_what_is_linked_to_it(start, links, reached):
    for edit in (intents.ValuesEdited({S_OF_C2: 0.6}), knot_intents.KnotsSet(Direction.ROWS, 2, 0, "s", 0.6)):
        state = after(start, *links, edit)
        changed = {
            (str(direction), k)
            for direction in Direction
            for k in range(5)
            if value_at(state.document, KnotPlace(direction, k, "s")) == 0.6
        }
        assert changed == reached


def test_a_refused_edit_changes_nothing(start):
    with pytest.raises(QovrError, match="strictly between 0 and 1"):
        after(start, intents.ValuesEdited({S_OF_C2: 2.0}))


def test_what_has_no_surface_is_refused_before_the_history(start):
    with pytest.raises(QovrError, match="no finite coordinates"):
        after(start, intents.ValuesEdited({S_OF_C2.__class__(Direction.ROWS, 4, "r"): 5e-324}))


def test_a_drag_is_one_step_and_is_cancelled_as_if_it_had_never_been(start):
    state = after(start, dragged(0.7), dragged(0.8), dragged(0.9))
    assert state.gesture.number == 7
    assert len(state.history.steps) == 1
    assert state.history.undo_text == "Move P 2,2"
    back = after(state, intents.GestureCancelled(7))
    assert back.document == start.document
    assert back.gesture is None
    assert not back.is_changed
    assert not back.is_stale


def test_a_cancelled_drag_gives_back_what_was_undone_and_what_was_pending(start):
    undone = after(start, intents.ValuesEdited({S_OF_C2: 0.6}), intents.Undone())
    back = after(undone, dragged(0.7), intents.GestureCancelled(7))
    assert back.history.redo_text == undone.history.redo_text is not None
    waiting = after(start, intents.LiveSwitched(False), intents.ValuesEdited({Z_OF_P22: 0.9}))
    back = after(waiting, dragged(0.7), dragged(0.8), intents.GestureCancelled(7))
    assert value_at(back.draft, Z_OF_P22) == 0.9
    assert back.is_pending(Z_OF_P22)


def test_the_end_of_a_drag_leaves_a_refusal(start):
    refused = after(start, dragged(0.7), looking_intents.MessageShown("No.", is_refusal=True), intents.GestureEnded(7))
    assert refused.message.text == "No."


def test_what_ends_a_drag_keeps_it(start):
    state = after(start, dragged(0.7), intents.GestureEnded(7))
    assert state.gesture is None
    assert after(state, intents.Undone()).document == start.document


def test_staged_edits_wait_in_the_draft(start):
    state = after(start, intents.LiveSwitched(False), intents.ValuesEdited({Z_OF_P22: 0.9}))
    assert value_at(state.document, Z_OF_P22) == 0.5
    assert value_at(state.draft, Z_OF_P22) == 0.9
    assert state.is_pending(Z_OF_P22)
    assert not state.is_stale
    state = after(state, intents.ZoneSet(Zone.CONTROL_POINTS, {}))
    assert value_at(state.document, Z_OF_P22) == 0.9
    assert state.is_stale
    state = after(state, intents.Configured())
    assert not state.is_stale


def test_live_again_sets_what_is_pending(start):
    state = after(start, intents.LiveSwitched(False), intents.ValuesEdited({Z_OF_P22: 0.9}), intents.LiveSwitched(True))
    assert value_at(state.document, Z_OF_P22) == 0.9
    assert state.history.undo_text == "Set pending values"
    assert not state.is_stale


def test_get_brings_the_active_values_back(start):
    state = after(
        start,
        intents.LiveSwitched(False),
        intents.ValuesEdited({Z_OF_P22: 0.9, S_OF_C2: 0.6}),
        intents.TextTyped(Z_OF_P22, "nonsense"),
        intents.ZoneRead(Zone.CONTROL_POINTS),
    )
    assert not state.is_pending(Z_OF_P22)
    assert state.is_pending(S_OF_C2)


def test_a_drag_sets_the_document_even_where_edits_wait(start):
    state = after(start, intents.LiveSwitched(False), intents.ValuesEdited({S_OF_C2: 0.6}), dragged(0.9))
    assert value_at(state.document, Z_OF_P22) == value_at(state.draft, Z_OF_P22) == 0.9
    assert state.is_stale
    assert state.is_pending(S_OF_C2)
    cancelled = after(state, intents.GestureCancelled(7))
    assert value_at(cancelled.draft, Z_OF_P22) == 0.5
    assert cancelled.is_pending(S_OF_C2)


def test_a_text_stays_until_its_number_changes(start):
    state = after(start, intents.TextTyped(Z_OF_P22, "0.6x"), intents.ValuesEdited({S_OF_C2: 0.6}))
    assert state.texts == {Z_OF_P22: "0.6x"}
    assert after(state, intents.ValuesEdited({Z_OF_P22: 0.9})).texts == {}
    assert after(state, intents.TextTyped(Z_OF_P22, None)).texts == {}
    assert after(state, intents.ValuesPasted({Z_OF_P22: 0.5})).texts == {}


def test_opening_begins_anew(start):
    state = after(start, dragged(0.9), intents.TextTyped(Z_OF_P22, "1"), looking_intents.Selected((2, 2)))
    state = after(state, intents.Opened(preset("fig6d").document, "fig6d", preset="fig6d", message="Opened fig6d"))
    assert state.document == preset("fig6d").document == state.draft
    assert not state.is_stale
    assert not state.is_changed
    assert state.history.undo_text is None
    assert state.texts == {}
    assert state.selection.last is None
    assert state.file.opening == start.file.opening + 1
    assert state.message.text == "Opened fig6d"


def test_a_document_that_was_never_saved_stays_changed(start):
    state = after(start, intents.Opened(preset("fig6d").document, "x", is_saved=False))
    assert state.is_changed
    assert not after(state, intents.Saved("x.qovr", "x.qovr", state.history.serial)).is_changed


def test_another_formulation_shows_the_layer_that_lies_on_the_net(start):
    state = after(start, intents.FormulationChosen("interpolating"))
    assert state.document.formulation == Formulation.INTERPOLATING
    assert state.display.layer == LayerChoice.RAW
    assert after(state, intents.FormulationChosen("published")).display.layer == LayerChoice.TRANSFORMED
    both = after(
        start, looking_intents.DisplayChosen("layer", LayerChoice.BOTH), intents.FormulationChosen("interpolating")
    )
    assert both.display.layer == LayerChoice.BOTH


def test_focus_is_what_was_turned_to_last(start):
    state = after(start, looking_intents.FieldFocused(S_OF_C2))
    assert state.focus == S_OF_C2
    state = after(state, looking_intents.Selected((1, 3)))
    assert state.focus == (1, 3)
    assert state.knot == S_OF_C2
    assert after(state, looking_intents.Selected(None)).focus is None
    state = after(state, looking_intents.FieldFocused(Z_OF_P22))
    assert state.focus == state.selection.last == (2, 2)
    state = after(state, looking_intents.FieldFocused(S_OF_C2), looking_intents.Selected(None))
    assert state.focus is None


def test_a_pinned_reference_outlives_edits_and_documents(start):
    state = after(start, looking_intents.ReferencePinned())
    pinned = state.reference
    assert pinned.name == "fig5, published"
    state = after(state, dragged(0.9), intents.Opened(preset("fig8").document, "fig8"))
    assert state.reference is pinned
    assert after(state, looking_intents.ReferenceUnpinned()).reference is None


def test_the_comparison_is_in_the_view_while_its_panel_is_shown(start):
    assert start.shown_comparison is None
    state = after(start, looking_intents.PanelShown("comparison"))
    assert state.shown_comparison == state.comparison
    state = after(state, looking_intents.ComparisonChosen("nurbs", Placement.BESIDE, 9.0))
    assert (state.comparison.surface, state.comparison.weight) == ("nurbs", 9.0)
    assert after(state, looking_intents.ComparisonChosen("nurbs", "", 9.0)).shown_comparison is None
    assert after(state, looking_intents.PanelShown("claims")).shown_comparison is None


def test_the_distance_map_brings_the_colours_back(start):
    state = after(start, looking_intents.DisplayChosen("colour_by", "mean"), looking_intents.PanelShown("comparison"))
    mapped = after(state, looking_intents.DistanceMapSwitched(True))
    assert mapped.display.colour_by == "distance"
    assert after(mapped, looking_intents.DistanceMapSwitched(False)).display.colour_by == "mean"
    assert after(mapped, looking_intents.PanelShown("")).display.colour_by == "mean"
    by_hand = after(state, looking_intents.DisplayChosen("colour_by", "distance"))
    assert after(by_hand, looking_intents.PanelShown("")).display.colour_by == "distance"


def test_a_fixed_range_is_chosen_with_its_ends(start):
    state = after(start, looking_intents.RangeFixed(-1.0, 2.5))
    assert (state.display.colour_range, state.display.fixed_range) == (ColourRange.FIXED, (-1.0, 2.5))


def test_a_refusal_is_outdated_by_the_next_edit_and_a_report_is_not(start):
    refused = after(start, looking_intents.MessageShown("no", is_refusal=True), intents.ValuesEdited({Z_OF_P22: 0.9}))
    assert refused.message is None
    told = after(start, looking_intents.MessageShown("yes"), intents.ValuesEdited({Z_OF_P22: 0.9}))
    assert told.message.text == "yes"


def test_undo_brings_every_fact_of_the_document_back(start, tmp_path):
    state = after(
        start,
        intents.ValuesEdited({S_OF_C2: 0.6}),
        intents.SamplesChosen((31, 41)),
        intents.FormulationChosen("double-sum"),
        dragged(0.9),
    )
    for _ in range(4):
        state = after(state, intents.Undone())
    assert state.document == start.document == read_source("paper:fig5")
    for _ in range(4):
        state = after(state, intents.Redone())
    assert value_at(state.document, Z_OF_P22) == 0.9


class TestStore:
    def make(self, start):
        asked, told = [], []
        store = Store(start, lambda: asked.append(None))
        store.subscribe(lambda before, after: told.append((before, after)))
        assert told.pop() == (None, start)
        return store, asked, told

    def test_it_says_once_a_turn_what_has_changed(self, start):
        store, asked, told = self.make(start)
        store.dispatch(dragged(0.7))
        store.dispatch(dragged(0.8))
        assert asked
        assert told == []
        store.flush()
        ((before, after_both),) = told
        assert before is start
        assert after_both is store.state
        store.flush()
        assert len(told) == 1

    def test_what_is_refused_is_returned_and_said(self, start):
        store, _, told = self.make(start)
        error = store.dispatch(intents.ValuesEdited({S_OF_C2: 7.0}))
        assert "strictly between 0 and 1" in str(error)
        store.flush()
        assert told[0][1].message.is_refusal
        assert told[0][1].document is start.document

    def test_requests_go_to_the_shell(self, start):
        store, _, _ = self.make(start)

        class Asked(intents.Request):
            pass

        performed = []
        with pytest.raises(TypeError):
            store.dispatch(Asked())
        store.answer_with(performed.append)
        request = Asked()
        store.dispatch(request)
        assert performed == [request]


@pytest.mark.parametrize(
    ("remembered", "shown"), [(LayerChoice.RAW, LayerChoice.TRANSFORMED), (LayerChoice.BOTH, LayerChoice.BOTH)]
)
def test_a_window_begins_with_the_layer_that_lies_on_the_net(start, remembered, shown):
    display = replace(start.display, layer=remembered)  # as an interpolating document has left it
    assert after(first_state(start.document, start.file, display), intents.Configured()).display.layer is shown


def test_the_hint_of_a_selected_point_ends_with_its_selection(start):
    state = after(start, looking_intents.Selected((2, 3)))
    assert "Drag" in state.message.text
    assert after(state, looking_intents.DisplayChosen("labels", False)).message is state.message
    assert after(state, looking_intents.FieldFocused(CoordinatePlace(1, 1, 2))).message is None
