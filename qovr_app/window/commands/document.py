"""The commands of the menus File, Edit and Surface."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtGui import QKeySequence

from qovr_app.state import intents, knot_intents, requests
from qovr_app.state.editor_state import EditorState
from qovr_app.state.focus import is_net
from qovr_app.state.intents import Intent
from qovr_app.window.commands.command import Command, asking
from qovr_app.window.commands.points import repeat_command
from qovr_core.files.sources import PRESET_PREFIX
from qovr_core.presets import presets
from qovr_core.shapes import SHAPES, Shape

_Key = QKeySequence.StandardKey


def file_commands() -> tuple[Command, ...]:
    """Return the commands of the menu File."""
    menu = "&File"
    return (
        *(
            Command(
                f"new_{name}",
                shape.title,
                _beginning(shape),
                f"{menu}/&New",
                _Key.New if name == next(iter(SHAPES)) else None,
                "An interpolating surface to begin with",
            )
            for name, shape in SHAPES.items()
        ),
        Command("open", "&Open…", asking(requests.OpenAsked()), menu, _Key.Open),
        Command(
            "open_elsewhere",
            "Open in New &Window…",
            asking(requests.OpenAsked(elsewhere=True)),
            menu,
            "Ctrl+Shift+O",
            "Open a file beside this document, or in this window where nothing was done in it",
        ),
        *(
            Command(
                f"preset_{name}",
                f"{name}  {entry.title}",
                asking(requests.SourceAsked(f"{PRESET_PREFIX}{name}")),
                f"{menu}/New from &preset",
            )
            for name, entry in presets().items()
        ),
        Command("save", "&Save", asking(requests.SaveAsked()), menu, _Key.Save, begins_part=True),
        Command("save_as", "Save &As…", asking(requests.SaveAsked(elsewhere=True)), menu, _Key.SaveAs),
        Command(
            "save_copy",
            "Save a Cop&y…",
            asking(requests.SaveCopyAsked()),
            menu,
            tip="Write another file and stay with this one",
        ),
        Command(
            "reload",
            "Re&vert",
            asking(requests.ReloadAsked()),
            menu,
            tip="Read the document's file again; Undo brings back what stands here now",
            is_enabled=lambda state: state.file.path is not None,
        ),
        Command(
            "export",
            "&Export Data…",
            asking(requests.ExportAsked()),
            menu,
            "Ctrl+E",
            "Write the configured surface",
            is_enabled=lambda state: not state.is_stale,
            begins_part=True,
        ),
        Command("save_figure", "Save Fi&gure…", asking(requests.FigureAsked()), menu, "Ctrl+G"),
        Command("close", "&Close", asking(requests.CloseAsked()), menu, _Key.Close, begins_part=True),
        Command("quit", "&Quit", asking(requests.QuitAsked()), menu, _Key.Quit, "Close every window"),
    )


def _beginning(shape: Shape) -> Callable[[EditorState], Intent]:
    return lambda _state: requests.DocumentAsked(shape.document(), shape.title)


def edit_commands() -> tuple[Command, ...]:
    """Return the commands of the menu Edit."""
    menu = "&Edit"
    return (
        Command(
            "undo",
            "&Undo",
            asking(intents.Undone()),
            menu,
            _Key.Undo,
            is_enabled=lambda state: state.history.undo_text is not None,
            noun=lambda state: state.history.undo_text or "",
        ),
        Command(
            "redo",
            "&Redo",
            asking(intents.Redone()),
            menu,
            _Key.Redo,
            is_enabled=lambda state: state.history.redo_text is not None,
            noun=lambda state: state.history.redo_text or "",
        ),
        repeat_command(),
        Command(
            "copy",
            "&Copy points",
            asking(requests.CopyAsked("points")),
            menu,
            _Key.Copy,
            "Copy the selected points as a table of X, Y, Z",
            is_enabled=lambda state: bool(state.selection.points),
            needs="Select control points first",
            begins_part=True,
        ),
        Command(
            "paste",
            "P&aste points",
            asking(requests.PasteAsked(over_points=True)),
            menu,
            _Key.Paste,
            "Paste a table of X, Y, Z over the selected points, or all where none is; row 0 of the net first",
        ),
        Command(
            "copy_zone",
            "Copy &zone",
            asking(requests.CopyAsked("zone")),
            menu,
            "Ctrl+Shift+C",
            "Copy all numbers of the zone for a spreadsheet; control points as 25 rows of X, Y, Z",
            begins_part=True,
        ),
        Command(
            "copy_plane",
            "Copy one coor&dinate, 5 × 5",
            asking(requests.CopyAsked("plane")),
            menu,
            "Ctrl+Alt+C",
            "Copy the coordinate in which the keyboard is, of all points in the zone, as the net lies",
        ),
        Command(
            "paste_zone",
            "&Paste into zone",
            asking(requests.PasteAsked()),
            menu,
            "Ctrl+Shift+V",
            "Paste a spreadsheet's block: 25 x 3 or 5 x 5 for the points, the whole table for knots",
        ),
        Command(
            "get_values",
            "&Get Values",
            asking(requests.ZoneButtonPressed(is_set=False)),
            menu,
            "Ctrl+Shift+Return",
            "Read the active state into the zone that has the keyboard",
            begins_part=True,
        ),
        Command(
            "set_values",
            "Set &Values",
            asking(requests.ZoneButtonPressed(is_set=True)),
            menu,
            "Ctrl+Return",
            "Make the zone that has the keyboard the active state",
        ),
    )


def preference_commands() -> tuple[Command, ...]:
    """Return the command at the end of the menu Edit."""
    return (
        Command(
            "preferences",
            "Preference&s…",
            asking(requests.PreferencesAsked()),
            "&Edit",
            "Ctrl+,",
            "Units, digits, theme, mouse and colours, for all windows",
            begins_part=True,
        ),
    )


def surface_commands() -> tuple[Command, ...]:
    """Return the commands of the menu Surface."""
    menu = "&Surface"
    return (
        Command(
            "configure",
            "&Configure QOVR Surface",
            asking(intents.Configured()),
            menu,
            "F5",
            "Compute raw surface, boxes, T and transformed surface",
        ),
        Command(
            "live",
            "&Live",
            lambda state: intents.LiveSwitched(not state.is_live),
            menu,
            "Ctrl+L",
            "Set every edit at once and let the surface follow; off: Set, then Configure",
            is_checked=lambda state: state.is_live,
            begins_part=True,
        ),
        Command(
            "link_curves",
            "Link c&urves",
            lambda state: knot_intents.LinkSwitched("curves", not state.links.curves),
            menu,
            "Ctrl+K",
            "Editing a knot sets it on all curves of its direction",
            is_checked=lambda state: state.links.curves,
        ),
        Command(
            "link_directions",
            "Link &directions",
            lambda state: knot_intents.LinkSwitched("directions", not state.links.directions),
            menu,
            "Ctrl+Shift+K",
            "Editing a knot sets it on rows and columns alike",
            is_checked=lambda state: state.links.directions,
        ),
        Command(
            "link_windows",
            "Link &windows",
            lambda state: knot_intents.LinkSwitched("windows", not state.links.windows),
            menu,
            "Ctrl+Alt+K",
            "Editing a knot sets it in all windows of the net",
            is_checked=lambda state: state.links.windows,
            is_shown=is_net,
        ),
    )
