"""The commands that copy a zone for a spreadsheet, and paste a spreadsheet's block."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtGui import QGuiApplication

from qovr_app.window.actions import Command
from qovr_app.window.layout import Workspace
from qovr_core.number_texts import block_text


def clipboard_commands(space: Workspace, tell: Callable[[str], None]) -> list[Command]:
    """Return the commands of the menu Edit that go through the clipboard; ``tell`` says what was copied."""

    def copy_zone() -> None:
        zone = space.current_zone()
        QGuiApplication.clipboard().setText(block_text(zone.copied_block()))
        tell(f"Copied the {zone.accessibleName().lower()}")

    def copy_plane() -> None:
        QGuiApplication.clipboard().setText(block_text(space.points.copied_plane()))
        tell("Copied one coordinate of all control points")

    def paste_zone() -> None:
        space.current_zone().paste_block(QGuiApplication.clipboard().text())

    return [
        Command(
            "copy_zone",
            "Copy &zone",
            copy_zone,
            "&Edit",
            "Ctrl+Shift+C",
            tip="Copy all numbers of the zone for a spreadsheet; control points as 25 rows of X, Y, Z",
        ),
        Command(
            "copy_plane",
            "Copy one coor&dinate, 5 × 5",
            copy_plane,
            "&Edit",
            "Ctrl+Alt+C",
            tip="Copy the coordinate in which the keyboard is, of all points, as the net lies",
        ),
        Command(
            "paste_zone",
            "&Paste into zone",
            paste_zone,
            "&Edit",
            "Ctrl+Shift+V",
            tip="Paste a spreadsheet's block: 25 x 3 or 5 x 5 for the points, the whole table for knots",
        ),
    ]
