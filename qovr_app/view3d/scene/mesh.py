"""The display grid: vertices and triangles of a patch, at a resolution that is the view's own affair."""

from __future__ import annotations

from functools import lru_cache

import numpy as np
import numpy.typing as npt

from qovr_app.state.display import Style
from qovr_app.view3d.scene.frame import FARTHEST
from qovr_core.arrays import Array, read_only
from qovr_core.geometry.bernstein import basis
from qovr_core.geometry.differential import ParametricSurface
from qovr_core.geometry.patch import PATCH_DEGREE, Patch

FloatArray = npt.NDArray[np.float32]
Counts = tuple[int, int]
"""Vertices along u and along v."""

MOVING_LIMIT, MOVING_POINTS = 49, 101
"""Vertices a side while something moves. With exact normals, lines and facets that need no vertices, finer
ones look the same; where each vertex is seen, as a point, the paper's 101 are."""

RESTING_LIMIT = 201
"""Vertices a side at rest: silhouettes stay round in a large window and in figures."""

_SINGULAR = 1e-12
"""Squared length of S_u x S_v, in unit space, below which single precision no longer knows its direction."""


@lru_cache(maxsize=32)
def _bases(count: int) -> tuple[FloatArray, FloatArray]:
    """Return the Bernstein polynomials and their derivatives at ``count`` even parameters, each (count,
    7)."""
    t = np.linspace(0.0, 1.0, count)
    values = basis(PATCH_DEGREE, t)
    lower = PATCH_DEGREE * basis(PATCH_DEGREE - 1, t)
    slopes = np.pad(lower, ((0, 0), (1, 0))) - np.pad(lower, ((0, 0), (0, 1)))
    return read_only(values.astype(np.float32)), read_only(slopes.astype(np.float32))


def surface_vertices(surface: ParametricSurface, counts: Counts) -> FloatArray:
    """Return positions and exact normals of a surface in unit space.

    The normals are those of the surface as it is shown, scaled to the axes box, and not of unit length: the
    shaders normalise them anyway.

    Returns
    -------
    (n, m, 6) float32, read-only: x, y, z, none of them beyond ``FARTHEST``, and the normal, indexed [iu, iv]
    """
    if isinstance(surface, Patch) and np.abs(surface.coefficients).max() <= FARTHEST:
        return _patch_vertices(surface, counts)
    u, v = (np.linspace(0.0, 1.0, count) for count in counts)
    points = np.clip(surface.points(u, v), -FARTHEST, FARTHEST)
    return read_only(np.concatenate([points, surface.normals(u, v)], axis=-1, dtype=np.float32))


def _patch_vertices(patch: Patch, counts: Counts) -> FloatArray:
    """Return the same for a patch, in single precision throughout: this is what every frame of a drag waits for."""
    (n, m), (along_u, slope_u), (along_v, slope_v) = counts, _bases(counts[0]), _bases(counts[1])
    table = patch.coefficients[0, 0].transpose(1, 2, 0).reshape(PATCH_DEGREE + 1, -1).astype(np.float32)
    in_v = (along_v @ table).reshape(m, 3, -1).transpose(2, 1, 0).reshape(-1, 3 * m)
    in_slope_v = (slope_v @ table).reshape(m, 3, -1).transpose(2, 1, 0).reshape(-1, 3 * m)
    points, su, sv = (
        (left @ right).reshape(n, 3, m) for left, right in ((along_u, in_v), (slope_u, in_v), (along_u, in_slope_v))
    )
    vertices = np.empty((n, m, 6), dtype=np.float32)
    vertices[..., :3] = points.transpose(0, 2, 1)
    for k, (a, b) in enumerate(((1, 2), (2, 0), (0, 1))):
        np.subtract(su[:, a] * sv[:, b], su[:, b] * sv[:, a], out=vertices[..., 3 + k])
    normals = vertices[..., 3:]
    if np.einsum("ijk,ijk->ij", normals, normals).min() < _SINGULAR:
        u, v = (np.linspace(0.0, 1.0, count) for count in counts)
        normals[:] = patch.normals(u, v)
    return read_only(vertices)


@lru_cache(maxsize=8)
def triangle_indices(counts: Counts) -> npt.NDArray[np.uint32]:
    """Return two triangles a cell, wound around S_u x S_v.

    Returns
    -------
    ((n - 1) (m - 1) 6,) uint32, read-only
    """
    n, m = counts
    corner = (np.arange(n - 1)[:, None] * m + np.arange(m - 1)).astype(np.uint32)[..., None]
    cell = np.array([m, m + 1, 0, m + 1, 1, 0], dtype=np.uint32)
    return read_only((corner + cell).ravel())


def display_counts(samples: Counts, style: Style, *, moving: bool) -> Counts:
    """Return the display grid of a document with these samples; coarse facets and points stay coarse."""
    limit = MOVING_LIMIT if moving else RESTING_LIMIT
    if style is Style.POINTS and moving:
        limit = MOVING_POINTS
    if style not in (Style.FACETS, Style.POINTS):
        return limit, limit
    return min(samples[0], limit), min(samples[1], limit)


def facet_counts(samples: Counts) -> Counts:
    """Return the corners of facets along u and v: the samples, as far as facets can be told apart."""
    return min(samples[0], RESTING_LIMIT), min(samples[1], RESTING_LIMIT)


def spread(values: Array, counts: Counts) -> Array:
    """Return values (n, m) at even parameters on a finer or an equal grid, linear between them.

    What lies beside a NaN is one, too.
    """
    for axis, count in enumerate(counts):
        few = values.shape[axis]
        if few != count:
            at = np.linspace(0.0, few - 1.0, count)
            lower = np.minimum(at.astype(np.intp), few - 2)
            part = np.expand_dims(at - lower, 1 - axis)
            values = np.take(values, lower, axis) * (1 - part) + np.take(values, lower + 1, axis) * part
    return values


def curve_points(coefficients: Array, count: int) -> Array:
    """Return ``count`` points of Bezier curves.

    Parameters
    ----------
    coefficients : (k, 7, 3)

    Returns
    -------
    (k, count, 3) float64
    """
    return _curve_basis(count) @ coefficients


@lru_cache(maxsize=4)
def _curve_basis(count: int) -> Array:
    return read_only(basis(PATCH_DEGREE, np.linspace(0.0, 1.0, count)))
