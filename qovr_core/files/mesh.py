"""The triangle mesh of a surface: shared vertices, exact normals, one winding."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import numpy.typing as npt

from qovr_core.arrays import Array
from qovr_core.errors import EvaluationError, FileError
from qovr_core.evaluation import Evaluation, parameters
from qovr_core.files import bspline, tessellation
from qovr_core.files.options import ExportOptions
from qovr_core.files.progress import Progress
from qovr_core.geometry.edges import Edge
from qovr_core.geometry.patch import Patch

Indices = npt.NDArray[np.int32]

BLOCK = 1 << 16
"""Vertices or faces handled at a time: small beside the mesh, large beside the cost of a call."""

MESHED = 0.5
"""Part of the work that is done when the mesh stands and its writing begins."""

FLOAT32_ROUNDING = 2.0**-24 * np.sqrt(3.0)
"""How far rounding to 32 bits moves a point, as a part of its largest coordinate."""

_WELDED = 1e-12
"""Edges closer than this part of the surface's size are the same points, moved by rounding."""

_NO_AREA = 2e-15
"""Twice a triangle's area is rounding below this part of the surface's size times how far its points reach."""

_FLOAT32_SIZES = (1e-30, 1e38)
"""Between these a surface's coordinates stay normal 32-bit numbers of full precision."""

_SAME_NORMAL = 1e-6
"""Normals closer than this are shared where vertices are; those of a crease differ by far more."""


@dataclass(frozen=True, eq=False)
class Mesh:
    """Triangles over shared points, counterclockwise seen from the tip of their normals.

    Parameters
    ----------
    points : (k, 3) float64, every place once
    faces : (f, 3) indices of points
    normals : (l, 3) float64 unit normals; more than points where the surface meets itself in a crease or a tip
    corners : (f, 3) indices of normals
    places : (l,) the point that each normal stands on
    deviation : largest measured distance from the surface where a tolerance was asked for
    """

    points: Array
    faces: Indices
    normals: Array
    corners: Indices
    places: Indices
    deviation: float | None

    @property
    def vertices(self) -> Array:
        """The points of all normals, (l, 3), for formats whose vertices have one normal each."""
        return self.points if len(self.points) == len(self.normals) else self.points[self.places]


def build_mesh(
    evaluation: Evaluation, options: ExportOptions, path: Path, progress: Progress, rounding: float = 0.0
) -> Mesh:
    """Return the mesh of the chosen layer: on the document's samples, or as fine as the tolerance demands.

    Parameters
    ----------
    path : the file it is for, for the texts of errors
    rounding : distance by which the format itself moves a point; the tolerance includes it

    Raises
    ------
    FileError : the surface has no area, or the tolerance is finer than the format or the largest grid
    """
    patch = bspline.chosen_patch(evaluation, options, path)
    progress(0.0)
    measured = None
    if options.tolerance is None:
        u, v, points = evaluation.u, evaluation.v, options.chosen_samples(evaluation)
    else:
        u, v = _fine_grid(patch, options.tolerance, rounding, path)
        points = patch.points(u, v)
        measured = tessellation.deviation(patch, points) + rounding
    normals = _normals(patch, u, v, progress)
    mesh = _welded(patch, points, normals, measured)
    _check_area(patch, mesh, (len(u), len(v)), path)
    progress(MESHED)
    return mesh


def blocks(count: int) -> Iterable[slice]:
    """Return slices that cover ``count`` entries."""
    return [slice(k, min(k + BLOCK, count)) for k in range(0, count, BLOCK)]


def float32_rounding(evaluation: Evaluation, options: ExportOptions, reach: float) -> float:
    """Return how far 32-bit coordinates of at most ``reach`` times the surface's size move a point."""
    coefficients = options.chosen_patch(evaluation).coefficients
    return float(FLOAT32_ROUNDING) * reach * bspline.diagonal(coefficients)


def check_float32(points: Array, metres: float, path: Path) -> None:
    """Refuse points (k, 3) that 32-bit numbers cannot hold once they are scaled.

    Raises
    ------
    FileError : the mesh is too large or too small
    """
    size, (least, most) = bspline.diagonal(points) * metres, _FLOAT32_SIZES
    if not least <= size <= most:
        raise FileError(f"{path}: the mesh is {size:.3g} across; expected {least:g} to {most:g} for 32-bit coordinates")


def _fine_grid(patch: Patch, tolerance: float, rounding: float, path: Path) -> tuple[Array, Array]:
    if tolerance <= 2 * rounding:
        raise FileError(
            f"{path}: a tolerance of {tolerance:g} is lost in 32-bit coordinates; expected at least {4 * rounding:.2g}"
        )
    try:
        n, m = tessellation.samples_within(patch, tolerance - rounding)
    except EvaluationError as error:
        raise FileError(f"{path}: {error}") from error
    return parameters(n), parameters(m)


def _check_area(patch: Patch, mesh: Mesh, samples: tuple[int, int], path: Path) -> None:
    """Refuse triangles none of which has an area beyond the rounding of its corners."""
    size = bspline.diagonal(patch.coefficients)
    reach = max(1.0, float(np.abs(mesh.points).max(initial=0.0)) / size)
    for part in blocks(len(mesh.faces)):
        a, b, c = np.moveaxis(mesh.points[mesh.faces[part]], 1, 0)
        if np.linalg.norm(np.cross((b - a) / size, (c - a) / size), axis=-1).max() > _NO_AREA * reach:
            return
    n, m = samples
    raise FileError(f"{path}: at {n} x {m} samples the mesh has no area; expected more samples, or a tolerance")


def _normals(patch: Patch, u: Array, v: Array, progress: Progress) -> Array:
    normals = np.empty((len(u), len(v), 3))
    step = max(1, BLOCK // len(v))
    for start in range(0, len(u), step):
        rows = slice(start, start + step)
        normals[rows] = patch.normals(u[rows], v)
        progress(MESHED * min(start + step, len(u)) / len(u))
    return normals


def _welded(patch: Patch, points: Array, normals: Array, measured: float | None) -> Mesh:
    """Make one vertex of grid points that are the same place, and drop triangles that have no area by it."""
    edges = bspline.outline(patch.coefficients[0, 0], _WELDED * bspline.diagonal(patch.coefficients))
    shape = points.shape[:2]
    points, normals = points.reshape(-1, 3), normals.reshape(-1, 3)
    groups = _groups(edges, shape)
    place = _joined(shape, groups)
    faces = _triangles(place)
    if not groups:
        return Mesh(points, faces, normals, faces, place.ravel(), measured)
    corners = _triangles(_joined(shape, [group for group in groups if _agree(normals, group)]))
    kept = (faces != np.roll(faces, 1, axis=1)).all(axis=1)
    used, faces = _compact(faces[kept])
    standing, corners = _compact(corners[kept])
    places = np.searchsorted(used, place.ravel()[standing]).astype(np.int32)
    return Mesh(points[used], faces, normals[standing], corners, places, measured)


def _groups(edges: bspline.Outline, shape: tuple[int, int]) -> list[Indices]:
    """Return the sets of flat grid indices, each (g, ...), whose first axis is one place."""
    grid = np.arange(shape[0] * shape[1], dtype=np.int32).reshape(shape)
    sides = {edge: grid[edge.position] for edge in Edge}
    groups = [sides[edge][:, None] for edge in Edge if edge in edges.collapsed]
    if edges.closed_u:
        groups.append(np.stack([sides[Edge.U0], sides[Edge.U1]]))
    if edges.closed_v:
        groups.append(np.stack([sides[Edge.V0], sides[Edge.V1]]))
    return groups


def _joined(shape: tuple[int, int], groups: list[Indices]) -> Indices:
    """Return for every grid point the smallest index of those that are one place with it, (n, m)."""
    smallest = np.arange(shape[0] * shape[1], dtype=np.int32)
    changed = bool(groups)
    while changed:  # groups share corners, so that joining one may lengthen another
        before = smallest.copy()
        for group in groups:
            smallest[group] = smallest[group].min(axis=0)
        changed = bool((before != smallest).any())
    return smallest.reshape(shape)


def _agree(normals: Array, group: Indices) -> bool:
    there = normals[group]
    return bool(np.abs(there - there[:1]).max() <= _SAME_NORMAL)


def _triangles(index: Indices) -> Indices:
    """Return two triangles a cell as entries of ``index``, (f, 3)."""
    a, b, c, d = index[:-1, :-1], index[1:, :-1], index[1:, 1:], index[:-1, 1:]
    faces = np.empty((*a.shape, 2, 3), dtype=np.int32)
    for triangle, corners in enumerate(((a, b, c), (a, c, d))):
        for k, corner in enumerate(corners):
            faces[:, :, triangle, k] = corner
    return faces.reshape(-1, 3)


def _compact(faces: Indices) -> tuple[Indices, Indices]:
    """Return the indices in use, ascending, and the faces renumbered among them."""
    used, inverse = np.unique(faces, return_inverse=True)
    return used, inverse.reshape(-1, 3).astype(np.int32)
