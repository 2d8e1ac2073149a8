"""The window's commands but those of the View menu: one table."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtGui import QKeySequence

from qovr_app.window.actions import Command
from qovr_app.window.clipboard import clipboard_commands
from qovr_core.files.sources import PRESET_PREFIX
from qovr_core.presets import presets

if TYPE_CHECKING:
    from qovr_app.window.main_window import MainWindow


def window_commands(window: MainWindow) -> list[Command]:
    """Return the commands of the menus File, Edit and Surface."""
    return [*_file_commands(window), *_edit_commands(window), *_surface_commands(window)]


def help_commands(window: MainWindow) -> list[Command]:
    """Return the commands of the menu Help."""
    return [Command("help", "&Help", window.show_help, "&Help", QKeySequence.StandardKey.HelpContents)]


def go_commands(window: MainWindow) -> list[Command]:
    """Return the commands that bring the zones, and the keyboard to a part of the window."""
    space = window.workspace
    places = (
        ("row_knots", "&Row-wise knots", space.rows.focus_first),
        ("column_knots", "&Column-wise knots", space.columns.focus_first),
        ("control_points", "Control &points", space.points.focus_first),
        ("surface", "&Surface", space.surface.focus_first),
        ("view", "3D &view", window.focus_view),
    )
    panels = Command(
        "show_panels",
        "&Zones",
        space.show_panels,
        "&View/&Show",
        "F9",
        checked=True,
        tip="The zones of fields beside the view",
    )
    return [panels] + [
        Command(f"go_{name}", text, go, "&View/&Go to", f"Alt+{number}")
        for number, (name, text, go) in enumerate(places, start=1)
    ]


def _file_commands(window: MainWindow) -> list[Command]:
    key, desk = QKeySequence.StandardKey, window.desk
    return [
        Command("open", "&Open…", desk.open_dialog, "&File", key.Open),
        *(
            Command(
                f"preset_{name}",
                f"{name}  {entry.title}",
                lambda name=name: desk.open_source(f"{PRESET_PREFIX}{name}"),
                "&File/&Presets of the paper",
            )
            for name, entry in presets().items()
        ),
        Command("save", "&Save", window.save, "&File", key.Save),
        Command("save_as", "Save &As…", window.save_as, "&File", key.SaveAs),
        Command("export", "&Export Data…", window.export, "&File", "Ctrl+E", tip="Write the configured surface"),
        Command("save_figure", "Save Fi&gure…", desk.save_figure, "&File", "Ctrl+G"),
        Command("close", "&Close", window.close, "&File", key.Close),
    ]


def _edit_commands(window: MainWindow) -> list[Command]:
    key, history, space = QKeySequence.StandardKey, window.session.history, window.workspace
    return [
        Command("undo", "&Undo", history.undo, "&Edit", key.Undo),
        Command("redo", "&Redo", history.redo, "&Edit", key.Redo),
        *clipboard_commands(space, window.tell),
        Command(
            "get_values",
            "&Get Values",
            lambda: space.current_zone().get_values(),
            "&Edit",
            "Ctrl+Shift+Return",
            tip="Read the active state into the zone that has the keyboard",
        ),
        Command(
            "set_values",
            "Set &Values",
            lambda: space.current_zone().set_values(),
            "&Edit",
            "Ctrl+Return",
            tip="Make the zone that has the keyboard the active state",
        ),
    ]


def _surface_commands(window: MainWindow) -> list[Command]:
    controller = window.controller
    return [
        Command(
            "configure",
            "&Configure QOVR Surface",
            controller.configure,
            "&Surface",
            "F5",
            tip="Compute raw surface, boxes, T and transformed surface",
        ),
        Command(
            "live",
            "&Live",
            controller.set_live,
            "&Surface",
            "Ctrl+L",
            checked=True,
            tip="Set every edit at once and let the surface follow; off: Set, then Configure",
        ),
        Command(
            "link_curves",
            "Link c&urves",
            window.link_curves,
            "&Surface",
            "Ctrl+K",
            checked=True,
            tip="Editing a knot sets it on all five curves of its direction",
        ),
        Command(
            "link_directions",
            "Link &directions",
            window.link_directions,
            "&Surface",
            "Ctrl+Shift+K",
            checked=False,
            tip="Editing a knot sets it on rows and columns alike",
        ),
    ]
