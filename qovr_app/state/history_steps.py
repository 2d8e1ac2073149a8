"""Back and forward through the history, in the next state."""

from __future__ import annotations

from qovr_app.state import intents
from qovr_app.state.document_steps import arrived
from qovr_app.state.editor_state import EditorState
from qovr_app.state.focus import renumbered


def undone(state: EditorState, _intent: intents.Undone) -> EditorState:
    return _gone_to(state, state.history.index - 1)


def redone(state: EditorState, _intent: intents.Redone) -> EditorState:
    return _gone_to(state, state.history.index + 1)


def went_to(state: EditorState, intent: intents.WentTo) -> EditorState:
    return _gone_to(state, intent.index)


def _gone_to(state: EditorState, index: int) -> EditorState:
    history = state.history.gone_to(index)
    for renumbering in state.history.renumberings_to(index):
        state = renumbered(state, renumbering)
    return arrived(state, history)
