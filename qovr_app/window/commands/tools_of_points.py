"""The commands that say what the hand does with control points: tools, soft moves, symmetry."""

from __future__ import annotations

from collections.abc import Callable

from qovr_app.state.editor_state import EditorState
from qovr_app.state.intents import Intent
from qovr_app.state.looking_intents import ToolChosen
from qovr_app.state.tools import Way
from qovr_app.window.commands.command import Command, asking

_MENU = "&Points/&Tool"

_WAYS = {
    Way.Z: ("Move along &z", "A dragged point changes its height alone"),
    Way.VIEW: ("Move in the &view plane", "A dragged point follows the mouse in the plane of the view"),
    Way.NORMAL: ("Move al&ong the normal", "A dragged point moves along the surface's normal at its nearest place"),
}

_SWITCHES = {
    "tool_select": ("selects", "&Select with a rectangle", "A drag selects the points in its rectangle"),
    "tool_measure": (
        "measures",
        "&Measure",
        "Click two points of net or surface for their distance, a third one for the angle; Esc ends it",
    ),
    "snap": ("snaps", "S&nap to the step", "A drag keeps to multiples of the step"),
    "soft": ("soft", "So&ft moves", "The points around follow, less with every step along the net"),
    "symmetry_rows": (
        "symmetry_rows",
        "Symmetry across &rows",
        "Row i moves and is set as the mirror of row N-1-i, in y or the axis chosen in Planes of symmetry",
    ),
    "symmetry_columns": (
        "symmetry_columns",
        "Symmetry across &columns",
        "Column j moves and is set as the mirror of column N-1-j, in x or the axis chosen in Planes of symmetry",
    ),
    "xray": ("xray", "&X-ray", "Points behind the surface can be picked"),
}
"""What can be switched, by the command: field of ToolSettings, text and tip."""


def tool_commands() -> tuple[Command, ...]:
    """Return the commands that choose how points are picked and moved."""
    ways = (
        Command(f"move_{way}", text, asking(ToolChosen("way", way)), _MENU, tip=tip, group="way", is_checked=_is(way))
        for way, (text, tip) in _WAYS.items()
    )
    switches = (
        Command(name, text, _switching(setting), _MENU, tip=tip, is_checked=_is_on(setting), begins_part=name in _PARTS)
        for name, (setting, text, tip) in _SWITCHES.items()
    )
    return (*ways, *switches)


_PARTS = ("tool_select", "soft", "xray")
"""The commands before which the menu has a line."""


def _is(way: Way) -> Callable[[EditorState], bool]:
    return lambda state: state.tools.way is way


def _switching(setting: str) -> Callable[[EditorState], Intent]:
    return lambda state: ToolChosen(setting, not getattr(state.tools, setting))


def _is_on(setting: str) -> Callable[[EditorState], bool]:
    return lambda state: bool(getattr(state.tools, setting))
