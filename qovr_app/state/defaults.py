"""What a number is reset to."""

from __future__ import annotations

from qovr_app.state.editor_state import EditorState
from qovr_core import Knots
from qovr_core.edits import Place, value_at
from qovr_core.geometry.knots import KnotPlace


def default_value(state: EditorState, place: Place) -> float:
    """Return what a number is reset to: a knot to that of new curves, a coordinate to where it was first."""
    if isinstance(place, KnotPlace):
        value: float = getattr(Knots(), place.name)
        return value
    first = state.history.first
    same_net = first.control_points.shape == state.draft.control_points.shape
    return value_at(first if same_net else state.draft, place)
