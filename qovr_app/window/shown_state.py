"""What the view is given to show of a state."""

from __future__ import annotations

from qovr_app.state.editor_state import EditorState
from qovr_app.state.focus import measured_in_window, window_shown
from qovr_app.state.pending import points_that_differ, refused_points
from qovr_app.state.sections import settings_shown
from qovr_app.view3d.scene.comparison import ComparisonView
from qovr_app.view3d.scene.shown import Shown
from qovr_app.window.knots_in_view import knot_in_focus
from qovr_core.laboratory.comparison_surfaces import COMPARISON_SURFACES


def shown_of(state: EditorState) -> Shown:
    """Return what the view shows of a state."""
    reference = state.reference
    return Shown(
        evaluation=state.evaluation,
        document=state.shown_document,
        settings=settings_shown(state.display, state.panel),
        tools=state.tools,
        selected=state.selection.points,
        last_selected=state.selection.last,
        pending=points_that_differ(state.document, state.pending) if state.has_pending else frozenset(),
        refused=refused_points(state.texts),
        put_away=state.put_away - state.selection.points if state.put_away else frozenset(),
        reference=reference.surface if reference else None,
        reference_name=reference.name if reference else "",
        knot=state.knot,
        curve=knot_in_focus(state),
        window=window_shown(state),
        comparison=_comparison_of(state),
        opening=state.file.opening,
        dragging=state.gesture is not None,
    )


def _comparison_of(state: EditorState) -> ComparisonView | None:
    choice = state.shown_comparison
    if choice is None or choice.placement is None:
        return None
    kind, point = COMPARISON_SURFACES[choice.surface], measured_in_window(state)
    return ComparisonView(kind, choice.placement, point, choice.weight, window_shown(state))
