"""The commands of the View menu: everything that changes how the surface is shown, and nothing else."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from enum import StrEnum
from typing import Any

from qovr_app.actions import Command
from qovr_app.view3d.settings import ColourMap, DisplaySettings, Layer, Projection, Scaling, Style

SHOWN = {
    "surface": "&Surface",
    "parameter_lines": "&Parameter lines",
    "control_points": "&Control points",
    "labels": "&Labels",
    "control_net": "Control &net",
    "row_curves": "&Row curves C_i(u)",
    "column_curves": "C&olumn curves K_j(v)",
    "control_box": "&Box of the control points",
    "surface_box": "Box of the sur&face",
    "axes": "&Axes",
    "colour_bar": "Colo&ur bar",
}
"""What can be switched off, by its field of DisplaySettings."""

CHOICES: dict[str, tuple[type[StrEnum], str, dict[str, tuple[str, str | None]]]] = {
    "layer": (
        Layer,
        "&View",
        {
            "raw": ("&Raw surface", "1"),
            "transformed": ("&Transformed surface", "2"),
            "both": ("&Both side by side", "3"),
        },
    ),
    "style": (
        Style,
        "&View/St&yle",
        {
            "facets": ("&Facets", None),
            "smooth": ("&Smooth shading", None),
            "wireframe": ("&Wireframe", None),
            "points": ("&Points", None),
        },
    ),
    "colour_map": (ColourMap, "&View/&Colours", {name: (f"&{name.capitalize()}", None) for name in ColourMap}),
    "scaling": (
        Scaling,
        "&View/&Axes scaling",
        {"each": ("&Each axis by itself", None), "equal": ("E&qual scales", None)},
    ),
    "projection": (
        Projection,
        "&View/&Projection",
        {"parallel": ("Pa&rallel", None), "perspective": ("&Perspective", None)},
    ),
}

CAMERAS = {
    "paper": ("&Paper's view", "Ctrl+1", "Azimuth 36, elevation 64 degrees, as in the paper's figures"),
    "top": ("&Top", "Ctrl+2", "From above, as the paper's Figures 7 and 8b"),
    "front": ("Fr&ont", "Ctrl+3", "Along the y axis"),
    "right": ("R&ight", "Ctrl+4", "Along the x axis"),
}


def view_commands(
    settings: DisplaySettings,
    change: Callable[[DisplaySettings], None],
    current: Callable[[], DisplaySettings],
    look: Callable[[str], None],
    fit: Callable[[], None],
) -> list[Command]:
    """Return the commands that change display settings and camera.

    Parameters
    ----------
    settings : how the check marks start
    change, current : set and get the settings in force
    look : turn the camera to a named view
    fit : show everything from where the camera is
    """

    def setter(field: str, value: Any) -> Callable[[bool], None]:
        return lambda _checked: change(replace(current(), **{field: value}))

    def switch(field: str) -> Callable[[bool], None]:
        return lambda checked: change(replace(current(), **{field: checked}))

    commands = []
    for field, (kind, menu, texts) in CHOICES.items():
        for value in kind:
            text, shortcut = texts[value]
            is_chosen = getattr(settings, field) == value
            commands.append(
                Command(f"{field}_{value}", text, setter(field, value), menu, shortcut, group=field, checked=is_chosen)
            )
    for field, text in SHOWN.items():
        shown = getattr(settings, field)
        commands.append(Command(f"show_{field}", text, switch(field), "&View/&Show", checked=shown))
    commands.append(Command("fit", "&Fit", fit, "&View/Ca&mera", "F", tip="Show the whole surface and net"))
    for name, (text, shortcut, tip) in CAMERAS.items():
        commands.append(
            Command(f"camera_{name}", text, lambda name=name: look(name), "&View/Ca&mera", shortcut, tip=tip)
        )
    return commands
