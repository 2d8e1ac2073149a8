"""What only the shell can do: files, dialogs, the clipboard, the camera and the keyboard's focus."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from enum import StrEnum
from pathlib import Path
from typing import Any

from qovr_app.state.intents import Request
from qovr_core import Document


@dataclass(frozen=True)
class OpenAsked(Request):
    """Ask for a file and open it, in another window where that is wanted."""

    elsewhere: bool = False


@dataclass(frozen=True)
class SourceAsked(Request):
    """Open a file or a preset: after asking about unsaved changes, or in another window, where this one is in use."""

    source: str
    elsewhere: bool = False


@dataclass(frozen=True)
class DocumentAsked(Request):
    """Open a document that the program made, after asking about unsaved changes."""

    document: Document
    title: str


@dataclass(frozen=True)
class SaveAsked(Request):
    """Save to the document's file, or to another one that is asked for."""

    elsewhere: bool = False


@dataclass(frozen=True)
class ReloadAsked(Request):
    """Read the document's file again."""


@dataclass(frozen=True)
class SaveCopyAsked(Request):
    """Save to another file that is asked for, and stay with the document's own."""


@dataclass(frozen=True)
class ExportAsked(Request):
    """Ask for a format and a file, and write the configured surface."""


@dataclass(frozen=True)
class FigureAsked(Request):
    """Ask how large and where, and write what the view shows."""


@dataclass(frozen=True)
class DrawingAsked(Request):
    """Ask how large and where, and let a drawing be written.

    Parameters
    ----------
    name : what is added to the document's name for that of the file
    write : writes the drawing to a path, with the options of a figure, as a job
    """

    name: str
    write: Callable[[Path, Any, Any], None]


@dataclass(frozen=True)
class CloseAsked(Request):
    """Close the window."""


@dataclass(frozen=True)
class WindowAsked(Request):
    """Open a window with the paper's example."""


@dataclass(frozen=True)
class WindowStepped(Request):
    """Bring the next window to the front, or for -1 the one before."""

    step: int = 1


@dataclass(frozen=True)
class PreferencesAsked(Request):
    """Show what can be preferred."""


@dataclass(frozen=True)
class QuitAsked(Request):
    """Close every window."""


@dataclass(frozen=True)
class RecoveryAnswered(Request):
    """Go on with what an earlier run left unsaved, or delete it."""

    is_wanted: bool


@dataclass(frozen=True)
class RecentCleared(Request):
    """Forget all recent files."""


@dataclass(frozen=True)
class CopyAsked(Request):
    """Copy what a name of ``window.clipboard`` stands for."""

    what: str


@dataclass(frozen=True)
class PasteAsked(Request):
    """Paste the clipboard's block into the zone that has the keyboard, or over the selected points."""

    over_points: bool = False


@dataclass(frozen=True)
class FieldMenuAsked(Request):
    """Show the menu of the field that has the keyboard, at a place of the screen."""

    at: tuple[int, int]


@dataclass(frozen=True)
class FieldCopyAsked(Request):
    """Copy the number of the field that has, or had last, the keyboard."""


@dataclass(frozen=True)
class FieldPasteAsked(Request):
    """Paste into the field that has, or had last, the keyboard; a table into its zone."""


@dataclass(frozen=True)
class ZoneButtonPressed(Request):
    """Get or Set of the zone that has the keyboard."""

    is_set: bool


@dataclass(frozen=True)
class CameraAsked(Request):
    """Look from a named direction; empty fits the surface from where the camera is."""

    name: str


class CameraStep(StrEnum):
    """Where the camera can be sent that no direction names."""

    BACK = "back"
    FORWARD = "forward"
    SELECTION = "selection"


@dataclass(frozen=True)
class CameraMoved(Request):
    """Look from where one looked before, or after that again, or at the selected points from near."""

    step: CameraStep


@dataclass(frozen=True)
class ViewRestartAsked(Request):
    """Begin again with the drawing of the view."""


@dataclass(frozen=True)
class RangeAsked(Request):
    """Ask for the ends of a fixed range of colours."""


@dataclass(frozen=True)
class TransformAsked(Request):
    """Ask by how much the selected points are moved, scaled and rotated."""


@dataclass(frozen=True)
class SymmetryAsked(Request):
    """Ask in which planes rows and columns mirror each other."""


@dataclass(frozen=True)
class FocusAsked(Request):
    """Bring the keyboard to a zone or to the view, by its name."""

    part: str


@dataclass(frozen=True)
class HelpAsked(Request):
    """Show the help beside the work."""


@dataclass(frozen=True)
class PaletteAsked(Request):
    """Show all commands, to be found by a few letters."""


@dataclass(frozen=True)
class KeysAsked(Request):
    """Show which command has which key."""


@dataclass(frozen=True)
class TourAsked(Request):
    """Show in five steps what can be done with a surface."""


@dataclass(frozen=True)
class AboutAsked(Request):
    """Show the versions of the program and of what it is built on."""
