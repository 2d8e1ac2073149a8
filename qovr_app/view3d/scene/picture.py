"""Everything one viewport draws in one frame, as a value: scene, settings, camera and marks."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property

import numpy as np

from qovr_app.state.display import DisplaySettings, Style
from qovr_app.state.knot_in_hand import KnotInHand
from qovr_app.state.tools import ToolSettings
from qovr_app.style.theme import Theme, theme_of
from qovr_app.view3d.scene.camera import Camera, Margins, Size
from qovr_app.view3d.scene.colouring import Colouring, colouring_of
from qovr_app.view3d.scene.display_grid import facet_grid, sample_grid
from qovr_app.view3d.scene.grid import Grid, windows_of
from qovr_app.view3d.scene.hand import Hand
from qovr_app.view3d.scene.knot_handles import KnotHandle, handles_of, last_point
from qovr_app.view3d.scene.measuring import Spot
from qovr_app.view3d.scene.net_flags import flags_of, has_index
from qovr_app.view3d.scene.patterns import PATTERNS
from qovr_app.view3d.scene.probing import Parameters
from qovr_app.view3d.scene.scene import Scene
from qovr_core.arrays import Array
from qovr_core.document import NetIndex, Window

_BAR_ROOM = 104.0
_AXES_ROOM = 58.0
_TITLE_ROOM = 92.0
"""At the left, where the z axis carries numbers and a title side by side."""

_BARE_ROOM = 28.0
_USUAL_SIDE, _LARGEST = 900.0, 1.6
"""A viewport whose shorter side has more logical pixels than this is drawn with larger letters, up to so much."""

_NARROW = 340.0
"""A viewport narrower than this in logical pixels has no room for a colour bar beside the surface."""


@dataclass(frozen=True, eq=False)
class Picture:
    """What is drawn.

    Parameters
    ----------
    selected, last_selected, hovered, pending, refused : control points that are marked; what the scene's net has not is
        left, for the mouse still rests where a larger net was
    put_away : control points that are not shown
    moving : draw on a coarser grid, because the next frame is near
    probed : the parameters u and v of the point that is read off, or nothing
    caption : a word in the corner that tells two viewports apart, or nothing
    spots : the places between which is measured
    tools : what a hand does here
    hand : what is seen of it; None in figures
    curve : the knot that is turned to, whose curve has handles; None for none
    window : the window of a net that is outlined; None for none
    """

    settings: DisplaySettings
    camera: Camera
    scene: Scene
    selected: frozenset[NetIndex] = frozenset()
    last_selected: NetIndex | None = None
    hovered: NetIndex | None = None
    pending: frozenset[NetIndex] = frozenset()
    refused: frozenset[NetIndex] = frozenset()
    put_away: frozenset[NetIndex] = frozenset()
    moving: bool = False
    probed: Parameters | None = None
    caption: str = ""
    spots: tuple[Spot, ...] = ()
    tools: ToolSettings = field(default_factory=ToolSettings)
    hand: Hand | None = None
    curve: KnotInHand | None = None
    window: Window | None = None

    def __post_init__(self) -> None:
        for name in ("last_selected", "hovered"):
            index = getattr(self, name)
            if index is not None and not has_index(self.scene.net_shape, index):
                object.__setattr__(self, name, None)

    @property
    def theme(self) -> Theme:
        """The colours of everything but the surface."""
        return theme_of(self.settings.theme)

    @property
    def has_gizmo(self) -> bool:
        """Whether a hand finds a gizmo at the point that was selected last."""
        return self.hand is not None and self.settings.control_points and self.last_selected is not None

    @cached_property
    def knot_handles(self) -> list[KnotHandle]:
        """The handles that a hand finds: none in figures, and none of a surface that has no such knots."""
        curve, scene = self.curve, self.scene
        if self.hand is None or curve is None or not self.settings.knot_handles or scene.is_comparison:
            return []
        if not has_index(scene.net_shape, last_point(curve.place)):
            return []
        return handles_of(curve, scene.document.control_points, scene.frame)

    @property
    def net_points(self) -> Array:
        """The control points in the unit space, (k, l, 3); not numbers where one is put away."""
        points = self.scene.points
        if not self.put_away:
            return points
        return np.where(flags_of(self.put_away, self.scene.net_shape)[..., None], np.nan, points)

    @property
    def leaves_frame(self) -> bool:
        """Whether something of the surface or its net lies outside the axes."""
        return self.scene.leaves_frame

    @property
    def grid(self) -> Grid:
        """The grid on which the surface is drawn."""
        if self.settings.document_samples:
            return sample_grid(self.scene.patch, self.scene.document.samples)
        return self.scene.grid(self.settings.style, moving=self.moving)

    @property
    def has_facets(self) -> bool:
        """Whether every cell has one colour, that of its first corner."""
        is_flat = self.settings.style is Style.FACETS or self.settings.document_samples
        return is_flat and self.settings.shown_colours not in PATTERNS

    @property
    def facets(self) -> Grid:
        """The grid of the facets, where there are some."""
        if self.settings.document_samples:
            return self.grid
        return facet_grid(self.scene.patch, self.scene.document.samples)

    @property
    def lined_grid(self) -> Grid:
        """The grid among whose cells parameter lines are counted: the samples', or in a net the facets'."""
        if self.has_facets and windows_of(self.scene.patch) != (1, 1):
            return self.facets
        return sample_grid(self.scene.patch, self.scene.document.samples)

    @property
    def coloured_grid(self) -> Grid:
        """The grid on which colours are given."""
        return self.facets if self.has_facets else self.grid

    @property
    def colouring(self) -> Colouring:
        """What the colours say."""
        return colouring_of(self.scene, self.settings, self.coloured_grid, moving=self.moving)


def emphasis(size: Size) -> float:
    """Return how much larger letters, discs and colour bar are in a viewport of this size than in a usual one."""
    return min(max(min(size) / _USUAL_SIDE, 1.0), _LARGEST)


def has_colour_bar(settings: DisplaySettings, size: Size) -> bool:
    """Return whether a viewport of this size shows the colour bar."""
    pattern = PATTERNS.get(settings.shown_colours)
    has_colours = settings.surface and (pattern is None or pattern.bar != ())
    return settings.colour_bar and has_colours and size[0] >= _NARROW


def is_in_colour_bar(settings: DisplaySettings, size: Size, x: float) -> bool:
    """Return whether a pixel of a viewport belongs to the colour bar and its numbers."""
    return has_colour_bar(settings, size) and x >= size[0] - _BAR_ROOM * emphasis(size)


def margins(settings: DisplaySettings, size: Size) -> Margins:
    """Return the room that a fitted picture leaves for labels and colour bar."""
    larger = emphasis(size)
    side = larger * (_AXES_ROOM if settings.axes else _BARE_ROOM)
    left = larger * (_TITLE_ROOM if settings.axes else _BARE_ROOM)
    right = larger * _BAR_ROOM if has_colour_bar(settings, size) else side
    return Margins(left=left, top=larger * _BARE_ROOM, right=right, bottom=side)


def is_stacked(size: Size, count: int) -> bool:
    """Return whether several viewports that share this size show more of a surface one above the other than in a row,
    with everything that stands around it."""
    across, down = _TITLE_ROOM + _BAR_ROOM, _BARE_ROOM + _AXES_ROOM
    in_a_row = min(size[0] / count - across, size[1] - down)
    return count > 1 and min(size[0] - across, size[1] / count - down) > in_a_row
