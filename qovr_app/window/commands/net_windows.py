"""The commands that bring another window of the net into focus."""

from __future__ import annotations

from collections.abc import Callable

from qovr_app.state.editor_state import EditorState
from qovr_app.state.focus import beside, is_net
from qovr_app.state.intents import Intent
from qovr_app.state.looking_intents import WindowFocused
from qovr_app.window.commands.command import Command
from qovr_core.document import Window

_STEPS: dict[str, tuple[str, str, Window]] = {
    "window_next_u": ("&Next window along u", "Alt+Shift+Right", (0, 1)),
    "window_previous_u": ("Previous window along u", "Alt+Shift+Left", (0, -1)),
    "window_next_v": ("Next &window along v", "Alt+Shift+Up", (1, 0)),
    "window_previous_v": ("Previous window along v", "Alt+Shift+Down", (-1, 0)),
}
"""The keys go as the net lies: rows upward, columns rightward."""


def net_window_commands() -> tuple[Command, ...]:
    """Return the commands that move the focus from window to window."""
    return tuple(
        Command(
            name,
            text,
            _moving(step),
            "&View/&Go to",
            key,
            "Show the neighbouring window of the net in the zones",
            is_enabled=_can_move(step),
            is_shown=is_net,
            begins_part=name == next(iter(_STEPS)),
            needs="There is no window on that side",
        )
        for name, (text, key, step) in _STEPS.items()
    )


def _moving(step: Window) -> Callable[[EditorState], Intent]:
    return lambda state: WindowFocused(beside(state, step) or state.window)


def _can_move(step: Window) -> Callable[[EditorState], bool]:
    return lambda state: beside(state, step) is not None
