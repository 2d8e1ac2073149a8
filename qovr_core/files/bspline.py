"""Pieces of the surface as CAD formats want them: B-spline surfaces of their true degree, and what their edges do."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from itertools import chain, repeat
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


@dataclass(frozen=True)
class KnotVector:
    """The knots of a B-spline along one parameter.

    Parameters
    ----------
    degree : of the B-spline
    values : the distinct knots, rising
    multiplicities : how often each is there
    """

    degree: int
    values: tuple[float, ...]
    multiplicities: tuple[int, ...]

    @property
    def repeated(self) -> list[float]:
        """All knots, each as often as it is there."""
        return list(chain.from_iterable(map(repeat, self.values, self.multiplicities)))


@dataclass(frozen=True, eq=False)
class SplineSurface:
    """A B-spline surface, not rational, clamped each way.

    Parameters
    ----------
    points : (k, l, 3) control points, u along the first axis
    u, v : its knots
    """

    points: Array
    u: KnotVector
    v: KnotVector


def spline_surface(
    coefficients: Array,
    degree: tuple[int, int],
    breakpoints: tuple[Array, Array],
    smooth: tuple[Sequence[bool], Sequence[bool]],
) -> SplineSurface:
    """Return a block of windows as one B-spline surface with its knots at the windows' breakpoints.

    Where a joint is smooth, its knot has the multiplicity degree - 1, and the Bernstein coefficients there, means of
    their neighbours weighed by the windows' lengths, are no control points; else it has the multiplicity degree. Where
    a reduction to degree 4 would not meet the patches to rounding, the degree stays 6.

    Parameters
    ----------
    coefficients : (m, n, 7, 7, 3) of the patches, windows along v first; neighbours share those of their joint
    degree : the true degrees in u and in v, each 4 or 6
    breakpoints : (n + 1,) and (m + 1,) in u and in v
    smooth : which of the n - 1 and m - 1 joints between them are smooth
    """
    pieces = coefficients
    for axis, lower in enumerate(degree, 2):
        if lower < PATCH_DEGREE:
            reduced = _along(_reduction(lower), pieces, axis)
            missed = np.abs(_along(bernstein.elevation(lower, PATCH_DEGREE), reduced, axis) - pieces).max()
            if missed <= _ROUNDING * np.abs(pieces).max():
                pieces = reduced
    knots = [
        _knot_vector(size - 1, ends.tolist(), joints)
        for size, ends, joints in zip(pieces.shape[2:4], breakpoints, smooth, strict=True)
    ]
    rows = _chained(pieces.transpose(1, 2, 0, 3, 4), smooth[0])
    points = _chained(rows.transpose(1, 2, 0, 3), smooth[1]).transpose(1, 0, 2)
    return SplineSurface(read_only(points), *knots)


def has_area(patch: Patch, rounding: Array) -> bool:
    """Return whether in any window the tangents are independent anywhere on a coarse grid.

    Parameters
    ----------
    rounding : (3,) up to what size a difference of coordinates is no more than rounding; no window is a surface whose
        extents are that small
    """
    return any(_window_has_area(patch.window(a, b), rounding) for a, b in np.ndindex(*patch.windows))


def _window_has_area(window: Patch, rounding: Array) -> bool:
    if (np.ptp(window.coefficients.reshape(-1, 3), axis=0) <= rounding).all():
        return False
    t = np.linspace(0.0, 1.0, _AREA_SAMPLES)
    su, sv = (_of_unit_size(window.derivative(t, t, *order)) for order in ((1, 0), (0, 1)))
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
    if not has_area(patch, evaluation.layer_rounding(options.chosen_layer(evaluation.document))):
        raise FileError(f"{path}: the surface is drawn together into a curve or a point; expected one with an area")
    return patch


def diagonal(points: Array) -> float:
    """Return the diagonal of the box of points (..., 3)."""
    flat = points.reshape(-1, 3)
    return math.hypot(*(flat.max(axis=0) - flat.min(axis=0)))  # unlike a norm, it neither overflows nor vanishes


def uncertainty(points: Array) -> float:
    """Return the distance below which points of a surface are the same, a power of ten."""
    return float(f"1e{math.ceil(math.log10(diagonal(points))) - _UNCERTAINTY_DIGITS}")


def coincide(a: Array, b: Array, within: float) -> bool:
    """Return whether points (..., 3) are the same as others, each within a distance."""
    return bool(np.linalg.norm(a - b, axis=-1).max() <= within)


def outline(points: Array, within: float) -> Outline:
    """Return which edges of a patch are one point or one curve.

    Parameters
    ----------
    points : (k, l, 3) control points of a clamped surface, as Bernstein coefficients are
    within : the distance at which points count as one
    """
    edges = {edge: points[edge.position] for edge in Edge}

    return Outline(
        collapsed=frozenset(name for name, curve in edges.items() if coincide(curve, curve[:1], within)),
        closed_u=coincide(edges[Edge.U0], edges[Edge.U1], within),
        closed_v=coincide(edges[Edge.V0], edges[Edge.V1], within),
    )


def _knot_vector(degree: int, values: list[float], smooth: Sequence[bool]) -> KnotVector:
    inner = (degree - 1 if joint else degree for joint in smooth)
    return KnotVector(degree, tuple(values), (degree + 1, *inner, degree + 1))


def _chained(pieces: Array, smooth: Sequence[bool]) -> Array:
    """Return the control points (k, ...) of a chain of windows (windows, degree + 1, ...) along one parameter."""
    ends = [-1 if joint else None for joint in smooth] + [None]
    return np.concatenate([pieces[0, :1], *(piece[1:end] for piece, end in zip(pieces, ends, strict=True))])


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
