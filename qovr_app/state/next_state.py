"""The one function that makes the next state: pure, and the only place where intents are followed."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from qovr_app.state import (
    document_steps,
    field_intents,
    field_steps,
    history_steps,
    intents,
    knot_intents,
    knot_steps,
    looking_intents,
    looking_steps,
    net_intents,
    net_steps,
    point_intents,
    point_steps,
)
from qovr_app.state.editor_state import EditorState

_STEPS: dict[type[intents.Intent], Callable[[EditorState, Any], EditorState]] = {
    intents.ValuesEdited: document_steps.values_edited,
    intents.ValuesPasted: document_steps.values_pasted,
    intents.TextTyped: document_steps.text_typed,
    intents.ZoneSet: document_steps.zone_set,
    intents.PendingSet: document_steps.pending_set,
    intents.ZoneRead: document_steps.zone_read,
    knot_intents.KnotsSet: knot_steps.knots_set,
    knot_intents.LinkSwitched: knot_steps.link_switched,
    intents.PointsMoved: point_steps.points_moved,
    point_intents.PointsNudged: point_steps.points_nudged,
    point_intents.PointsEdited: point_steps.points_edited,
    point_intents.MadeSymmetric: point_steps.made_symmetric,
    net_intents.WindowInserted: net_steps.window_inserted,
    net_intents.WindowRemoved: net_steps.window_removed,
    net_intents.WindowAppended: net_steps.window_appended,
    net_intents.WindowExtracted: net_steps.window_extracted,
    net_intents.JointSmoothed: net_steps.joint_smoothed,
    net_intents.JointSharpened: net_steps.joint_sharpened,
    net_intents.JointCreased: net_steps.joint_creased,
    net_intents.KnotsSpaced: net_steps.knots_spaced,
    net_intents.NetReversed: net_steps.net_reversed,
    net_intents.NetTransposed: net_steps.net_transposed,
    net_intents.NetMirrored: net_steps.net_mirrored,
    net_intents.NetResampled: net_steps.net_resampled,
    field_intents.ValuesShifted: field_steps.values_shifted,
    intents.GestureBegun: document_steps.gesture_begun,
    intents.GestureEnded: document_steps.gesture_ended,
    intents.GestureCancelled: document_steps.gesture_cancelled,
    intents.FormulationChosen: document_steps.formulation_chosen,
    intents.SamplesChosen: document_steps.samples_chosen,
    intents.Undone: history_steps.undone,
    intents.Redone: history_steps.redone,
    intents.WentTo: history_steps.went_to,
    intents.Configured: document_steps.configured,
    intents.LiveSwitched: document_steps.live_switched,
    intents.Opened: document_steps.opened,
    intents.Saved: document_steps.saved,
    intents.FileFound: document_steps.file_found,
    intents.Reloaded: document_steps.reloaded,
    intents.OutsideKept: document_steps.outside_kept,
    looking_intents.Selected: looking_steps.selected,
    looking_intents.PointsPutAway: looking_steps.points_put_away,
    looking_intents.FieldFocused: looking_steps.field_focused,
    looking_intents.WindowFocused: looking_steps.window_focused,
    looking_intents.DisplayChosen: looking_steps.display_chosen,
    looking_intents.PaperLookChosen: looking_steps.paper_look_chosen,
    looking_intents.ToolChosen: looking_steps.tool_chosen,
    looking_intents.RangeFixed: looking_steps.range_fixed,
    looking_intents.ReferencePinned: looking_steps.reference_pinned,
    looking_intents.ReferenceUnpinned: looking_steps.reference_unpinned,
    looking_intents.ComparisonChosen: looking_steps.comparison_chosen,
    looking_intents.DistanceMapSwitched: looking_steps.distance_map_switched,
    looking_intents.PanelShown: looking_steps.panel_shown,
    looking_intents.ZonesShown: looking_steps.zones_shown,
    looking_intents.MessageShown: looking_steps.message_shown,
    looking_intents.MessageOutdated: looking_steps.message_outdated,
}


def next_state(state: EditorState, intent: intents.Intent) -> EditorState:
    """Return the state after an intent; it does no input or output, and the same state and intent give the same.

    Raises
    ------
    QovrError : the intent asks for what cannot be; the state stays as it is
    TypeError : nobody follows an intent of this kind
    """
    try:
        step = _STEPS[type(intent)]
    except KeyError:
        raise TypeError(f"no step follows {type(intent).__name__}; expected one of the intents") from None
    return looking_steps.without_old_hint(state, step(state, intent))
