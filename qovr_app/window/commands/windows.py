"""The commands of the menu Window."""

from __future__ import annotations

from qovr_app.state import requests
from qovr_app.window.commands.command import Command, asking


def window_commands() -> tuple[Command, ...]:
    """Return the commands of the menu Window; the windows themselves are listed below them."""
    menu = "&Window"
    return (
        Command(
            "new_window",
            "&New window",
            asking(requests.WindowAsked()),
            menu,
            "Ctrl+Shift+N",
            "Another document beside this one",
        ),
        Command("next_window", "Ne&xt window", asking(requests.WindowStepped()), menu, "Ctrl+F6"),
        Command("previous_window", "&Previous window", asking(requests.WindowStepped(-1)), menu, "Ctrl+Shift+F6"),
    )
