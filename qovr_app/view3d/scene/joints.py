"""The joints between the windows of a net, and the outline of one window, as lines on the surface."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from qovr_app.view3d.scene.curve_lines import curve_points, pieces_in_window
from qovr_app.view3d.scene.grid import windows_of
from qovr_app.view3d.scene.scene import CURVE_PIECES, Scene
from qovr_core.arrays import Array, Flags, Indices, read_only
from qovr_core.document import Window
from qovr_core.geometry.differential import ParametricSurface
from qovr_core.geometry.edges import Edge
from qovr_core.geometry.knots import Direction
from qovr_core.geometry.patch import Patch


@dataclass(frozen=True, eq=False)
class JointLines:
    """Where the windows of a surface meet, in the unit space; each kind is computed when it is asked for.

    Parameters
    ----------
    patch : in the unit space
    are_smooth : of each direction, which joints that its curves cross are smooth
    is_continuous : whether windows meet along whole curves; where they do not, both their edges are lines
    """

    patch: ParametricSurface
    are_smooth: dict[Direction, Flags]
    is_continuous: bool

    @cached_property
    def smooth(self) -> tuple[Array, ...]:
        """Polylines of one length each, (k, n, 3): along v for joints that the row curves cross, then along u."""
        return self._lines(self.are_smooth)

    @cached_property
    def sharp(self) -> tuple[Array, ...]:
        """Polylines likewise."""
        return self._lines({direction: ~flags for direction, flags in self.are_smooth.items()})

    def _lines(self, flags: dict[Direction, Flags]) -> tuple[Array, ...]:
        if not isinstance(self.patch, Patch):
            return ()
        numbers = {direction: np.flatnonzero(wanted) for direction, wanted in flags.items()}
        lines = (
            _crossed(self.patch, direction, some, both=not self.is_continuous)
            for direction, some in numbers.items()
            if len(some)
        )
        return tuple(read_only(each.reshape(-1, *each.shape[2:])) for each in lines)


def joint_lines(scene: Scene) -> JointLines:
    """Return the joints of a scene's surface; computed once, and none of a surface that is one window."""
    if JointLines not in scene.cache:
        document = scene.evaluation.document
        are_smooth = {direction: document.joints.smooth(direction) for direction in Direction if has_windows(scene)}
        scene.cache[JointLines] = JointLines(scene.patch, are_smooth, document.formulation.is_continuous)
    found: JointLines = scene.cache[JointLines]
    return found


def _crossed(patch: Patch, direction: Direction, numbers: Indices, *, both: bool) -> Array:
    """Return some joints that the curves of a direction cross, (joints, k, n, 3), the seam of a closed net last.

    Each is one line through all windows along it, or both edges of every window, which do not meet.
    """
    first, last = (Edge.U0, Edge.U1) if direction is Direction.ROWS else (Edge.V0, Edge.V1)
    coefficients = patch.coefficients if direction is Direction.ROWS else patch.coefficients.swapaxes(0, 1)
    before, after = (
        coefficients[(slice(None), slice(None), *edge.position)][:, some].swapaxes(0, 1)
        for some, edge in ((numbers, last), ((numbers + 1) % coefficients.shape[1], first))
    )
    lines = np.stack([before, after], axis=1)[..., None, :, :] if both else before[:, None, None]
    pieces = pieces_in_window(before.shape[1], CURVE_PIECES) if both else CURVE_PIECES
    points = curve_points(lines.reshape(-1, *lines.shape[-3:]), pieces)
    return points.reshape(len(before), -1, *points.shape[1:])


def outline(scene: Scene, window: Window) -> Array:
    """Return the outline of a window, (4, n, 3) in the unit space; (0, 2, 3) where there is no such window."""
    patch = scene.patch
    if not isinstance(patch, Patch) or not np.all(np.less(window, patch.windows)):
        return np.empty((0, 2, 3))
    one = patch.window(*window)
    return read_only(curve_points(np.stack([one.edge(edge) for edge in Edge]), CURVE_PIECES))


def has_windows(scene: Scene) -> bool:
    """Return whether a scene shows the windows of a net: more than one."""
    return windows_of(scene.patch) != (1, 1) and not scene.is_comparison
