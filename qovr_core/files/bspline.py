"""The patch as CAD formats want it: one B-spline surface of its true degree, and what its edges do."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import numpy as np

from qovr_core.arrays import Array, read_only
from qovr_core.errors import FileError
from qovr_core.evaluation import Evaluation
from qovr_core.files.options import ExportOptions
from qovr_core.geometry import bernstein
from qovr_core.geometry.edges import Edge
from qovr_core.geometry.patch import PATCH_DEGREE, Patch

_ROUNDING = 1e-13
"""Elevated again, reduced coefficients must meet the patch within this part of its largest coefficient."""

_NO_AREA = 1e-12
"""|S_u x S_v| below this part of its bound everywhere is rounding: the surface is a curve or a point."""

_AREA_SAMPLES = 17

_UNCERTAINTY_DIGITS = 8
"""Points closer than the surface's size, rounded up to a power of ten, times 1e-8 are the same to a CAD program."""


@dataclass(frozen=True)
class Outline:
    """How the four edges of a patch lie to each other.

    Parameters
    ----------
    collapsed : the edges that are one point
    closed_u, closed_v : whether the edges u=0 and u=1, or v=0 and v=1, are the same curve
    """

    collapsed: frozenset[Edge]
    closed_u: bool
    closed_v: bool


def control_points(patch: Patch) -> Array:
    """Return the B-spline control points of a patch, (p + 1, q + 1, 3), p and q its true degrees.

    The knots are clamped, 0 and 1 with multiplicity degree + 1 each way, so these are Bernstein coefficients.
    Where a reduction to degree 4 would not meet the patch to rounding, the degree stays 6.
    """
    points: Array = patch.coefficients[0, 0]
    for axis, degree in enumerate(patch.degree):
        if degree < PATCH_DEGREE:
            reduced = _along(_reduction(degree), points, axis)
            missed = np.abs(_along(bernstein.elevation(degree, PATCH_DEGREE), reduced, axis) - points).max()
            if missed <= _ROUNDING * np.abs(points).max():
                points = reduced
    return read_only(points)


def has_area(patch: Patch) -> bool:
    """Return whether the tangents are independent anywhere on a coarse grid."""
    t = np.linspace(0.0, 1.0, _AREA_SAMPLES)
    su, sv = (_of_unit_size(patch.derivative(t, t, *order)) for order in ((1, 0), (0, 1)))
    lengths = np.linalg.norm(np.cross(su, sv), axis=-1)
    bound = np.linalg.norm(su, axis=-1).max() * np.linalg.norm(sv, axis=-1).max()
    return bool(lengths.max() > _NO_AREA * bound)


def chosen_patch(evaluation: Evaluation, options: ExportOptions, path: Path) -> Patch:
    """Return the patch that is to be written into a file.

    Raises
    ------
    FileError : the patch is no surface, for it has no area
    """
    patch = options.chosen_patch(evaluation)
    if not has_area(patch):
        raise FileError(f"{path}: the surface is drawn together into a curve or a point; expected one with an area")
    return patch


def diagonal(points: Array) -> float:
    """Return the diagonal of the box of points (..., 3)."""
    flat = points.reshape(-1, 3)
    return math.hypot(*(flat.max(axis=0) - flat.min(axis=0)))  # unlike a norm, it neither overflows nor vanishes


def uncertainty(points: Array) -> float:
    """Return the distance below which points of a surface are the same, a power of ten."""
    return float(f"1e{math.ceil(math.log10(diagonal(points))) - _UNCERTAINTY_DIGITS}")


def outline(points: Array, within: float) -> Outline:
    """Return which edges of a patch are one point or one curve.

    Parameters
    ----------
    points : (p + 1, q + 1, 3) Bernstein coefficients
    within : the distance at which points count as one
    """
    edges = {edge: points[edge.position] for edge in Edge}

    def coincide(a: Array, b: Array) -> bool:
        return bool(np.linalg.norm(a - b, axis=-1).max() <= within)

    return Outline(
        collapsed=frozenset(name for name, curve in edges.items() if coincide(curve, curve[:1])),
        closed_u=coincide(edges[Edge.U0], edges[Edge.U1]),
        closed_v=coincide(edges[Edge.V0], edges[Edge.V1]),
    )


def _of_unit_size(vectors: Array) -> Array:
    """Return vectors whose largest component is 1, so that their products neither overflow nor vanish."""
    largest = np.abs(vectors).max()
    return vectors / largest if largest > 0 else vectors


def _along(matrix: Array, points: Array, axis: int) -> Array:
    return np.moveaxis(np.tensordot(matrix, points, axes=(1, axis)), 0, axis)


@cache
def _reduction(degree: int) -> Array:
    """Return the matrix (degree + 1, 7) from degree 6 down: exact ends, the rest by least squares."""
    elevation = bernstein.elevation(degree, PATCH_DEGREE)
    matrix = np.zeros((degree + 1, PATCH_DEGREE + 1))
    matrix[0, 0] = matrix[-1, -1] = 1
    inner = np.eye(PATCH_DEGREE + 1)
    inner[:, 0] -= elevation[:, 0]
    inner[:, -1] -= elevation[:, -1]
    matrix[1:-1] = np.linalg.lstsq(elevation[:, 1:-1], inner, rcond=None)[0]
    return read_only(matrix)
