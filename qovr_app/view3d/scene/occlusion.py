"""Which marks the surface hides: a hidden-line test on the CPU, the same for screen, fallback and figures.

The surface is cut into blocks of cells. A mark is looked up among the blocks whose rectangle on the screen
holds it, then among their cells, and only the triangles of those cells are tested.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import lru_cache
from types import EllipsisType

import numpy as np
import numpy.typing as npt

from qovr_app.state.display import Style
from qovr_app.view3d.scene.camera import Camera, Size
from qovr_app.view3d.scene.grid import cell_corners
from qovr_app.view3d.scene.picture import Picture
from qovr_app.view3d.scene.scene import Scene
from qovr_core.arrays import Array, Flags, Indices, read_only

_CELLS = 36
"""Cells a side, at least: the hidden parts of lines then end within a pixel or two of where the drawn surface
begins."""

_IN_FRONT = 0.012
"""Unit lengths by which the surface must lie nearer than a mark to hide it: curves on the surface stay
visible."""


_AT_ONCE = 250
"""Marks that are looked up together: what is compared for them stays in the processor's cache."""

_LONG, _STEP = 64, 4
"""Marks in a row from which only every so many are looked up at first."""

_OPAQUE_STYLES = (Style.FACETS, Style.SMOOTH, Style.CLAY)


def hidden_by(picture: Picture, marks: Array, size: Size) -> Flags:
    """Return which marks (k, 3) the surface of a picture hides; nothing where one can look through it."""
    if not picture.settings.surface or picture.settings.style not in _OPAQUE_STYLES:
        return np.zeros(len(marks), dtype=bool)
    return occluder_of(picture, size).hidden(marks)


def occluder_of(picture: Picture, size: Size) -> Occluder:
    """Return what tells what the surface of a picture hides; while it is seen from there, the very same object."""
    view, cache = (picture.camera, size), picture.scene.cache
    known, found = cache.get(Occluder, (None, None))
    if known != view:
        found = Occluder(picture.scene, picture.camera, size)
        cache[Occluder] = view, found
    occluder: Occluder = found
    return occluder


def hidden_among(picture: Picture, marks: Sequence[Array], size: Size) -> list[Flags]:
    """Return which marks of several arrays (k, n, 3) the surface hides, (k, n) each.

    Of a long row of marks some are looked up, and those between them only where their ends differ.
    """
    if max(max(part.shape[:2]) for part in marks) <= _LONG:
        return _hidden_in_one(picture, marks, size)
    samples = [_Sampled(part.shape[:2]) for part in marks]
    coarse = _hidden_in_one(picture, [part[each.at] for part, each in zip(marks, samples, strict=True)], size)
    found = [each.spread(flags) for each, flags in zip(samples, coarse, strict=True)]
    open_marks = [part[differ] for part, (_, differ) in zip(marks, found, strict=True)]
    if any(map(len, open_marks)):
        for (flags, differ), more in zip(found, _hidden_in_one(picture, open_marks, size), strict=True):
            flags[differ] = more
    return [read_only(flags) for flags, _ in found]


def _hidden_in_one(picture: Picture, marks: Sequence[Array], size: Size) -> list[Flags]:
    """Return the same in one query: asking the surface what it hides costs about as much for one mark as for all."""
    shapes = [part.shape[:-1] for part in marks]
    flags = hidden_by(picture, np.concatenate([part.reshape(-1, 3) for part in marks]), size)
    ends = np.cumsum([math.prod(shape) for shape in shapes])[:-1]
    return [part.reshape(shape) for part, shape in zip(np.split(flags, ends), shapes, strict=True)]


class _Sampled:
    """A grid of marks of which some are looked up."""

    def __init__(self, shape: tuple[int, ...]) -> None:
        self._along = [_sampled(count) for count in shape]
        self.at = np.ix_(*(np.unique([lower, upper]) for lower, upper in self._along))

    def spread(self, flags: Flags) -> tuple[Flags, Flags]:
        """Return the flags of all marks as far as they are known, and which are not."""
        rows, columns = ([np.searchsorted(np.unique(ends), end) for end in ends] for ends in self._along)
        corners = [flags[np.ix_(row, column)] for row in rows for column in columns]
        return corners[0].copy(), np.logical_or.reduce([corner != corners[0] for corner in corners[1:]])


@lru_cache(maxsize=16)
def _sampled(count: int) -> npt.NDArray[np.intp]:
    """Return for each number below a count the sampled ones before and after it, (2, count)."""
    step = _STEP if count > _LONG else 1
    lower = np.arange(count) // step * step
    upper = np.minimum(np.where(np.arange(count) == lower, lower, lower + step), count - 1)
    return read_only(np.stack([lower, upper]))


class Occluder:
    """A surface as seen by a camera, ready to be asked what it hides."""

    def __init__(self, scene: Scene, camera: Camera, size: Size) -> None:
        mesh, grid = scene.mesh(_CELLS)
        self._camera, self._size = camera, size
        a, b, c, d = (_in_blocks(corner) for corner in cell_corners(_seen(mesh, camera, size), grid))
        self._corners = [a, b, c, d]
        self._cell_low = np.minimum(np.minimum(a, b), np.minimum(c, d))
        self._cell_high = np.maximum(np.maximum(a, b), np.maximum(c, d))
        self._low, self._high = self._cell_low.min(axis=2), self._cell_high.max(axis=2)

    def hidden(self, points: Array) -> Flags:
        """Return which points (k, 3) of the unit space lie behind the surface, (k,) bool."""
        marks = _seen(points, self._camera, self._size).T
        if len(points) <= _AT_ONCE:
            return read_only(self._hidden(marks))
        parts = np.array_split(marks, -(-len(points) // _AT_ONCE), axis=1)
        return read_only(np.concatenate([self._hidden(part) for part in parts]))

    def _hidden(self, marks: Array) -> Flags:
        """Return which marks, (3, k) as seen, lie behind the surface."""
        result = np.zeros(marks.shape[1], dtype=bool)
        mark, block = np.nonzero(_within(marks[..., None], self._low[:, None], self._high[:, None]))
        pair, cell = np.nonzero(_within(marks[:, mark, None], self._cell_low, self._cell_high, block))
        mark, block = mark[pair], block[pair]
        a, b, c, d = (corner[:, block, cell] for corner in self._corners)
        at = marks[:, mark]
        for triangle in ((a, b, c), (a, c, d)):
            result[mark[_covers(*triangle, at)]] = True
        return result


def _in_blocks(corners: Array) -> Array:
    """Return one corner of every cell, (n, m, 3), by coordinate and block, (3, blocks, cells of a block).

    There are about as many blocks as cells in one: the two levels then cost about the same. Coordinates are what NumPy
    compares far faster than rows of two or three. Where the last blocks are not full, the last cells are in them more
    than once.
    """
    sides = [round(math.sqrt(count)) for count in corners.shape[:2]]
    n, m = (-(-count // side) for count, side in zip(corners.shape, sides, strict=False))
    missing = [(0, -count % side) for count, side in zip(corners.shape, sides, strict=False)]
    if any(map(any, missing)):
        corners = np.pad(corners, (*missing, (0, 0)), mode="edge")
    blocks = corners.reshape(n, sides[0], m, sides[1], 3).transpose(4, 0, 2, 1, 3)
    return blocks.reshape(3, n * m, math.prod(sides))


def _within(at: Array, low: Array, high: Array, rows: Indices | EllipsisType = ...) -> Flags:
    """Return whether marks lie in rectangles on the screen and not certainly before what is in them.

    Of the rectangles some rows are taken, one coordinate after the other: together they would be most of the memory
    that a frame takes.
    """
    within: Flags = at[0] >= low[0][rows]
    within &= at[0] <= high[0][rows]
    within &= at[1] >= low[1][rows]
    within &= at[1] <= high[1][rows]
    within &= at[2] + _IN_FRONT < high[2][rows]
    return within


def _seen(points: Array, camera: Camera, size: Size) -> Array:
    """Return x, y in pixels and the distance in unit lengths toward the viewer, larger being nearer."""
    seen = camera.project(points, size)
    seen[..., 2] = points @ camera.axes[2]
    return seen


def _covers(a: Array, b: Array, c: Array, at: Array) -> Flags:
    """Return whether each triangle, corners (3, k), lies over its mark (3, k) on the screen, and nearer."""
    ab, ac, am = b - a, c - a, at - a
    area = ab[0] * ac[1] - ab[1] * ac[0]
    # A triangle seen edge on has no area; what is infinite or no number then lies inside nothing.
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        s = (am[0] * ac[1] - am[1] * ac[0]) / area
        t = (ab[0] * am[1] - ab[1] * am[0]) / area
        inside = (s >= 0) & (t >= 0) & (s + t <= 1)
        covers: Flags = inside & (s * ab[2] + t * ac[2] - am[2] > _IN_FRONT)
    return covers
