"""States of the editor, without a window."""

from qovr_app.state import intents
from qovr_app.state.display import DisplaySettings
from qovr_app.state.editor_state import DocumentFile, EditorState, first_state
from qovr_app.state.next_state import next_state
from qovr_core.presets import preset


def opened() -> EditorState:
    """Return the editor as it opens, the surface of Figure 5 configured."""
    state = first_state(preset("fig5").document, DocumentFile("fig5"), DisplaySettings())
    return next_state(state, intents.Configured())


def after(state: EditorState, *asked: intents.Intent) -> EditorState:
    """Return the state that follows a list of intents."""
    for intent in asked:
        state = next_state(state, intent)
    return state
