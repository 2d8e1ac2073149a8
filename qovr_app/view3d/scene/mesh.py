"""The vertices and triangles of a surface, at a resolution that is the view's own affair."""

from __future__ import annotations

import math
from functools import lru_cache

import numpy as np
import numpy.typing as npt

from qovr_app.view3d.scene.frame import FARTHEST
from qovr_app.view3d.scene.grid import Grid, cell_starts, parameters, part_of, touched_windows, window_starts
from qovr_core.arrays import Array, read_only
from qovr_core.geometry.bernstein import basis
from qovr_core.geometry.differential import ParametricSurface
from qovr_core.geometry.patch import PATCH_DEGREE, Patch

FloatArray = npt.NDArray[np.float32]

_SINGULAR = 1e-12
"""Squared length of S_u x S_v, in unit space, below which single precision no longer knows its direction; by the
parameters of one window, which are longer where there are many."""

CORNERS = 6
"""Corners of the two triangles of a cell."""

_KEPT = 2**18
"""Cells up to which triangles are kept for pictures to come: display grids change at every rest, larger ones do not."""


@lru_cache(maxsize=64)
def _bases(count: int) -> tuple[FloatArray, FloatArray]:
    """Return the Bernstein polynomials and their derivatives at ``count`` even parameters, each (count, 7)."""
    t = np.linspace(0.0, 1.0, count)
    values = basis(PATCH_DEGREE, t)
    lower = PATCH_DEGREE * basis(PATCH_DEGREE - 1, t)
    slopes = np.pad(lower, ((0, 0), (1, 0))) - np.pad(lower, ((0, 0), (0, 1)))
    return read_only(values.astype(np.float32)), read_only(slopes.astype(np.float32))


def surface_vertices(surface: ParametricSurface, grid: Grid, out: FloatArray | None = None) -> FloatArray:
    """Return positions and exact normals of a surface in unit space.

    The normals are those of the surface as it is shown, scaled to the axes box, and not of unit length: the
    shaders normalise them anyway. On the edges of a window they are the window's own.

    Parameters
    ----------
    out : where they are written, (n, m, 6) float32; None for a new array, which is read-only

    Returns
    -------
    (n, m, 6) float32: x, y, z, none of them beyond ``FARTHEST``, and the normal, indexed [iu, iv]
    """
    vertices = np.empty((*grid.shape, 6), dtype=np.float32) if out is None else out
    if isinstance(surface, Patch) and _is_in_sight(surface.coefficients):
        _write_vertices(_drawn(surface, grid), grid, vertices)
    else:
        u, v = parameters(surface, grid)
        vertices[..., :3] = np.clip(surface.points(u, v), -FARTHEST, FARTHEST)
        vertices[..., 3:] = surface.normals(u, v)
    return read_only(vertices) if out is None else out


def revised_vertices(
    vertices: FloatArray, before: ParametricSurface, after: ParametricSurface, grid: Grid
) -> tuple[FloatArray, slice]:
    """Return the vertices of a surface by those of another on the same grid, from which it may differ in few windows.

    Returns
    -------
    the vertices, as of ``surface_vertices``, and the rows, along u, that are not what they were
    """
    if not isinstance(before, Patch) or not isinstance(after, Patch):
        return surface_vertices(after, grid), slice(0, len(vertices))
    drawn = _drawn(after, grid)
    touched = touched_windows(_drawn(before, grid), drawn)
    if touched is None:
        return surface_vertices(after, grid), slice(0, len(vertices))
    part = part_of(drawn, *touched)
    if not part.coefficients.size:
        return vertices, slice(0, 0)
    revised, (rows, columns) = vertices.copy(), grid.vertices_of(*touched)
    revised[rows, columns] = surface_vertices(part, grid.of_windows(*touched))
    return read_only(revised), rows


def _drawn(patch: Patch, grid: Grid) -> Patch:
    """Return a patch with the same corners and normals there, in which windows that are together are one."""
    if grid.together == (1, 1):
        return patch
    coefficients, half = patch.coefficients, PATCH_DEGREE // 2 + 1
    for axis, some in ((1, grid.together[0]), (0, grid.together[1])):
        count = coefficients.shape[axis]
        first = np.arange(0, count, some)
        last = np.minimum(first + some - 1, count - 1)
        begin, end = (np.moveaxis(coefficients.take(numbers, axis), 3 - axis, 0) for numbers in (first, last))
        coefficients = np.moveaxis(np.concatenate([begin[:half], end[half:]]), 0, 3 - axis)
    return Patch(read_only(np.ascontiguousarray(coefficients)), patch.degree)


def _is_in_sight(coefficients: Array) -> bool:
    return bool(np.abs(coefficients).max() <= FARTHEST)


def _write_vertices(patch: Patch, grid: Grid, vertices: FloatArray) -> None:
    """Write the same of a patch, in single precision throughout: this is what every frame of a drag waits for."""
    in_v, in_slope_v = _curves_in_v(patch, grid)
    (n, m), width = grid.shape, in_v.shape[-1]
    points, su, sv = np.empty((3, n, width), dtype=np.float32)
    starts = window_starts(grid.u).tolist()
    for window, cells in enumerate(grid.u):
        rows, (values, slopes) = slice(starts[window], starts[window + 1]), _bases(cells + 1)
        np.matmul(values, in_v[window], out=points[rows])
        np.matmul(slopes, in_v[window], out=su[rows])
        np.matmul(values, in_slope_v[window], out=sv[rows])
    points, su, sv = (part.reshape(n, 3, m) for part in (points, su, sv))
    vertices[..., :3] = points.transpose(0, 2, 1)
    for k, (a, b) in enumerate(((1, 2), (2, 0), (0, 1))):
        np.subtract(su[:, a] * sv[:, b], su[:, b] * sv[:, a], out=vertices[..., 3 + k])
    _mend_normals(vertices[..., 3:], patch, grid)


def _curves_in_v(patch: Patch, grid: Grid) -> tuple[FloatArray, FloatArray]:
    """Return, for every window along u and each coefficient along u, the points of its curve in v and their slopes.

    Returns
    -------
    two arrays (n, 7, 3 M), of which the last axis has all x before all y
    """
    n = patch.windows[1]
    count, starts = grid.shape[1], window_starts(grid.v).tolist()
    in_v, in_slope_v = np.empty((2, n, PATCH_DEGREE + 1, 3, count), dtype=np.float32)
    for window, cells in enumerate(grid.v):
        # (n, u, v, 3) as (v, 3 n u)
        table = patch.coefficients[window].transpose(2, 3, 0, 1).reshape(PATCH_DEGREE + 1, -1).astype(np.float32)
        columns = slice(starts[window], starts[window + 1])
        for functions, result in zip(_bases(cells + 1), (in_v, in_slope_v), strict=True):
            found = (functions @ table).reshape(cells + 1, 3, n, PATCH_DEGREE + 1)
            result[..., columns] = found.transpose(2, 3, 1, 0)
    flat = n, PATCH_DEGREE + 1, 3 * count
    return in_v.reshape(flat), in_slope_v.reshape(flat)


def _mend_normals(normals: FloatArray, patch: Patch, grid: Grid) -> None:
    """Take normals from double precision in windows in which some have no direction in single precision."""
    squared = np.einsum("ijk,ijk->ij", normals, normals)
    m, n = patch.windows
    least = _SINGULAR / (m * n) ** 2
    if squared.min() >= least:
        return
    starts = window_starts(grid.u), window_starts(grid.v)
    low = np.minimum.reduceat(np.minimum.reduceat(squared, starts[0][:-1], axis=0), starts[1][:-1], axis=1)
    for b, a in np.argwhere(low < least).tolist():
        rows, columns = (slice(*each[[k, k + 1]].tolist()) for each, k in zip(starts, (b, a), strict=True))
        u, v = (np.linspace(0.0, 1.0, count + 1) for count in (grid.u[b], grid.v[a]))
        normals[rows, columns] = patch.window(a, b).normals(u, v)


def sample_places(surface: ParametricSurface, grid: Grid, places: FloatArray) -> None:
    """Write the points of a surface in unit space to (n, m, 3) float32, none of them beyond ``FARTHEST``."""
    u, v = parameters(surface, grid)
    if isinstance(surface, Patch) and _is_in_sight(surface.coefficients):
        surface.points(u, v, out=places)
    else:
        np.clip(surface.points(u, v), -FARTHEST, FARTHEST, out=places, casting="same_kind")


def triangle_indices(grid: Grid) -> npt.NDArray[np.uint32]:
    """Return two triangles a cell, wound around S_u x S_v, each of them ending at the cell's first corner.

    Returns
    -------
    (cells ``CORNERS``,) uint32, read-only
    """
    return _kept_triangles(grid) if math.prod(grid.cells) <= _KEPT else _triangles(grid)


def _triangles(grid: Grid) -> npt.NDArray[np.uint32]:
    m = grid.shape[1]
    corner = (cell_starts(grid.u)[:, None] * m + cell_starts(grid.v)).astype(np.uint32)[..., None]
    cell = np.array([m, m + 1, 0, m + 1, 1, 0], dtype=np.uint32)
    return read_only((corner + cell).ravel())


_kept_triangles = lru_cache(maxsize=8)(_triangles)
