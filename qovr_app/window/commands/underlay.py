"""The commands of the picture under the net."""

from __future__ import annotations

from qovr_app.state.editor_state import EditorState
from qovr_app.state.looking_intents import DisplayChosen
from qovr_app.state.view_requests import UnderlayAsked, UnderlayPlaceAsked
from qovr_app.window.commands.command import Command, asking

_MENU = "&View/Re&ference picture"
_NEEDS = "Choose a reference picture first"


def underlay_commands() -> tuple[Command, ...]:
    """Return the commands that choose the picture, its place, and none."""
    return (
        Command(
            "underlay",
            "&Choose…",
            asking(UnderlayAsked()),
            _MENU,
            tip="Let a PNG or JPEG picture lie in the lowest plane under the net, to shape the surface after it",
        ),
        Command(
            "underlay_place",
            "&Place…",
            asking(UnderlayPlaceAsked()),
            _MENU,
            tip="Say where the picture lies and how clearly it is seen",
            is_enabled=_has_underlay,
            needs=_NEEDS,
        ),
        Command(
            "underlay_remove",
            "&Remove",
            asking(DisplayChosen("underlay", None)),
            _MENU,
            is_enabled=_has_underlay,
            needs=_NEEDS,
        ),
    )


def _has_underlay(state: EditorState) -> bool:
    return state.display.underlay is not None
