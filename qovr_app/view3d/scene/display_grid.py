"""How fine a surface is drawn: fine enough for its windows as they are seen, and no finer than facets are to be."""

from __future__ import annotations

from functools import lru_cache

import numpy as np

from qovr_app.state.display import Style
from qovr_app.view3d.scene.grid import Cells, Counts, Grid, windows_of
from qovr_core.arrays import Array
from qovr_core.geometry.differential import ParametricSurface
from qovr_core.geometry.locate import spread
from qovr_core.geometry.patch import PATCH_DEGREE, Patch

MOVING_LIMIT, MOVING_POINTS = 48, 100
"""Cells a side of one window while something moves. With exact normals, lines and facets that need no vertices, finer
ones look the same; where each vertex is seen, as a point, the paper's 101 are."""

RESTING_LIMIT = 200
"""Cells a side of one window at rest: silhouettes stay round in a large window and in figures."""

_LEAST = 4
"""Cells a side of a window of a net at rest, however small it is, and of facets that are too many to be told apart."""

_TOGETHER = 2.5
"""A net that is folded over and over is drawn by so many times the cells of one window each way, no more."""

_MOVING_WINDOWS = 64
"""Windows a side of a net, of which more are some together one cell while something moves."""

_MOVING_CELL, _MOVING_POINT, _RESTING_CELL = 1 / 25, 1 / 50, 1 / 75
"""Unit lengths of the mean cell in a window of a net: the axes box, 2 across, then has about as many as one window."""

_LONGEST_CELL = 1 / 36
"""Unit lengths of the longest cell at rest: 8 pixels where the whole is fitted into a view 1100 pixels high."""


_STEPS = np.array([1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64, 96, 128, 192, 256])
"""Numbers of cells of a window."""


def display_grid(surface: ParametricSurface, samples: Counts, style: Style, *, moving: bool) -> Grid:
    """Return the display grid of a surface of the unit space; coarse facets and points stay coarse.

    Parameters
    ----------
    samples : of the document, along u and along v
    """
    if not isinstance(surface, Patch) or surface.windows == (1, 1):
        limit = MOVING_LIMIT if moving else RESTING_LIMIT
        if style is Style.POINTS and moving:
            limit = MOVING_POINTS
        grid = Grid((limit,), (limit,))
    else:
        grid = _grid_of_net(surface, style, moving=moving)
    if style in (Style.FACETS, Style.POINTS):
        return grid.common(sample_grid(surface, samples))
    return grid


def sample_grid(surface: ParametricSurface, samples: Counts) -> Grid:
    """Return the grid whose vertices are the document's samples."""
    m, n = windows_of(surface)
    return Grid(_sampled(samples[0], n), _sampled(samples[1], m))


@lru_cache(maxsize=32)
def _sampled(samples: int, windows: int) -> Cells:
    return tuple(spread(samples, windows).tolist())


def facet_grid(surface: ParametricSurface, samples: Counts) -> Grid:
    """Return the grid of facets: the samples', as far as facets can be told apart."""
    m, n = windows_of(surface)
    most = (max(RESTING_LIMIT, _LEAST * n), max(RESTING_LIMIT, _LEAST * m))
    return sample_grid(surface, samples).within(most)


def _grid_of_net(surface: Patch, style: Style, *, moving: bool) -> Grid:
    """Return a grid whose cells are short in every window, and fewer where the windows are small."""
    if moving:
        cell = _MOVING_POINT if style is Style.POINTS else _MOVING_CELL
        u, v = (_cells(extents / cell, 1, MOVING_LIMIT, is_below=True) for extents in _extents(surface))
        return Grid(u, v).fewer(_MOVING_WINDOWS)
    u, v = (
        _cells(np.maximum(extents / _RESTING_CELL, speeds / _LONGEST_CELL), _LEAST, RESTING_LIMIT, is_below=False)
        for extents, speeds in zip(_extents(surface), _speeds(surface), strict=True)
    )
    return Grid(u, v)


def _cells(wanted: Array, least: int, most: int, *, is_below: bool) -> Cells:
    """Return numbers of cells, in steps, so that few of them change while a surface is edited.

    Parameters
    ----------
    wanted : (k,) of the windows along one direction
    least, most : of one window; all together are about ``_TOGETHER`` times as many as the latter at most
    is_below : whether they are the steps below what is wanted, or those above
    """
    wanted = np.minimum(wanted, most)
    wanted = np.maximum(wanted * min(1.0, _TOGETHER * most / float(wanted.sum())), 1.0)
    number = np.searchsorted(_STEPS, wanted, side="right") - 1 if is_below else np.searchsorted(_STEPS, wanted)
    return tuple(np.clip(_STEPS[number], least, most).tolist())


def _extents(surface: Patch) -> tuple[Array, Array]:
    """Return how long the windows are, at most, along u, (n,), and along v, (m,): by a few of their coefficients."""
    few = surface.coefficients[:, :, ::3, ::3]
    along_u, along_v = (np.linalg.norm(np.diff(few, axis=axis), axis=-1).sum(axis=axis) for axis in (2, 3))
    return along_u.max(axis=(0, 2)), along_v.max(axis=(1, 2))


def _speeds(surface: Patch) -> tuple[Array, Array]:
    """Return how long the parts of the windows are at most, as many as would make a window, likewise."""
    along_u, along_v = (
        PATCH_DEGREE * np.sqrt((np.diff(surface.coefficients, axis=axis) ** 2).sum(axis=-1).max(axis=(2, 3)))
        for axis in (2, 3)
    )
    return along_u.max(axis=0), along_v.max(axis=1)
