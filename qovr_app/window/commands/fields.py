"""The commands for the field that has, or had last, the keyboard; its menu lists them."""

from __future__ import annotations

from collections.abc import Callable

from qovr_app.state import requests
from qovr_app.state.editor_state import EditorState
from qovr_app.state.field_facts import current_place, default_value, value_to_share
from qovr_app.state.intents import Intent, TextTyped, ValuesEdited
from qovr_app.state.knot_intents import KnotsSet
from qovr_app.state.looking_intents import MessageShown
from qovr_app.window.commands.command import Command, asking
from qovr_core.edits import Place, linked_places, value_at
from qovr_core.geometry.knots import KnotPlace
from qovr_core.number_texts import number_text

_MENU = "&Edit/F&ield"
_NEEDS_FIELD = "Go to a field of a knot or a coordinate first"
_NEEDS_KNOT = "Go to the field of a knot first"


def field_commands() -> tuple[Command, ...]:
    """Return the commands for one field."""
    return (
        Command(
            "field_revert", "&Undo typing", _of_field(lambda _state, place: TextTyped(place, None)), _MENU,
            tip="Bring back the number over which something is typed",
            is_enabled=lambda state: current_place(state) in state.texts, needs="Type something into a field first",
        ),
        Command(
            "field_reset", "&Reset", _of_field(_edited_to_default), _MENU,
            tip="A knot becomes that of new curves, a coordinate what it was when the document came",
            is_enabled=_can_reset, noun=_default_noun, needs="Go to a field that holds another number than at first",
        ),
        Command(
            "field_copy", "&Copy number", asking(requests.FieldCopyAsked()), _MENU,
            tip="Copy the field's number with every digit", is_enabled=_has_field, needs=_NEEDS_FIELD,
            begins_part=True,
        ),
        Command(
            "field_paste", "&Paste", asking(requests.FieldPasteAsked()), _MENU,
            tip="Paste a number into the field, or a table into its zone", is_enabled=_has_field, needs=_NEEDS_FIELD,
        ),
        Command(
            "field_set_curves", "Set on &all curves", _of_field(_set_on_curves), _MENU,
            tip="Set this knot on all curves of its direction, whatever is linked",
            is_enabled=_has_knot, needs=_NEEDS_KNOT, begins_part=True,
        ),
        Command(
            "field_set_directions", "Set on all curves, rows and co&lumns", _of_field(_set_everywhere), _MENU,
            tip="Set this knot on all curves of both directions, whatever is linked",
            is_enabled=_has_knot, needs=_NEEDS_KNOT,
        ),
    )  # fmt: skip


def _of_field(intent: Callable[[EditorState, Place], Intent]) -> Callable[[EditorState], Intent]:
    """Return what asks for something of the field; without one it says what is missing."""

    def asked(state: EditorState) -> Intent:
        place = current_place(state)
        return MessageShown(f"{_NEEDS_FIELD}.") if place is None else intent(state, place)

    return asked


def _edited_to_default(state: EditorState, place: Place) -> Intent:
    value = default_value(state, place)
    if not isinstance(place, KnotPlace):
        return ValuesEdited({place: value})
    return KnotsSet(place.direction, place.curve, place.window, place.name, value)


def _set_on_curves(state: EditorState, place: Place) -> Intent:
    if not isinstance(place, KnotPlace):
        return MessageShown(f"{_NEEDS_KNOT}.")
    return KnotsSet(place.direction, None, place.window, place.name, value_to_share(state, place))


def _set_everywhere(state: EditorState, place: Place) -> Intent:
    if not isinstance(place, KnotPlace):
        return MessageShown(f"{_NEEDS_KNOT}.")
    places = linked_places(state.draft, place, curves=True, directions=True)
    return ValuesEdited(dict.fromkeys(places, value_to_share(state, place)))


def _has_field(state: EditorState) -> bool:
    return current_place(state) is not None


def _has_knot(state: EditorState) -> bool:
    return isinstance(current_place(state), KnotPlace)


def _can_reset(state: EditorState) -> bool:
    place = current_place(state)
    return place is not None and value_at(state.draft, place) != default_value(state, place)


def _default_noun(state: EditorState) -> str:
    place = current_place(state)
    return "" if place is None else f"to {number_text(default_value(state, place))}"
