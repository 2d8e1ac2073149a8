"""What is known of the field that has, or had last, the keyboard."""

from __future__ import annotations

from qovr_app.state.editor_state import EditorState
from qovr_app.state.knot_in_hand import default_knot
from qovr_core.edits import Place, value_at
from qovr_core.geometry.knots import KnotPlace


def current_place(state: EditorState) -> Place | None:
    """Return where the field stands that has, or had last, the keyboard; None before any had it."""
    return next(reversed(tuple(state.fields.values())), None)


def value_to_share(state: EditorState, place: Place) -> float:
    """Return the number of a field, what is typed over it counted."""
    return value_at(state.pending, place)


def default_value(state: EditorState, place: Place) -> float:
    """Return what a number is reset to: a knot to that of new curves, a coordinate to where it was first."""
    if isinstance(place, KnotPlace):
        return default_knot(place.name)
    first = state.history.first
    same_net = first.control_points.shape == state.draft.control_points.shape
    return value_at(first if same_net else state.draft, place)
