"""Knots in the view: whose handles it shows, and what the menus on a handle and on a curve do."""

from __future__ import annotations

from dataclasses import replace

from qovr_app.state.editor_state import EditorState
from qovr_app.state.focus import is_net
from qovr_app.state.intents import Intent, ValuesEdited
from qovr_app.state.knot_in_hand import KnotInHand, default_knot
from qovr_app.state.looking_intents import FieldFocused
from qovr_app.state.names import label
from qovr_app.style.symbols import symbols_in_plain
from qovr_app.widgets.plain import menu_text
from qovr_core.edits import Place, knots_of
from qovr_core.geometry.knots import KNOT_NAMES, Direction, KnotPlace
from qovr_core.number_texts import number_text

Choices = list[tuple[str, Intent]]
"""What a menu offers: the text, and what it asks for."""


def knot_in_focus(state: EditorState) -> KnotInHand | None:
    """Return the knot that is turned to, as the document has it, be the surface of others or not."""
    focus = state.focus
    return _in_hand(focus, state) if isinstance(focus, KnotPlace) else None


def _in_hand(place: KnotPlace, state: EditorState) -> KnotInHand:
    knots = knots_of(state.document, place.direction)[place.curve, place.window]
    return KnotInHand(place, knots)


def knot_choices(place: KnotPlace, state: EditorState) -> Choices:
    """Return what can be done with one knot."""
    knot = _in_hand(place, state)
    one = knot.set_to(knot.value, takes_s=True, in_view=True)
    on_all = f"Set {place.letter}_ip to {number_text(knot.value)} on all curves {_family(state, place.direction)}"
    return [
        (_text(f"Reset {label(place, in_net=is_net(state))} to {number_text(knot.default)}"), knot.reset(in_view=True)),
        (_text(on_all), replace(one, curve=None)),
    ]


def curve_choices(place: KnotPlace, state: EditorState) -> Choices:
    """Return what can be done with the knots of one curve."""
    own, curves = knots_of(state.document, place.direction)[place.curve, place.window], _curves(state, place.direction)
    name = place.direction.curve_name(place.curve)
    new: dict[Place, float] = {replace(place, name=knot): default_knot(knot) for knot in KNOT_NAMES}
    on_all: dict[Place, float] = {
        replace(place, curve=curve, name=knot): getattr(own, knot) for curve in curves for knot in KNOT_NAMES
    }
    family = _family(state, place.direction)
    return [
        (_text(f"Show the knots of {name}"), FieldFocused(place)),
        (_text(f"Reset the knots of {name}"), ValuesEdited(new)),
        (_text(f"Set the knots of {name} on all curves {family}"), ValuesEdited(on_all)),
    ]


def _text(text: str) -> str:
    return menu_text(symbols_in_plain(text))


def _curves(state: EditorState, direction: Direction) -> range:
    return range(len(knots_of(state.document, direction)))


def _family(state: EditorState, direction: Direction) -> str:
    curves = _curves(state, direction)
    return f"{direction.curve_name(curves[0])} to {direction.curve_name(curves[-1])}"
