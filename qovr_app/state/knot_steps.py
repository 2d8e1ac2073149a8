"""The knots' part of the next state: one knot, set by whatever hand, and those that go with it."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from qovr_app.state.document_steps import edited, with_document
from qovr_app.state.editor_state import EditorState
from qovr_app.state.knot_intents import KnotsSet, LinkSwitched
from qovr_app.state.names import edit_text
from qovr_core import Document, DocumentError, edits
from qovr_core.edits import Place, knots_of, value_at
from qovr_core.geometry.knots import KnotPlace
from qovr_core.symmetry import mirrored_values


def knots_set(state: EditorState, intent: KnotsSet) -> EditorState:
    places = _places(state, intent)
    begun = _begun(state, intent)
    wanted: dict[Place, float] = dict.fromkeys(places, intent.value)
    if intent.name == "u":
        wanted |= _s_of(state, intent, begun, places)
    for direction in state.tools.symmetries:
        wanted = mirrored_values(begun, wanted, direction, state.tools.mirror(direction))
    text = edit_text([place for place in wanted if isinstance(place, KnotPlace) and place.name == intent.name])
    if intent.in_view:
        return with_document(state, text, edits.set_values(state.document, wanted), intent, intent.gesture)
    return edited(state, text, lambda document: edits.set_values(document, wanted), intent, intent.gesture)


def link_switched(state: EditorState, intent: LinkSwitched) -> EditorState:
    changes: dict[str, Any] = {intent.link: intent.is_on}
    return replace(state, links=replace(state.links, **changes))


def _s_of(state: EditorState, intent: KnotsSet, begun: Document, places: tuple[KnotPlace, ...]) -> dict[Place, float]:
    """Return where s goes when u is set: with u, or back to where it was before this gesture took it along."""
    now = state.document if intent.in_view or state.is_live else state.draft
    values: dict[Place, float] = {}
    for place in places:
        s = replace(place, name="s")
        if intent.takes_s and value_at(begun, s) == value_at(begun, place):
            values[s] = intent.value
        elif value_at(begun, s) != value_at(now, s):
            values[s] = value_at(begun, s)
    return values


def _places(state: EditorState, intent: KnotsSet) -> tuple[KnotPlace, ...]:
    """Return the places that are set.

    Raises
    ------
    DocumentError : there is no such curve or window
    """
    document, direction = state.document, intent.direction
    curves = range(len(knots_of(document, direction)))
    if intent.curve is not None and intent.curve not in curves:
        first, last = (direction.curve_name(k) for k in (curves[0], curves[-1]))
        raise DocumentError("the curve", direction.curve_name(intent.curve), f"one of {first} to {last}")
    windows = knots_of(document, direction).windows
    if not 0 <= intent.window < windows:
        expected = "0, the only one" if windows == 1 else f"0 to {windows - 1}"
        raise DocumentError(f"the window along {direction.letter}", str(intent.window), expected)
    if intent.curve is None:
        return tuple(KnotPlace(direction, curve, intent.name, intent.window) for curve in curves)
    return state.links.places(document, KnotPlace(direction, intent.curve, intent.name, intent.window))


def _begun(state: EditorState, intent: KnotsSet) -> Document:
    """Return what the gesture began with: of the document, or of the draft where the edit waits in it."""
    if intent.in_view or state.is_live:
        return state.document_before(intent.gesture)
    return state.draft_before(intent.gesture)
