"""The triangle mesh of a surface: shared vertices, exact normals, one winding."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from qovr_core.arrays import Array, Indices
from qovr_core.errors import EvaluationError, FileError
from qovr_core.evaluation import Evaluation
from qovr_core.files import bspline, tessellation, welding
from qovr_core.files.mesh_grid import MeshGrid, Numbers
from qovr_core.files.options import ExportOptions
from qovr_core.files.progress import Progress
from qovr_core.geometry.patch import Patch

BLOCK = 1 << 16
"""Vertices or faces handled at a time: small beside the mesh, large beside the cost of a call."""

MESHED = 0.5
"""Part of the work that is done when the mesh stands and its writing begins."""

FLOAT32_ROUNDING = 2.0**-24 * np.sqrt(3.0)
"""How far rounding to 32 bits moves a point, as a part of its largest coordinate."""

_NO_AREA = 2e-15
"""Twice a triangle's area is rounding below this part of the surface's size times how far its points reach."""

_FLOAT32_SIZES = (1e-30, 1e38)
"""Between these a surface's coordinates stay normal 32-bit numbers of full precision."""


@dataclass(frozen=True, eq=False)
class Mesh:
    """Triangles over shared points, counterclockwise seen from the tip of their normals.

    Parameters
    ----------
    points : (k, 3) float64, every place once
    faces : (f, 3) indices of points
    normals : (l, 3) float64 unit normals; more than points where windows or edges meet in a crease or a tip
    corners : (f, 3) indices of normals
    places : (l,) the point that each normal stands on
    deviation : largest measured distance from the surface where a tolerance was asked for
    """

    points: Array
    faces: Numbers
    normals: Array
    corners: Numbers
    places: Numbers
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
    is_joined = evaluation.document.formulation.is_continuous or patch.windows == (1, 1)
    if options.tolerance is None:
        grid = MeshGrid.of(evaluation.document.intervals, is_joined)
        points = grid.spread(options.chosen_samples(evaluation)) if is_joined else grid.points(patch)
    else:
        grid = MeshGrid.of(_intervals(patch, options.tolerance, rounding, path), is_joined)
        points = grid.points(patch)
        measured = tessellation.deviation(patch, grid, points) + rounding
    normals = _normals(patch, grid, progress)
    mesh = _welded(patch, grid, points, normals, measured)
    _check_area(patch, mesh, grid, path)
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


def _intervals(patch: Patch, tolerance: float, rounding: float, path: Path) -> tuple[Indices, Indices]:
    if tolerance <= 2 * rounding:
        raise FileError(
            f"{path}: a tolerance of {tolerance:g} is lost in 32-bit coordinates; expected at least {4 * rounding:.2g}"
        )
    try:
        return tessellation.intervals_within(patch, tolerance - rounding)
    except EvaluationError as error:
        raise FileError(f"{path}: {error}") from error


def _check_area(patch: Patch, mesh: Mesh, grid: MeshGrid, path: Path) -> None:
    """Refuse triangles none of which has an area beyond the rounding of its corners."""
    size = bspline.diagonal(patch.coefficients)
    reach = max(1.0, float(np.abs(mesh.points).max(initial=0.0)) / size)
    for part in blocks(len(mesh.faces)):
        a, b, c = np.moveaxis(mesh.points[mesh.faces[part]], 1, 0)
        if np.linalg.norm(np.cross((b - a) / size, (c - a) / size), axis=-1).max() > _NO_AREA * reach:
            return
    n, m = (int(axis.intervals.sum()) + 1 for axis in (grid.u, grid.v))
    raise FileError(f"{path}: at {n} x {m} samples the mesh has no area; expected more samples, or a tolerance")


def _normals(patch: Patch, grid: MeshGrid, progress: Progress) -> Array:
    normals = np.empty((*grid.shape, 3))
    step = max(1, BLOCK // len(grid.v))
    for window in range(len(grid.u.intervals)):
        column, of_column = grid.column(patch, window), normals[grid.u.samples(window)]
        u = grid.u.window(window).located
        for start in range(0, len(of_column), step):
            rows = slice(start, start + step)
            of_column[rows] = column.normals(u[rows], grid.v.located)
            progress(MESHED * min(grid.u.starts[window] + start + step, len(grid.u)) / len(grid.u))
    return normals


def _welded(patch: Patch, grid: MeshGrid, points: Array, normals: Array, measured: float | None) -> Mesh:
    """Make one vertex of those that are the same place, and drop triangles that have no area by it."""
    joints, seams = welding.joints(grid), welding.seams(grid, patch)
    points, normals = points.reshape(-1, 3), normals.reshape(-1, 3)
    place = welding.one_place(grid, joints + seams)
    faces = grid.triangles(place)
    if not joints + seams:
        return Mesh(points, faces, normals, faces, place.ravel(), measured)
    corners = grid.triangles(welding.one_place(grid, welding.of_one_normal(normals, joints, seams)))
    a, b, c = faces.T
    kept = (a != b) & (b != c) & (c != a)
    if not kept.all():
        faces, corners = faces[kept], corners[kept]
    used, faces = _compact(faces)
    standing, corners = _compact(corners)
    places = np.searchsorted(used, place.ravel()[standing]).astype(np.int32)
    return Mesh(points[used], faces, normals[standing], corners, places, measured)


def _compact(faces: Numbers) -> tuple[Numbers, Numbers]:
    """Return the indices in use, ascending, and the faces renumbered among them."""
    is_used = np.zeros(int(faces.max(initial=-1)) + 1, dtype=np.bool_)
    for part in blocks(len(faces)):
        is_used[faces[part]] = True
    numbers, renumbered = np.cumsum(is_used, dtype=np.int32) - 1, np.empty_like(faces)
    for part in blocks(len(faces)):
        renumbered[part] = numbers[faces[part]]
    return np.flatnonzero(is_used).astype(np.int32), renumbered
