"""The commands of the View menu: everything that changes how the surface is shown, and nothing else."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

from qovr_app.state.display import (
    ColourMap,
    ColourRange,
    DisplaySettings,
    LayerChoice,
    Projection,
    Scaling,
    Style,
)
from qovr_app.view3d.scene.patterns import colour_sources
from qovr_app.window.actions import Command

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

CHOICES: dict[str, tuple[type[str], str, dict[str, tuple[str, str | None]]]] = {
    "layer": (
        LayerChoice,
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
    "colour_by": (str, "&View/C&olour by", {}),
    "colour_range": (
        ColourRange,
        "&View/Colour ra&nge",
        {
            "auto": ("&Automatic", None),
            "robust": ("&Robust, 2 % to 98 %", None),
            "fixed": ("&Fixed…", None),
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
"""What one is chosen of, by its field of DisplaySettings: type, menu, and each choice's text and shortcut. What colours
the surface is asked of its tables whenever a window is made, for there may be more in them by then."""

_TIPS = {
    "colour_range_auto": "The colours end at the smallest and largest value; about zero where zero has a meaning",
    "colour_range_robust": "The colours end where 2 % of the values lie beyond, which marks at the bar's ends show",
    "colour_range_fixed": "The colours end at two values of your own",
}

CAMERAS = {
    "paper": ("&Paper's view", "Ctrl+1", "Azimuth 36, elevation 64 degrees, as in the paper's figures"),
    "top": ("&Top", "Ctrl+2", "From above, as the paper's Figures 7 and 8b"),
    "front": ("Fr&ont", "Ctrl+3", "Along the y axis"),
    "right": ("R&ight", "Ctrl+4", "Along the x axis"),
}


def view_commands(
    change: Callable[[DisplaySettings], None],
    current: Callable[[], DisplaySettings],
    look: Callable[[str], None],
    fit: Callable[[], None],
    ask_range: Callable[[], None],
) -> list[Command]:
    """Return the commands that change display settings and camera.

    Parameters
    ----------
    change, current : set and get the settings in force; the check marks start with these
    look : turn the camera to a named view
    fit : show everything from where the camera is
    ask_range : ask for the ends of a fixed range
    """

    def setter(field: str, value: Any) -> Callable[[bool], None]:
        return lambda _checked: change(replace(current(), **{field: value}))

    def switch(field: str) -> Callable[[bool], None]:
        return lambda checked: change(replace(current(), **{field: checked}))

    commands, settings = [], current()
    sources = colour_sources()
    tips = _TIPS | {f"colour_by_{source}": source.tip for source in sources.values()}
    for field, (kind, menu, fixed_texts) in CHOICES.items():
        texts = fixed_texts or {name: (source.text, None) for name, source in sources.items()}
        for value, (text, shortcut) in texts.items():
            name, is_chosen = f"{field}_{value}", getattr(settings, field) == value
            call = (lambda _checked: ask_range()) if value == ColourRange.FIXED else setter(field, kind(value))
            tip = tips.get(name, "")
            commands.append(Command(name, text, call, menu, shortcut, group=field, checked=is_chosen, tip=tip))
    for field, text in SHOWN.items():
        shown = getattr(settings, field)
        commands.append(Command(f"show_{field}", text, switch(field), "&View/&Show", checked=shown))
    commands.append(
        Command(
            "probe",
            "Prob&e",
            switch("probe"),
            "&View",
            "F8",
            checked=settings.probe,
            tip="Read off the point of the surface under the mouse: place, normal, curvatures, distance",
        )
    )
    commands.append(Command("fit", "&Fit", fit, "&View/Ca&mera", "F", tip="Show the whole surface and net"))
    for name, (text, shortcut, tip) in CAMERAS.items():
        commands.append(
            Command(f"camera_{name}", text, lambda name=name: look(name), "&View/Ca&mera", shortcut, tip=tip)
        )
    return commands
