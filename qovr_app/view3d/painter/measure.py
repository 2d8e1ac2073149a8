"""What is measured, over the picture: the places, lines between them, and a line of numbers."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from qovr_app.state.names import AXES
from qovr_app.view3d.painter.note import plate
from qovr_app.view3d.painter.text import NORMAL, lettered, plain, text_size
from qovr_app.view3d.scene.camera import Size
from qovr_app.view3d.scene.marks import Box, Cap, Discs, Ink, Lines, Mark, Pen
from qovr_app.view3d.scene.measuring import Measure, measured
from qovr_app.view3d.scene.picture import Picture
from qovr_core.number_texts import USUAL_DIGITS, rounded_text

_RADIUS, _PAD, _LEADING, _BOTTOM = 5.0, 8.0, 18.0, 30.0

FIRST, SECOND = "Click a control point or the surface to measure from", "Click where to measure to"


def measure(picture: Picture, size: Size) -> Iterator[Mark]:
    """Yield what is measured while the tool for it is in the hand; a figure has it where something is measured."""
    if not picture.tools.measures or (picture.hand is None and len(picture.spots) < 2):
        return
    theme, scene = picture.theme, picture.scene
    seen = [picture.camera.project(scene.frame.to_unit(spot.place(scene)), size)[:2].tolist() for spot in picture.spots]
    places = np.array([at for at in seen if math.isfinite(at[0])]).reshape(-1, 2)
    for colour, width in ((theme.rim, 3.6), (theme.ink, 1.6)):
        pen = Pen(Ink(colour), width, Cap.ROUND)
        yield Lines(np.stack([places[:-1], places[1:]], axis=1), pen)
        yield Discs(places, _RADIUS, pen, Ink(theme.rim))
    lines = _lines(measured(scene, picture.spots))
    width = max(text_size(plain(line), NORMAL)[0] for line in lines) + 2 * _PAD
    height = _LEADING * len(lines) + _PAD
    left, top = round((size[0] - width) / 2), size[1] - _BOTTOM - height
    yield plate(Box(left, top, width, height), theme)
    for k, line in enumerate(lines):
        at = left + _PAD, top + _PAD / 2 + (k + 0.5) * _LEADING
        yield lettered(plain(line), at, (0, 0.5), theme.ink, pixels=NORMAL)


def _lines(measure: Measure) -> list[str]:
    """Return what is said: what to do next, or the distances and the angle."""
    if not measure.ways:
        return [f"{measure.names[0]}: {SECOND}" if measure.names else FIRST]
    lines = [
        f"{a} to {b}:  {rounded_text(length, USUAL_DIGITS)}   ("
        + "  ".join(f"{axis} {rounded_text(value, USUAL_DIGITS)}" for axis, value in zip(AXES, way, strict=True))
        + ")"
        for a, b, length, way in zip(measure.names, measure.names[1:], measure.lengths, measure.ways, strict=False)
    ]
    if measure.angle is not None:
        lines.append(f"angle at {measure.names[1]}:  {rounded_text(measure.angle, USUAL_DIGITS)}°")
    return lines
