"""Which marks the surface hides: a hidden-line test on the CPU, the same for screen, fallback and figures.

The surface is cut into blocks of cells. A mark is looked up among the blocks whose rectangle on the screen
holds it, then among their cells, and only the triangles of those cells are tested.
"""

from __future__ import annotations

import numpy as np

from qovr_app.view3d.camera import Camera, Size
from qovr_app.view3d.mesh import surface_vertices
from qovr_core.arrays import Array, read_only
from qovr_core.patch import Patch

_CELLS = 48
"""Cells a side: the hidden parts of lines then end within a pixel or two of where the drawn surface
begins."""

_BLOCK = 6
"""Cells a side of a block; the two levels then cost about the same."""

_IN_FRONT = 0.012
"""Unit lengths by which the surface must lie nearer than a mark to hide it: curves on the surface stay
visible."""


class Occluder:
    """A patch as seen by a camera, ready to be asked what it hides."""

    def __init__(self, patch: Patch, camera: Camera, size: Size) -> None:
        mesh = surface_vertices(patch, (_CELLS + 1, _CELLS + 1))[..., :3].astype(np.float64)
        self._camera, self._size = camera, size
        self._seen = _seen(mesh, camera, size)
        corners = np.stack(
            [self._seen[:-1, :-1], self._seen[1:, :-1], self._seen[1:, 1:], self._seen[:-1, 1:]]
        )
        blocks = _CELLS // _BLOCK
        self._corners = (
            corners.reshape(4, blocks, _BLOCK, blocks, _BLOCK, 3)
            .transpose(1, 3, 2, 4, 0, 5)
            .reshape(blocks * blocks, _BLOCK * _BLOCK, 4, 3)
        )
        self._cell_low, self._cell_high = (
            self._corners[..., :2].min(axis=2),
            self._corners[..., :2].max(axis=2),
        )
        self._low, self._high = self._cell_low.min(axis=1), self._cell_high.max(axis=1)

    def hidden(self, points: Array) -> Array:
        """Return which points (k, 3) of the unit space lie behind the surface, (k,) bool."""
        result = np.zeros(len(points), dtype=bool)
        marks = _seen(points, self._camera, self._size)
        at = marks[:, None, :2]
        mark, block = np.nonzero(((at >= self._low) & (at <= self._high)).all(axis=2))
        at = marks[mark, None, :2]
        pair, cell = np.nonzero(((at >= self._cell_low[block]) & (at <= self._cell_high[block])).all(axis=2))
        mark, quads = mark[pair], self._corners[block[pair], cell]
        for triangle in ((0, 1, 2), (0, 2, 3)):
            nearer = _covers(quads[:, triangle], marks[mark], _IN_FRONT)
            result[mark[nearer]] = True
        return read_only(result)


def _seen(points: Array, camera: Camera, size: Size) -> Array:
    """Return x, y in pixels and the distance in unit lengths along the line of sight, larger being nearer."""
    seen = camera.project(points, size)
    seen[..., 2] = points @ camera.axes[2]
    return seen


def _covers(triangles: Array, marks: Array, margin: float) -> Array:
    """Return whether each triangle (k, 3, 3) lies over its mark (k, 3) on the screen and nearer by a
    margin."""
    a, b, c = triangles[:, 0], triangles[:, 1], triangles[:, 2]
    ab, ac, am = b - a, c - a, marks - a
    area = ab[:, 0] * ac[:, 1] - ab[:, 1] * ac[:, 0]
    with np.errstate(divide="ignore", invalid="ignore"):
        s = (am[:, 0] * ac[:, 1] - am[:, 1] * ac[:, 0]) / area
        t = (ab[:, 0] * am[:, 1] - ab[:, 1] * am[:, 0]) / area
    inside = (s >= 0) & (t >= 0) & (s + t <= 1)
    return inside & (s * ab[:, 2] + t * ac[:, 2] - am[:, 2] > margin)
