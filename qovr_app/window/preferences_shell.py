"""The table of preferences, and the dialog that shows it: what is chosen holds at once, in all windows."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from PySide6.QtWidgets import QWidget

from qovr_app.dialogs.preferences_dialog import PreferenceRow, PreferencesDialog
from qovr_app.state.display import ColourMap, DisplaySettings, MouseScheme, ThemeChoice
from qovr_app.state.looking_intents import DisplayChosen
from qovr_app.state.requests import PreferencesAsked
from qovr_app.style.digits import set_digits
from qovr_app.style.palette import choose_theme
from qovr_app.window.preferences import Preferences
from qovr_app.window.shell import Answers
from qovr_app.window.windows import Windows
from qovr_core.files.conventions import Unit, Up
from qovr_core.number_texts import ALL_DIGITS, USUAL_DIGITS


@dataclass(frozen=True)
class Preference:
    """One preference.

    Parameters
    ----------
    key : where the settings keep it
    row : how the dialog shows it
    apply : lets a choice hold in these windows; None where it is asked for when it is needed
    """

    key: str
    row: PreferenceRow
    apply: Callable[[str, Windows], None] | None = None


def _display(setting: str, kind: Callable[[str], Any]) -> Callable[[str, Windows], None]:
    def apply(value: str, windows: Windows) -> None:
        for window in windows.all:
            window.store.dispatch(DisplayChosen(setting, kind(value)))

    return apply


PREFERENCES = (
    Preference(
        "export/unit",
        PreferenceRow(
            "unit",
            "&Units",
            "What a document's numbers count, where a file says so: the export begins with it",
            {unit.value: unit.plural.capitalize() for unit in Unit},
            Unit.MILLIMETRE.value,
        ),
    ),
    Preference(
        "export/up",
        PreferenceRow(
            "up",
            "U&p axis",
            "The axis of a mesh that points up: the export begins with it",
            {"": "As each format's readers expect", **{up.value: f"{up.value} up" for up in Up}},
            "",
        ),
    ),
    Preference(
        "look/digits",
        PreferenceRow(
            "digits",
            "&Digits shown",
            "Significant digits in fields and tables; a field that has the keyboard shows all",
            {**{str(k): str(k) for k in (3, 4, 5, 6, 8, 10, 12)}, str(ALL_DIGITS): "All"},
            str(USUAL_DIGITS),
        ),
        lambda value, _windows: set_digits(int(value)),
    ),
    Preference(
        "look/theme",
        PreferenceRow(
            "theme",
            "&Theme",
            "Light or dark, or as the system is",
            {choice.value: choice.value.capitalize() for choice in ThemeChoice},
            ThemeChoice.SYSTEM.value,
        ),
        lambda value, _windows: choose_theme(ThemeChoice(value)),
    ),
    Preference(
        "view/mouse",
        PreferenceRow(
            "mouse",
            "&Mouse",
            "What the middle and the right button do in the view",
            {
                MouseScheme.RHINO.value: "Rhino: right orbits, Shift+right pans",
                MouseScheme.BLENDER.value: "Blender: middle orbits, Shift+middle pans",
                MouseScheme.CAD.value: "CAD: middle orbits, Ctrl+middle pans",
            },
            DisplaySettings().mouse.value,
        ),
        _display("mouse", MouseScheme),
    ),
    Preference(
        "view/colour_map",
        PreferenceRow(
            "colour_map",
            "&Colours",
            "The colours of the surface in all windows",
            {
                ColourMap.CIVIDIS.value: "Cividis, even to every eye",
                ColourMap.VIRIDIS.value: "Viridis",
                ColourMap.TURBO.value: "Turbo",
                ColourMap.JET.value: "Jet, as in the paper's figures",
            },
            DisplaySettings().colour_map.value,
        ),
        _display("colour_map", ColourMap),
    ),
)
"""In the order in which the dialog lists them."""


def apply_preferences(preferences: Preferences, windows: Windows) -> None:
    """Let what holds for all windows hold, before the first one opens."""
    for entry in PREFERENCES:
        if entry.apply is not None:
            entry.apply(_chosen(entry, preferences), windows)


def preferences_answers(windows: Windows, preferences: Preferences | None, window: QWidget) -> Answers:
    """Return what answers a window that asks for the preferences."""
    kept = preferences or Preferences()

    def choose(name: str, value: str) -> None:
        entry = next(entry for entry in PREFERENCES if entry.row.name == name)
        kept.choose(entry.key, value)
        if entry.apply is not None:
            entry.apply(value, windows)

    def show(_request: PreferencesAsked) -> None:
        shown = window.findChild(PreferencesDialog, "preferences")
        if shown is None:
            shown = PreferencesDialog([(entry.row, _chosen(entry, kept)) for entry in PREFERENCES], window)
            shown.chosen.connect(choose)
            shown.finished.connect(shown.deleteLater)
        shown.show()
        shown.raise_()
        shown.activateWindow()

    return {PreferencesAsked: show}


def _chosen(entry: Preference, preferences: Preferences) -> str:
    """Return what was chosen; what cannot be chosen counts as never set."""
    value = preferences.chosen(entry.key, entry.row.usual)
    return value if value in entry.row.choices else entry.row.usual
