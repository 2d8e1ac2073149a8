"""The joints between the windows of a net, and the outline of one window, as lines on the surface."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from qovr_app.view3d.scene.curve_lines import curve_points, pieces_in_window
from qovr_app.view3d.scene.grid import windows_of
from qovr_app.view3d.scene.scene import CURVE_PIECES, Scene
from qovr_core.arrays import Array, read_only
from qovr_core.document import Window
from qovr_core.geometry.edges import Edge
from qovr_core.geometry.knots import Direction
from qovr_core.geometry.patch import Patch


@dataclass(frozen=True, eq=False)
class JointLines:
    """Where the windows of a surface meet, in the unit space.

    Parameters
    ----------
    smooth, sharp : polylines of one length each, along v for joints that the row curves cross, else along u; where
        windows do not meet along whole curves, both their edges
    """

    smooth: tuple[Array, ...]
    sharp: tuple[Array, ...]


def joint_lines(scene: Scene) -> JointLines:
    """Return the joints of a scene's surface; computed once, and none of a surface that is one window."""
    if JointLines not in scene.cache:
        scene.cache[JointLines] = _made(scene)
    found: JointLines = scene.cache[JointLines]
    return found


def _made(scene: Scene) -> JointLines:
    smooth: list[Array] = []
    sharp: list[Array] = []
    patch, document = scene.patch, scene.evaluation.document
    if isinstance(patch, Patch) and has_windows(scene):
        for direction in Direction:
            is_smooth = document.joints.smooth(direction)
            lines = _crossed(patch, direction, both=not document.formulation.is_continuous)
            for flags, found in ((is_smooth, smooth), (~is_smooth, sharp)):
                numbers = np.flatnonzero(flags)
                if len(numbers):
                    found.append(read_only(lines[numbers].reshape(-1, *lines.shape[2:])))
    return JointLines(tuple(smooth), tuple(sharp))


def _crossed(patch: Patch, direction: Direction, *, both: bool) -> Array:
    """Return the joints that the curves of a direction cross, (joints, k, n, 3), the seam of a closed net last.

    Each is one line through all windows along it, or both edges of every window, which do not meet.
    """
    first, last = (Edge.U0, Edge.U1) if direction is Direction.ROWS else (Edge.V0, Edge.V1)
    coefficients = patch.coefficients if direction is Direction.ROWS else patch.coefficients.swapaxes(0, 1)
    ends = [coefficients[(slice(None), slice(None), *edge.position)].swapaxes(0, 1) for edge in (last, first)]
    before, after = ends[0], np.roll(ends[1], -1, axis=0)
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
