"""What is looked at, in the next state: selection, display, reference, comparison, panels, messages."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from qovr_app.state import looking_intents
from qovr_app.state.display import PAPER_LOOK, ColourRange, LayerChoice, Placement
from qovr_app.state.editor_state import ComparisonChoice, EditorState, Reference, Selection, with_message
from qovr_app.state.focus import check_places, has_point, nearest_window, with_focus
from qovr_app.state.looking_intents import Picking
from qovr_app.state.names import in_window_words
from qovr_app.state.tools import check_setting
from qovr_core import Layer, QovrError
from qovr_core.document import NetIndex
from qovr_core.edits import CoordinatePlace, check_points, check_window, zone_of
from qovr_core.fields import Field

DRAG_HINT = "Drag: up and down along z. Tap X, Y or Z: along that axis. Type a value. Esc: put the point back."


def selected(state: EditorState, intent: looking_intents.Selected) -> EditorState:
    picked = () if intent.last is None else (intent.last, *intent.others)
    check_points(state.document, picked)
    before = state.selection.points if intent.picking is not Picking.REPLACE else frozenset()
    points = before ^ frozenset(picked) if intent.picking is Picking.TOGGLE else before | frozenset(picked)
    if not points:
        return replace(state, selection=Selection(), knot_came_last=False, message=None)
    latest = next((index for index in (intent.last, state.selection.last) if index in points), None) or min(points)
    state = _with_points(state, latest, points)
    arrived = points.intersection(picked)
    if arrived and not any(has_point(state.window, index) for index in arrived):
        state = with_focus(state, nearest_window(state.document, state.window, latest))
    if len(points) > 1:
        return with_message(state, f"{len(points)} points are selected.")
    return with_message(state, "P {},{}.  {}".format(*latest, DRAG_HINT))


def without_old_hint(before: EditorState, after: EditorState) -> EditorState:
    """Return the state in which the hint of a selected point has ended with its selection."""
    said = after.message
    is_hint = said is not None and said is before.message and said.text.endswith(DRAG_HINT)
    return replace(after, message=None) if is_hint and after.selection != before.selection else after


def points_put_away(state: EditorState, intent: looking_intents.PointsPutAway) -> EditorState:
    check_points(state.document, intent.indices)
    put_away = frozenset(intent.indices)
    kept = tuple(index for index in state.selection.indices if index not in put_away)
    state = replace(state, put_away=put_away, selection=Selection(kept[0] if kept else None, frozenset(kept)))
    if not put_away:
        return with_message(state, "All points are shown.")
    what = "1 point is" if len(put_away) == 1 else f"{len(put_away)} points are"
    return with_message(state, f"{what} hidden: Points, Hide, Show all (Ctrl+Alt+H) brings all back.")


def field_focused(state: EditorState, intent: looking_intents.FieldFocused) -> EditorState:
    place = intent.place
    check_places(state.document, [place])
    state = with_focus(state, nearest_window(state.document, state.window, place))
    others = {zone: other for zone, other in state.fields.items() if zone is not zone_of(place)}
    state = replace(state, fields={**others, zone_of(place): place})
    if isinstance(place, CoordinatePlace):
        point = (place.i, place.j)
        return _with_points(state, point, frozenset((point,)))
    return replace(state, knot=place, knot_came_last=True)


def window_focused(state: EditorState, intent: looking_intents.WindowFocused) -> EditorState:
    check_window(state.document, intent.window)
    return with_focus(state, intent.window)


def _with_points(state: EditorState, last: NetIndex, points: frozenset[NetIndex]) -> EditorState:
    return replace(state, selection=Selection(last, points), measured_point=last, knot_came_last=False)


def display_chosen(state: EditorState, intent: looking_intents.DisplayChosen) -> EditorState:
    before = state.colours_before if intent.setting != "colour_by" else ""
    changes: dict[str, Any] = {intent.setting: intent.value}
    return replace(state, display=replace(state.display, **changes), colours_before=before)


def paper_look_chosen(state: EditorState, _intent: looking_intents.PaperLookChosen) -> EditorState:
    changes: dict[str, Any] = PAPER_LOOK
    state = replace(state, display=replace(state.display, **changes), colours_before="")
    return with_message(state, "As in the paper's figures: facets in MATLAB's jet, from its camera.")


def tool_chosen(state: EditorState, intent: looking_intents.ToolChosen) -> EditorState:
    check_setting(intent.setting, intent.value)
    changes: dict[str, Any] = {intent.setting: intent.value}
    return replace(state, tools=replace(state.tools, **changes))


def range_fixed(state: EditorState, intent: looking_intents.RangeFixed) -> EditorState:
    limits = (intent.low, intent.high)
    return replace(state, display=replace(state.display, colour_range=ColourRange.FIXED, fixed_range=limits))


def reference_pinned(state: EditorState, _intent: looking_intents.ReferencePinned) -> EditorState:
    """Pin the surface configured last, in the layer that is shown; of two, in the one that lies on the net."""
    evaluation, shown = state.evaluation, state.display.layer
    if evaluation is None:
        return with_message(state, "There is no surface to pin: configure one first (F5).")
    formulation = evaluation.document.formulation
    layer = formulation.resting_layer if shown is LayerChoice.BOTH else Layer(shown.value)
    reference = Reference(evaluation.layer_patch(layer), f"{state.file.title}, {formulation}")
    return with_message(
        replace(state, reference=reference),
        f"Pinned the {layer} surface of {state.file.title} ({formulation}) as the reference. "
        "View, Colour by, Distance shows how far a surface lies from it.",
    )


def reference_unpinned(state: EditorState, _intent: looking_intents.ReferenceUnpinned) -> EditorState:
    text = "There is no reference." if state.reference is None else "There is no reference any more."
    return with_message(replace(state, reference=None), text)


def comparison_chosen(state: EditorState, intent: looking_intents.ComparisonChosen) -> EditorState:
    placement = Placement(intent.placement) if intent.placement else None
    state = replace(state, comparison=ComparisonChoice(intent.surface, placement, intent.weight))
    return state if state.shown_comparison else _without_distance_map(state)


def distance_map_switched(state: EditorState, intent: looking_intents.DistanceMapSwitched) -> EditorState:
    if not intent.is_on:
        return _without_distance_map(state, Field.HEIGHT.name)
    before = state.display.colour_by
    display = replace(state.display, colour_by=Field.DISTANCE.name)
    return replace(state, display=display, colours_before=before)


def _without_distance_map(state: EditorState, otherwise: str = "") -> EditorState:
    """Return the state in which the colours are those from before the distance map."""
    before = state.colours_before or otherwise
    if before and state.display.colour_by == Field.DISTANCE.name:
        state = replace(state, display=replace(state.display, colour_by=before))
    return replace(state, colours_before="")


def panel_shown(state: EditorState, intent: looking_intents.PanelShown) -> EditorState:
    state = replace(state, panel=intent.name)
    return state if state.shown_comparison else _without_distance_map(state)


def zones_shown(state: EditorState, intent: looking_intents.ZonesShown) -> EditorState:
    return replace(state, shows_zones=intent.are_shown)


def message_shown(state: EditorState, intent: looking_intents.MessageShown) -> EditorState:
    return with_message(state, intent.text, is_refusal=intent.is_refusal)


def message_outdated(state: EditorState, intent: looking_intents.MessageOutdated) -> EditorState:
    if state.message is None or (intent.only_refusals and not state.message.is_refusal):
        return state
    return replace(state, message=None)


def refused(state: EditorState, error: QovrError) -> EditorState:
    """Return the state that says why an intent was not followed."""
    return with_message(state, f"{in_window_words(str(error))}.", is_refusal=True)
