"""The commands that hide control points with what hangs on them, so that others can be seen and picked."""

from __future__ import annotations

from itertools import product

from qovr_app.state.editor_state import EditorState
from qovr_app.state.looking_intents import PointsPutAway
from qovr_app.window.commands.command import Command, asking
from qovr_app.window.commands.points import NEEDS_ONE, has_selection

_MENU = "&Points/&Hide"


def hiding_commands() -> tuple[Command, ...]:
    """Return the commands that hide points, and show them again."""
    return (
        Command(
            "hide_points",
            "&Hide",
            lambda state: PointsPutAway(tuple(sorted(state.put_away | state.selection.points))),
            _MENU,
            "Ctrl+H",
            "Hide the selected points with their lines of the net; the surface stays",
            is_enabled=has_selection,
            needs=NEEDS_ONE,
        ),
        Command(
            "isolate_points",
            "&Isolate",
            lambda state: PointsPutAway(tuple(sorted(_others(state)))),
            _MENU,
            "Ctrl+Shift+H",
            "Hide all points but the selected ones, and the curves on which none of them lies",
            is_enabled=has_selection,
            needs=NEEDS_ONE,
        ),
        Command(
            "show_points",
            "Sho&w all",
            asking(PointsPutAway(())),
            _MENU,
            "Ctrl+Alt+H",
            "Show all points again",
            is_enabled=lambda state: bool(state.put_away),
            needs="No point is hidden",
        ),
    )


def _others(state: EditorState) -> set[tuple[int, int]]:
    rows, columns, _ = state.document.control_points.shape
    return set(product(range(rows), range(columns))) - state.selection.points
