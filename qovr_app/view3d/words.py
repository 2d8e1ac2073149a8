"""What the view says in words and numbers, for dialogs and the clipboard."""

from __future__ import annotations

import math

from qovr_app.view3d.painter.readout import readout_text
from qovr_app.view3d.scene.measuring import measure_text, measured
from qovr_app.view3d.scene.picture import Picture
from qovr_app.view3d.scene.probing import reading_at
from qovr_core.fields import Range


def probe_words(picture: Picture | None) -> str:
    """Return what the probe says of the place that a picture marks; empty where it marks none."""
    if picture is None or picture.probed is None:
        return ""
    return readout_text(reading_at(picture.scene, picture.probed, picture.settings.colour_by))


def measure_words(picture: Picture | None) -> str:
    """Return what is measured in a picture; empty where nothing is."""
    return "" if picture is None else measure_text(measured(picture.scene, picture.spots))


def colour_words(picture: Picture | None) -> tuple[str, Range]:
    """Return what the colours say, and the values at their ends; not numbers where there are none."""
    return ("", (math.nan, math.nan)) if picture is None else (picture.colouring.title, picture.colouring.limits)
