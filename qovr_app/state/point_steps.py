"""The control points' part of the next state: moves by hand and by numbers."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from qovr_app.state import intents
from qovr_app.state.document_steps import with_document
from qovr_app.state.editor_state import EditorState, Gesture
from qovr_app.state.names import points_text
from qovr_core import edits


def points_moved(state: EditorState, intent: intents.PointsMoved) -> EditorState:
    """Move points of the document even where edits wait; what is pending over them stays pending."""
    displacements = np.array(intent.displacements, dtype=np.float64).reshape(-1, 3)
    moved = edits.move_points(state.document_before(intent.gesture), intent.indices, displacements)
    document = edits.set_points(state.document, moved.control_points)
    text = f"Move {points_text(intent.indices)}"
    return replace(
        with_document(state, text, document, intent, intent.gesture), gesture=_gesture(state, intent.gesture)
    )


def _gesture(state: EditorState, number: int) -> Gesture | None:
    """Return the gesture of a number: the one in hand, one that begins here, or none."""
    if not number or (state.gesture is not None and state.gesture.number == number):
        return state.gesture if number else None
    return Gesture(number, state.history, state.draft)
