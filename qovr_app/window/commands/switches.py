"""What switches a display setting, and whether it is on."""

from __future__ import annotations

from collections.abc import Callable

from qovr_app.state.editor_state import EditorState
from qovr_app.state.intents import Intent
from qovr_app.state.looking_intents import DisplayChosen


def switching(setting: str) -> Callable[[EditorState], Intent]:
    """Return what turns a display setting on or off."""
    return lambda state: DisplayChosen(setting, not getattr(state.display, setting))


def is_on(setting: str) -> Callable[[EditorState], bool]:
    """Return what tells whether a display setting is on."""
    return lambda state: bool(getattr(state.display, setting))
