"""Grids over a surface in windows: so many cells in each, and vertices of its own on all its edges.

So a crease stays sharp, and where windows do not meet there is no wall between them.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import lru_cache
from weakref import WeakKeyDictionary, ref

import numpy as np

from qovr_core.arrays import Array, Indices, read_only
from qovr_core.geometry.differential import ParametricSurface
from qovr_core.geometry.patch import Patch

Counts = tuple[int, int]
"""A number along u and one along v."""

Cells = tuple[int, ...]
"""How many cells each window has along one direction."""


@dataclass(frozen=True)
class Grid:
    """How many cells each window of a surface has along u, (n,), and along v, (m,).

    Where there are too many windows to be told apart, so many along u and along v are ``together`` one, of one cell.
    """

    u: Cells
    v: Cells
    together: Counts = (1, 1)

    def is_over(self, surface: ParametricSurface) -> bool:
        """Return whether it is a grid of a surface with these windows."""
        m, n = windows_of(surface)
        u, v = (-(-count // some) for count, some in zip((n, m), self.together, strict=True))
        return (len(self.u), len(self.v)) == (u, v)

    @property
    def cells(self) -> Counts:
        """All cells along u and along v."""
        return sum(self.u), sum(self.v)

    @property
    def shape(self) -> Counts:
        """All vertices along u and along v: those of each window after those of the one before."""
        return sum(self.u) + len(self.u), sum(self.v) + len(self.v)

    def over(self, surface: ParametricSurface) -> Grid:
        """Return the grid itself, or one as fine for a surface that has other windows."""
        return self if self.is_over(surface) else shared_grid(surface, self.cells)

    def within(self, most: Counts) -> Grid:
        """Return the grid with no more cells in all than so many, as far as every window keeps one."""
        u, v = (_within(cells, count) for cells, count in zip((self.u, self.v), most, strict=True))
        return replace(self, u=u, v=v)

    def fewer(self, most: int) -> Grid:
        """Return the grid with no more windows a side than so many: of more, some together are one."""
        (u, along_u), (v, along_v) = (
            _together(cells, some, most) for cells, some in zip((self.u, self.v), self.together, strict=True)
        )
        return Grid(u, v, (along_u, along_v))

    def common(self, other: Grid) -> Grid:
        """Return the coarser of it and a grid of all windows, window by window."""
        u, v = (
            cells if some > 1 else tuple(map(min, cells, others))
            for cells, others, some in zip((self.u, self.v), (other.u, other.v), self.together, strict=True)
        )
        return replace(self, u=u, v=v)

    def of_windows(self, along_v: slice, along_u: slice) -> Grid:
        """Return the grid of some windows."""
        return Grid(self.u[along_u], self.v[along_v])

    def vertices_of(self, along_v: slice, along_u: slice) -> tuple[slice, slice]:
        """Return which vertices along u and along v are those of some windows."""
        rows, columns = (
            slice(*window_starts(cells)[[along.start, along.stop]].tolist())
            for cells, along in ((self.u, along_u), (self.v, along_v))
        )
        return rows, columns


@lru_cache(maxsize=32)
def _within(cells: Cells, most: int) -> Cells:
    each = -(-most // len(cells))
    return tuple(min(count, each) for count in cells)


def _together(cells: Cells, already: int, most: int) -> tuple[Cells, int]:
    some = -(-len(cells) // most)
    return (cells, already) if some == 1 else ((1,) * -(-len(cells) // some), some * already)


def breakpoints_of(surface: ParametricSurface) -> tuple[Array, Array]:
    """Return where the windows of a surface begin and the last one ends, along u and along v.

    What is no patch is one window: how it is made is not shown.
    """
    if isinstance(surface, Patch):
        return surface.breakpoints
    u, v = (np.array(ends) for ends in surface.domain)
    return u, v


def windows_of(surface: ParametricSurface) -> tuple[int, int]:
    """Return how many windows a surface is drawn in along v and along u, (m, n)."""
    return surface.windows if isinstance(surface, Patch) else (1, 1)


Touched = tuple[slice, slice] | None
"""Windows along v and along u; None for most of them."""

_touched: WeakKeyDictionary[Patch, tuple[ref[Patch], Touched]] = WeakKeyDictionary()
"""What was found of patches last: several ask at every edit, and the patches of large nets are megabytes."""


def touched_windows(before: Patch, after: Patch) -> Touched:
    """Return the windows, along v and along u, in which alone two patches differ; None where these are the most."""
    known, found = _touched.get(after, (None, None))
    if known is None or known() is not before:
        found = _compared(before, after)
        _touched[after] = ref(before), found
    return found


def _compared(before: Patch, after: Patch) -> Touched:
    if before.windows != after.windows:
        return None
    touched = np.nonzero((before.coefficients != after.coefficients).any(axis=(2, 3, 4)))
    if not len(touched[0]):
        return slice(0, 0), slice(0, 0)
    along_v, along_u = (slice(int(each.min()), int(each.max()) + 1) for each in touched)
    is_most = 2 * part_of(after, along_v, along_u).coefficients.size > after.coefficients.size
    return None if is_most else (along_v, along_u)


def part_of(patch: Patch, along_v: slice, along_u: slice) -> Patch:
    """Return some windows of a patch, their parameters counted from 0."""
    lengths = None if patch.lengths is None else (patch.lengths[0][along_u], patch.lengths[1][along_v])
    return Patch(patch.coefficients[along_v, along_u], patch.degree, lengths)


def shared_grid(surface: ParametricSurface, cells: Counts) -> Grid:
    """Return a grid of at least so many cells in all, equally many in each window."""
    m, n = windows_of(surface)
    return Grid((-(-cells[0] // n),) * n, (-(-cells[1] // m),) * m)


def parameters(surface: ParametricSurface, grid: Grid) -> tuple[Array, Array]:
    """Return the parameters of the vertices along u and along v: even in every window.

    Those at a window's end are the last numbers before the next one, so that a surface that is asked there answers with
    the window's own tangents.
    """
    u, v = (
        _even(breakpoints.tobytes(), cells)
        for breakpoints, cells in zip(_drawn_breakpoints(surface, grid), (grid.u, grid.v), strict=True)
    )
    return u, v


def _drawn_breakpoints(surface: ParametricSurface, grid: Grid) -> list[Array]:
    """Return where the windows begin of which some are one, and where the last one ends."""
    return [
        np.append(breakpoints[:-1:some], breakpoints[-1])
        for breakpoints, some in zip(breakpoints_of(surface), grid.together, strict=True)
    ]


@lru_cache(maxsize=32)
def _even(breakpoints: bytes, cells: Cells) -> Array:
    starts = np.frombuffer(breakpoints)
    window, last = np.repeat(np.arange(len(cells)), np.add(cells, 1)), window_starts(cells)[1:-1] - 1
    even = starts[window] + places(cells) * np.diff(starts)[window]
    even[last] = np.nextafter(starts[1:-1], -np.inf)
    even[-1] = starts[-1]
    return read_only(even)


@lru_cache(maxsize=32)
def places(cells: Cells) -> Array:
    """Return where in its window each vertex lies, from 0 to 1."""
    return read_only(np.concatenate([np.linspace(0.0, 1.0, count + 1) for count in cells]))


@lru_cache(maxsize=32)
def window_starts(cells: Cells) -> Indices:
    """Return the number of each window's first vertex, and of all vertices, (windows + 1,)."""
    return read_only(np.concatenate([[0], np.cumsum(np.add(cells, 1))]))


@lru_cache(maxsize=32)
def cell_starts(cells: Cells) -> Indices:
    """Return the vertex at which each cell begins; it ends at the next one."""
    starts = np.ones(sum(cells) + len(cells), dtype=np.bool_)
    starts[window_starts(cells)[1:] - 1] = False
    return read_only(np.flatnonzero(starts))


def cell_corners(values: Array, grid: Grid) -> list[Array]:
    """Return what stands at the four corners of every cell, in their order around it.

    Parameters
    ----------
    values : (n, m, ...) at the vertices

    Returns
    -------
    four arrays (cells along u, cells along v, ...), the first of the corners at which the cells begin
    """
    u, v = cell_starts(grid.u), cell_starts(grid.v)
    return [values[np.ix_(u + on_u, v + on_v)] for on_u, on_v in ((0, 0), (1, 0), (1, 1), (0, 1))]


def spread(values: Array, coarse: Grid, fine: Grid) -> Array:
    """Return values at the vertices of one grid on a finer or an equal one, linear between them in every window.

    What lies beside a NaN is one, too.
    """
    for axis, (few, many) in enumerate(zip((coarse.u, coarse.v), (fine.u, fine.v), strict=True)):
        if few != many:
            lower, share = _between(few, many)
            part = np.expand_dims(share, 1 - axis)
            values = np.take(values, lower, axis) * (1 - part) + np.take(values, lower + 1, axis) * part
    return values


@lru_cache(maxsize=32)
def _between(few: Cells, many: Cells) -> tuple[Indices, Array]:
    """Return after which vertex of the few each of the many lies, and which part of the way to the next one."""
    lower, share = [], []
    for start, cells, count in zip(window_starts(few)[:-1].tolist(), few, many, strict=True):
        at = np.linspace(0.0, cells, count + 1)
        before = np.minimum(at.astype(np.intp), cells - 1)
        lower.append(start + before)
        share.append(at - before)
    return read_only(np.concatenate(lower)), read_only(np.concatenate(share))
