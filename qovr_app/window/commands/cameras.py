"""The commands that lead the camera: to directions, to what is selected, and back."""

from __future__ import annotations

from qovr_app.state.requests import CameraAsked, CameraMoved, CameraStep
from qovr_app.state.view_requests import ViewStoreAsked
from qovr_app.window.commands.command import Command, asking
from qovr_app.window.commands.switches import is_on, switching

CAMERAS: dict[str, tuple[str, str | None, str]] = {
    "paper": ("&Paper's view", "Ctrl+1", "Azimuth 36, elevation 64 degrees, as in the paper's figures"),
    "top": ("&Top", "Ctrl+2", "From above, as the paper's Figures 7 and 8b"),
    "bottom": ("&Bottom", None, "From below"),
    "front": ("Fr&ont", "Ctrl+3", "Along the y axis"),
    "rear": ("R&ear", None, "Against the y axis"),
    "left": ("&Left", None, "Along the x axis, from its low end"),
    "right": ("R&ight", "Ctrl+4", "Along the x axis"),
    "isometric": ("Iso&metric", None, "All three axes at equal angles"),
}


_CAMERA_MOVES: dict[str, tuple[CameraStep, str, str | None, str]] = {
    "fit_selection": (CameraStep.SELECTION, "Fit the &selection", "Shift+F", "Look at the selected points from near"),
    "camera_back": (CameraStep.BACK, "B&ack", "Ctrl+[", "Look from where you looked before"),
    "camera_forward": (CameraStep.FORWARD, "Forwar&d", "Ctrl+]", "Look from where you looked before going back"),
}


def camera_commands() -> list[Command]:
    """Return the commands that lead the camera."""
    menu = "&View/Ca&mera"
    fit = Command("fit", "&Fit", asking(CameraAsked("")), menu, "F", "Show the whole surface and net")
    named = [
        Command(
            f"camera_{name}",
            text,
            asking(CameraAsked(name)),
            menu,
            shortcut,
            tip,
            begins_part=name == next(iter(CAMERAS)),
        )
        for name, (text, shortcut, tip) in CAMERAS.items()
    ]
    moves = [
        Command(name, text, asking(CameraMoved(step)), menu, shortcut, tip, begins_part=name == "fit_selection")
        for name, (step, text, shortcut, tip) in _CAMERA_MOVES.items()
    ]
    follow = Command(
        "always_fits",
        "Al&ways fit",
        switching("always_fits"),
        menu,
        tip="Let axes and colours follow every edit, not only another document, formulation or layer",
        is_checked=is_on("always_fits"),
    )
    store = Command(
        "store_view",
        "Store t&his view…",
        asking(ViewStoreAsked()),
        menu,
        tip="Give where you look from a name, to look from there again in any document",
        begins_part=True,
    )
    return [fit, follow, *named, *moves, store]
