"""The commands of the View menu: everything that changes how the surface is shown, and nothing else."""

from __future__ import annotations

from collections.abc import Callable

from qovr_app.laboratory.places import PLACES
from qovr_app.state.display import (
    ColourMap,
    ColourRange,
    LaboratoryPlace,
    LayerChoice,
    MouseScheme,
    Projection,
    Scaling,
    Style,
)
from qovr_app.state.editor_state import EditorState
from qovr_app.state.intents import Intent
from qovr_app.state.looking_intents import DisplayChosen
from qovr_app.state.requests import (
    CopyAsked,
    RangeAsked,
    ViewRestartAsked,
)
from qovr_app.state.view_requests import PaperLookAsked
from qovr_app.view3d.scene.patterns import colour_sources
from qovr_app.window.commands.cameras import camera_commands
from qovr_app.window.commands.command import Command, asking
from qovr_app.window.commands.switches import is_on, switching
from qovr_app.window.commands.underlay import underlay_commands

_BEGIN_PARTS = {"scaling_each"}
"""Choices before which the menu has a line."""

SHOWN = {
    "surface": "&Surface",
    "parameter_lines": "&Parameter lines",
    "control_points": "&Control points",
    "labels": "&Labels",
    "control_net": "Control &net",
    "row_curves": "&Row curves Cᵢ(u)",
    "column_curves": "C&olumn curves Kⱼ(v)",
    "joints": "&Joints and window in focus",
    "combs_u": "Curvature co&mbs along u",
    "combs_v": "Curvature combs along &v",
    "knot_handles": "&Knot handles",
    "control_box": "&Box of the control points",
    "surface_box": "Box of the sur&face",
    "axes": "&Axes",
    "colour_bar": "Colo&ur bar",
    "triad": "Axes in t&he corner",
    "legend": "Le&gend",
}
"""What can be switched off, by its field of DisplaySettings."""

CHOICES: dict[str, tuple[type[str], str, dict[str, tuple[str, str | None]]]] = {
    "layer": (
        LayerChoice,
        "&View",
        {
            "raw": ("&Raw surface", "1"),
            "transformed": ("&Transformed surface", "2"),
            "both": ("&Both", "3"),
        },
    ),
    "style": (
        Style,
        "&View/St&yle",
        {
            "facets": ("&Facets", None),
            "smooth": ("&Smooth shading", None),
            "clay": ("&Clay, light alone", None),
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
    "mouse": (
        MouseScheme,
        "&View/Mo&use",
        {
            "blender": ("&Blender: the middle button orbits, with Shift it pans", None),
            "cad": ("&CAD: the middle button orbits, with Ctrl it pans", None),
            "rhino": ("&Rhino: the right button orbits, with Shift it pans", None),
        },
    ),
    "laboratory_place": (
        LaboratoryPlace,
        "&Laboratory/Plac&e",
        {place: (text, None) for place, text in PLACES.items()},
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
    "scaling_equal": "A unit is as long along every axis; chosen again, each axis is stretched by itself",
}


def view_commands() -> tuple[Command, ...]:
    """Return the commands that change display settings and camera."""
    return (*_choice_commands(), *_switch_commands(), *camera_commands(), *_view_commands())


def _choice_commands() -> list[Command]:
    return [
        Command(
            f"{setting}_{value}",
            text,
            _choosing(setting, value),
            menu,
            shortcut,
            tip,
            group=setting,
            is_checked=_is_chosen(setting, value),
            begins_part=f"{setting}_{value}" in _BEGIN_PARTS,
        )
        for setting, (kind, menu, texts) in CHOICES.items()
        for value, text, shortcut, tip in _choices_of(setting, kind, texts)
    ]


def _choices_of(
    setting: str, kind: type[str], texts: dict[str, tuple[str, str | None]]
) -> list[tuple[str, str, str | None, str]]:
    """Return every choice of a setting: the value, and its command's text, shortcut and tip."""
    if setting == "colour_by":
        return [(name, source.text, None, source.tip) for name, source in colour_sources().items()]
    return [(kind(value), *texts[value], _TIPS.get(f"{setting}_{value}", "")) for value in texts]


def _choosing(setting: str, value: str) -> Callable[[EditorState], Intent]:
    if value is ColourRange.FIXED:
        return asking(RangeAsked())
    if value is Scaling.EQUAL:  # a button of the view bar, which is pressed again to let go
        return lambda state: DisplayChosen(setting, Scaling.EACH if state.display.scaling is value else value)
    return asking(DisplayChosen(setting, value))


def _is_chosen(setting: str, value: str) -> Callable[[EditorState], bool]:
    return lambda state: bool(getattr(state.display, setting) == value)


def _switch_commands() -> list[Command]:
    shown = [
        Command(f"show_{setting}", text, switching(setting), "&View/&Show", is_checked=is_on(setting))
        for setting, text in SHOWN.items()
    ]
    probe = Command(
        "probe",
        "Prob&e",
        switching("probe"),
        "&View",
        "F8",
        "Read off the point of the surface under the mouse: place, normal, curvatures, distance",
        is_checked=is_on("probe"),
        begins_part=True,
    )
    shared = Command(
        "shares_range",
        "One range in &both",
        switching("shares_range"),
        "&View/Colour ra&nge",
        tip="Where both layers are shown, a colour means the same in both",
        is_checked=is_on("shares_range"),
        begins_part=True,
    )
    samples = Command(
        "document_samples",
        "&Document's samples",
        switching("document_samples"),
        "&View/St&yle",
        tip="Draw the samples themselves, all of them, with flat facets between them as MATLAB does",
        is_checked=is_on("document_samples"),
        begins_part=True,
    )
    return [*shown, samples, shared, probe]


def _view_commands() -> list[Command]:
    return [
        Command(
            "paper_look",
            "Paper loo&k",
            asking(PaperLookAsked()),
            "&View",
            "Ctrl+Shift+L",
            "Facets in MATLAB's jet from azimuth 36, elevation 64 degrees, as in the paper's figures",
            begins_part=True,
        ),
        Command(
            "copy_picture",
            "Copy p&icture",
            asking(CopyAsked("picture")),
            "&View",
            "Ctrl+Shift+I",
            "Put what the view shows on the clipboard, as a picture at the screen's resolution",
            begins_part=True,
        ),
        *underlay_commands(),
        Command(
            "restart_view",
            "Restart the vie&w",
            asking(ViewRestartAsked()),
            "&View",
            tip="Begin again with the drawing, and with OpenGL if it can be used by now",
        ),
    ]
