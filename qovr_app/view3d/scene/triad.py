"""The axes in the corner of the view: where they point, and from where one looks who clicks on one."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from qovr_app.state.display import DisplaySettings
from qovr_app.view3d.scene.camera import Camera, Size
from qovr_core.arrays import Array
from qovr_core.cameras import NAMED_VIEWS

VIEWS = (("left", "right"), ("front", "rear"), ("bottom", "top"))
"""By axis, the views from its low end and from its high one."""

LENGTH, HIGH_RADIUS, LOW_RADIUS = 29.0, 8.5, 6.0
"""Logical pixels from the middle to the ends, and of the discs there."""

REACH = LENGTH + HIGH_RADIUS + 4.0
_CORNER = 8.0
_LEAST_SIDE = 300.0
"""Logical pixels of a viewport below which the triad would be in the way."""

_ALIGNED = 1e-9


@dataclass(frozen=True, eq=False)
class End:
    """One end of an axis as it is seen.

    Parameters
    ----------
    axis, is_high : which
    at : (2,) logical pixels
    depth : toward the viewer, from -1 to 1
    """

    axis: int
    is_high: bool
    at: Array
    depth: float

    @property
    def view(self) -> str:
        """From where one looks at it."""
        return VIEWS[self.axis][self.is_high]

    @property
    def radius(self) -> float:
        """Of its disc, in logical pixels."""
        return end_radius(is_high=self.is_high)


def end_radius(*, is_high: bool) -> float:
    """Return the radius of an end's disc, in logical pixels."""
    return HIGH_RADIUS if is_high else LOW_RADIUS


def has_triad(settings: DisplaySettings, size: Size) -> bool:
    """Return whether a viewport has room for the triad, and is to show it."""
    return settings.triad and min(size) >= _LEAST_SIDE


def triad_centre(size: Size) -> tuple[float, float]:
    """Return the middle of the triad in logical pixels."""
    return _CORNER + REACH, size[1] - _CORNER - REACH


def triad_ends(camera: Camera, centre: tuple[float, float]) -> list[End]:
    """Return the six ends about the middle of the triad, the farthest from the viewer first."""
    right, up, back = camera.axes
    ends = [
        End(axis, is_high, centre + LENGTH * way * np.array([right[axis], -up[axis]]), way * back[axis])
        for axis in range(3)
        for is_high, way in ((False, -1), (True, 1))
    ]
    return sorted(ends, key=lambda end: end.depth)


def view_under(settings: DisplaySettings, camera: Camera, size: Size, x: float, y: float) -> str:
    """Return the named view that a click at a pixel asks for; empty beside the ends.

    Whoever looks from there already is led to the other side.
    """
    if not has_triad(settings, size):
        return ""
    for end in reversed(triad_ends(camera, triad_centre(size))):
        if np.hypot(*(end.at - (x, y))) <= end.radius + 1:
            azimuth, elevation = NAMED_VIEWS[end.view]
            looks_from_there = abs(camera.elevation - elevation) < _ALIGNED and (
                end.axis == 2 or abs((camera.azimuth - azimuth + 180) % 360 - 180) < _ALIGNED
            )
            return VIEWS[end.axis][not end.is_high] if looks_from_there else end.view
    return ""
