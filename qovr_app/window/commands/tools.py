"""The commands that go to parts of the window, open panels, pin references, copy the probe, and help."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtGui import QKeySequence

from qovr_app.laboratory.panels import PANELS
from qovr_app.state import looking_intents, requests
from qovr_app.state.editor_state import EditorState
from qovr_app.state.intents import Intent
from qovr_app.window.commands.command import Command, asking

_PARTS = {
    "row_knots": "&Row-wise knots",
    "column_knots": "&Column-wise knots",
    "control_points": "Control &points",
    "surface": "&Surface",
    "view": "3D &view",
}
"""Where the keyboard can be brought, by the names of zones; Alt and a number goes there."""

_FIRST_PANEL = len(_PARTS) + 1
"""Alt and the numbers from here on open the panels of the laboratory."""


def go_commands() -> tuple[Command, ...]:
    """Return the commands that bring the zones, and the keyboard to a part of the window."""
    return (
        Command(
            "show_panels",
            "&Zones",
            lambda state: looking_intents.ZonesShown(not state.shows_zones),
            "&View/&Show",
            "F9",
            "The zones of fields beside the view",
            is_checked=lambda state: state.shows_zones,
        ),
        *(
            Command(
                f"go_{name}",
                text,
                asking(requests.FocusAsked(name)),
                "&View/&Go to",
                f"Alt+{number}",
                begins_part=number == 1,
            )
            for number, (name, text) in enumerate(_PARTS.items(), start=1)
        ),
    )


def laboratory_commands() -> tuple[Command, ...]:
    """Return the commands of the menu Laboratory, each of which opens its panel or closes it."""
    return tuple(
        Command(
            f"laboratory_{name}",
            panel.title,
            _switching(name),
            "&Laboratory",
            f"Alt+{number}" if number < 10 else None,
            panel.tip,
            is_checked=_is_shown(name),
        )
        for number, (name, panel) in enumerate(PANELS.items(), start=_FIRST_PANEL)
    )


def _switching(name: str) -> Callable[[EditorState], Intent]:
    return lambda state: looking_intents.PanelShown("" if state.panel == name else name)


def _is_shown(name: str) -> Callable[[EditorState], bool]:
    return lambda state: state.panel == name


def probe_commands() -> tuple[Command, ...]:
    """Return the commands that pin, unpin, and copy what the probe says."""
    return (
        Command(
            "copy_probe",
            "Copy pro&be",
            asking(requests.CopyAsked("probe")),
            "&Edit",
            "Ctrl+Alt+P",
            "Copy what the probe says about the point under the mouse, at full precision",
        ),
        Command(
            "copy_measure",
            "Copy &measurement",
            asking(requests.CopyAsked("measure")),
            "&Edit",
            "Ctrl+Alt+M",
            "Copy distances, differences and the angle between the measured places, at full precision",
        ),
        Command(
            "pin_reference",
            "&Pin as reference",
            asking(looking_intents.ReferencePinned()),
            "&Laboratory",
            "Ctrl+R",
            "Keep the surface as it is now, and take distances from it",
            begins_part=True,
        ),
        Command(
            "unpin_reference",
            "&Unpin the reference",
            asking(looking_intents.ReferenceUnpinned()),
            "&Laboratory",
            tip="Forget the reference",
        ),
    )


def help_commands() -> tuple[Command, ...]:
    """Return the commands of the menu Help."""
    key = QKeySequence.StandardKey.HelpContents
    menu = "&Help"
    return (
        Command("help", "&Help", asking(requests.HelpAsked()), menu, key),
        Command("tour", "&Tour", asking(requests.TourAsked()), menu, tip="Five steps with the paper's example"),
        Command("keys", "&Keys", asking(requests.KeysAsked()), menu, "Ctrl+F1", "Which command has which key"),
        Command(
            "palette",
            "&Find a command…",
            asking(requests.PaletteAsked()),
            menu,
            "Ctrl+Shift+P",
            "All commands, by a few letters of their names",
        ),
        Command(
            "citation",
            "Copy the &citation",
            asking(requests.CopyAsked("citation")),
            menu,
            tip="Copy the paper's entry for BibTeX",
            begins_part=True,
        ),
        Command(
            "report",
            "Report a &problem",
            asking(requests.CopyAsked("report")),
            menu,
            tip="Copy versions and what was done, to paste into a report",
        ),
        Command("about", "&About", asking(requests.AboutAsked()), menu, tip="The versions in use"),
    )
