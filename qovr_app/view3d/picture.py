"""Everything one viewport draws in one frame, as a value: scene, settings, camera and marks."""

from __future__ import annotations

from dataclasses import dataclass

from qovr_app.view3d.camera import Camera, Margins, Size
from qovr_app.view3d.mesh import RESTING_LIMIT, Counts, display_counts
from qovr_app.view3d.scene import NetIndex, Scene
from qovr_app.view3d.settings import DisplaySettings, Style
from qovr_app.view3d.theme import Theme, theme_of

_BAR_ROOM = 104.0
_AXES_ROOM = 58.0
_BARE_ROOM = 28.0
_NARROW = 340.0
"""A viewport narrower than this in logical pixels has no room for a colour bar beside the surface."""


@dataclass(frozen=True, eq=False)
class Picture:
    """What is drawn.

    Parameters
    ----------
    scene : None before the first result
    vertex_limit : vertices a side of the display grid, fewer while something moves
    caption : a word in the corner that tells two viewports apart, or nothing
    """

    settings: DisplaySettings
    camera: Camera
    scene: Scene | None = None
    selected: NetIndex | None = None
    hovered: NetIndex | None = None
    vertex_limit: int = RESTING_LIMIT
    caption: str = ""

    @property
    def theme(self) -> Theme:
        return theme_of(self.settings.theme)

    @property
    def counts(self) -> Counts:
        """Vertices of the display grid along u and v."""
        if self.scene is None:
            return (2, 2)
        follow = self.settings.style in (Style.FACETS, Style.POINTS)
        return display_counts(self.scene.document.samples, self.vertex_limit, follow_samples=follow)


def has_colour_bar(settings: DisplaySettings, size: Size) -> bool:
    """Return whether a viewport of this size shows the colour bar."""
    return settings.colour_bar and settings.surface and size[0] >= _NARROW


def margins(settings: DisplaySettings, size: Size) -> Margins:
    """Return the room that a fitted picture leaves for labels and colour bar."""
    side = _AXES_ROOM if settings.axes else _BARE_ROOM
    right = _BAR_ROOM if has_colour_bar(settings, size) else side
    return Margins(left=side, top=_BARE_ROOM, right=right, bottom=side)
