"""The fields' part of the next state."""

from __future__ import annotations

from qovr_app.state import field_intents
from qovr_app.state.document_steps import edited
from qovr_app.state.editor_state import EditorState
from qovr_app.state.focus import check_places
from qovr_app.state.names import edit_text
from qovr_core import edits
from qovr_core.edits import Place, value_at
from qovr_core.geometry.knots import KnotPlace
from qovr_core.number_texts import summed
from qovr_core.symmetry import mirrored_values


def values_shifted(state: EditorState, intent: field_intents.ValuesShifted) -> EditorState:
    begun = state.draft_before(intent.gesture)
    check_places(begun, intent.places)
    shifted = {place: summed(value_at(begun, place), intent.amount) for place in intent.places}
    wanted: dict[Place, float] = dict(shifted)
    for place, value in shifted.items():
        if isinstance(place, KnotPlace):
            for other in state.links.places(begun, place):
                wanted.setdefault(other, value)
    for direction in state.tools.symmetries:
        wanted = mirrored_values(begun, wanted, direction, state.tools.mirror(direction))
    return edited(
        state, edit_text(list(wanted)), lambda document: edits.set_values(document, wanted), intent, intent.gesture
    )
