"""How buttons of the mouse move the camera: one table of the habits of other programs."""

from __future__ import annotations

from collections.abc import Mapping
from enum import StrEnum

from PySide6.QtCore import Qt

from qovr_app.state.display import MouseScheme

_LEFT, _MIDDLE, _RIGHT = Qt.MouseButton.LeftButton, Qt.MouseButton.MiddleButton, Qt.MouseButton.RightButton
_ALONE, _SHIFT = Qt.KeyboardModifier.NoModifier, Qt.KeyboardModifier.ShiftModifier
_CONTROL = Qt.KeyboardModifier.ControlModifier


class Motion(StrEnum):
    """What a drag does to the camera."""

    ORBIT = "orbit"
    PAN = "pan"


_Drag = tuple[Qt.MouseButton, Qt.KeyboardModifier]

_ALL_SCHEMES: Mapping[_Drag, Motion] = {
    (_LEFT, _ALONE): Motion.ORBIT,
    (_LEFT, _SHIFT): Motion.PAN,
    (_MIDDLE, _ALONE): Motion.ORBIT,
    (_RIGHT, _ALONE): Motion.PAN,
}
"""What holds where a scheme says nothing else; Alt with the left button stays free for the window manager."""

_SCHEMES: Mapping[MouseScheme, Mapping[_Drag, Motion]] = {
    MouseScheme.RHINO: {
        (_RIGHT, _ALONE): Motion.ORBIT,
        (_RIGHT, _SHIFT): Motion.PAN,
        (_MIDDLE, _ALONE): Motion.PAN,
    },
    MouseScheme.BLENDER: {(_MIDDLE, _SHIFT): Motion.PAN},
    MouseScheme.CAD: {(_MIDDLE, _CONTROL): Motion.PAN},
}


def motion_of(scheme: MouseScheme, button: Qt.MouseButton, modifiers: Qt.KeyboardModifier) -> Motion | None:
    """Return what a drag with a button does to the camera; None where it does nothing."""
    drags = {**_ALL_SCHEMES, **_SCHEMES[scheme]}
    held = modifiers & (_SHIFT | _CONTROL | Qt.KeyboardModifier.AltModifier)
    return drags.get((button, held))
