"""What one control point or one knot moves: how much, how far, how it falls off, and what the edges do."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from qovr_core.arrays import Array, read_only
from qovr_core.document import Document
from qovr_core.edits import set_point, set_values, value_at
from qovr_core.evaluation import Evaluation, parameters
from qovr_core.geometry import bernstein
from qovr_core.geometry.edges import Edge
from qovr_core.geometry.knots import KnotPlace
from qovr_core.geometry.patch import PATCH_DEGREE, Patch
from qovr_core.laboratory.falloff import Falloff, falloff
from qovr_core.laboratory.levels import areas_above
from qovr_core.laboratory.still_lines import still_lines
from qovr_core.layer import Layer

SAMPLES = 101
"""Samples along u and v, the paper's; a share of the area is then known to about 0.0002."""

PARTS = (0.1, 0.01)
"""A place counts as moved by more than this part of the largest displacement: what is seen, and what is measured."""

DEFAULT_PART = 0.1
"""A point is moved by this part of the net's size, and a knot by as much of its interval."""

_SAME = 1e-9
"""Relative difference up to which displacements count as equally large."""

_NOISE = 8 * float(np.finfo(np.float64).eps)
"""The same between places so near each other that only rounding tells those of a ridge apart: the nearest is kept."""

_ZOOM_SAMPLES = 9
_ZOOM_ROUNDS = 10
"""Each round looks at a window a third as wide: ten take the step of the grid below 1e-6."""

_FROM_CENTRE = read_only(np.add.outer(*[np.abs(np.arange(_ZOOM_SAMPLES) - _ZOOM_SAMPLES // 2)] * 2))


@dataclass(frozen=True, slots=True)
class PointMove:
    """P_{i,j} moves by a vector (x, y, z) in the document's unit."""

    i: int
    j: int
    vector: tuple[float, float, float]

    def applied(self, document: Document) -> Document:
        """Return the document after the move; raises DocumentError where the point would be no valid one."""
        return set_point(document, self.i, self.j, document.control_points[self.i, self.j] + self.vector)


@dataclass(frozen=True, slots=True)
class KnotMove:
    """One knot of one curve changes by an amount."""

    place: KnotPlace
    amount: float

    def applied(self, document: Document) -> Document:
        """Return the document after the change; raises DocumentError where the knot would leave (0, 1)."""
        return set_values(document, {self.place: value_at(document, self.place) + self.amount})


Change = PointMove | KnotMove


@dataclass(frozen=True)
class Reach:
    """How much of the surface moves by more than a part of the largest displacement.

    Parameters
    ----------
    part : that part of the largest displacement
    area : share of the unit square of parameters, from 0 to 1; not of the surface's area in space
    distance : parameter distance from the place of the largest displacement to the farthest sample that moves so much
    """

    part: float
    area: float
    distance: float


@dataclass(frozen=True, eq=False)
class Influence:
    """What a change does to a surface.

    Parameters
    ----------
    change, layer : what was changed, and which surface is meant
    displacement : the surface after the change less the surface before, exact; its points are vectors
    u, v : (n,) and (m,) parameters of the samples
    magnitude : (n, m) length of the displacement, indexed [iu, iv]
    largest : the largest displacement; 0 where nothing moves
    place : (u, v) where it is; of several places that move equally the first along u, then v
    reaches : one Reach for each of PARTS
    edges : largest motion along each edge
    corners : (2, 2) motion of the corners, indexed [u, v]
    still_u, still_v : parameters c of the isoparametric lines u = c and v = c that do not move at all
    falloff : displacement against distance; None where nothing moves
    """

    change: Change
    layer: Layer
    displacement: Patch
    u: Array
    v: Array
    magnitude: Array
    largest: float
    place: tuple[float, float]
    reaches: tuple[Reach, ...]
    edges: dict[Edge, float]
    corners: Array
    still_u: tuple[float, ...]
    still_v: tuple[float, ...]
    falloff: Falloff | None


def default_amount(document: Document, place: KnotPlace) -> float:
    """Return by how much to change a knot where nothing else is asked: 0.1, downward where 1 is too near."""
    return DEFAULT_PART if value_at(document, place) + DEFAULT_PART < 1 else -DEFAULT_PART


@np.errstate(under="ignore")  # what underflows is nothing
def influence(document: Document, change: Change, layer: Layer) -> Influence:
    """Return what a change of one point or knot does to a surface.

    Parameters
    ----------
    document : what defines the surface before the change
    change : what is changed
    layer : which surface; for the transformed one T of (61)-(65) is computed again after the change, as
        ``configure`` does

    Raises
    ------
    DocumentError : the change leads to no valid document
    EvaluationError : before or after the change the coordinates are not finite in double precision
    """
    displacement, noise = _displacement(document, change.applied(document), layer)
    u = v = parameters(SAMPLES)
    magnitude = read_only(_lengths(displacement, u, v))
    u_peak, v_peak, largest = _peak(displacement, u, magnitude)
    is_still = largest == 0
    fall = None if is_still else falloff(u, v, magnitude, (u_peak, v_peak, largest))
    return Influence(
        change=change,
        layer=layer,
        displacement=displacement,
        u=u,
        v=v,
        magnitude=magnitude,
        largest=largest,
        place=(u_peak, v_peak),
        reaches=_reaches(magnitude, fall, largest),
        edges={edge: _largest_along(displacement.edge(edge)) for edge in Edge},
        corners=read_only(_lengths(displacement, np.array([0.0, 1.0]), np.array([0.0, 1.0]))),
        still_u=still_lines(displacement, 0, noise),
        still_v=still_lines(displacement, 1, noise),
        falloff=fall,
    )


def _displacement(before: Document, after: Document, layer: Layer) -> tuple[Patch, float]:
    """Return the difference of the two surfaces, in which what is rounding is exactly 0, and the size of rounding."""
    old, new = Evaluation(before), Evaluation(after)
    rounding = old.layer_rounding(layer) + new.layer_rounding(layer)
    difference = new.layer_patch(layer).coefficients - old.layer_patch(layer).coefficients
    difference[np.abs(difference) <= rounding] = 0.0
    return Patch(difference), float(rounding.max())


def _lengths(displacement: Patch, u: Array, v: Array) -> Array:
    axes = np.moveaxis(displacement.coefficients[0, 0], -1, 0)
    x, y, z = bernstein.basis(PATCH_DEGREE, u) @ axes @ bernstein.basis(PATCH_DEGREE, v).T
    lengths: Array = np.hypot(np.hypot(x, y), z)  # knots near 0 can make lengths whose squares overflow
    return lengths


def _peak(displacement: Patch, samples: Array, magnitude: Array) -> tuple[float, float, float]:
    """Return where the displacement is largest, and how large: the best sample, then ever smaller windows round it."""
    first = np.flatnonzero(magnitude >= (1 - _SAME) * magnitude.max())[0]
    iu, iv = np.unravel_index(first, magnitude.shape)
    u, v, width = samples[iu], samples[iv], samples[1]
    for _ in range(_ZOOM_ROUNDS):
        window = np.linspace(-width, width, _ZOOM_SAMPLES)
        us, vs = np.clip(u + window, 0, 1), np.clip(v + window, 0, 1)
        lengths = _lengths(displacement, us, vs)
        is_largest = lengths >= (1 - _NOISE) * lengths.max()
        iu, iv = np.unravel_index(np.where(is_largest, _FROM_CENTRE, np.inf).argmin(), lengths.shape)
        u, v, width = us[iu], vs[iv], width / 3
    return float(u), float(v), float(lengths.max())


def _reaches(magnitude: Array, fall: Falloff | None, largest: float) -> tuple[Reach, ...]:
    if fall is None:
        return tuple(Reach(part, 0.0, 0.0) for part in PARTS)
    levels = [part * largest for part in PARTS]
    distances = [float(fall.distance[magnitude > level].max(initial=0.0)) for level in levels]
    return tuple(map(Reach, PARTS, areas_above(magnitude, levels), distances))


def _largest_along(edge: Array) -> float:
    """Return the largest length on a curve (1, 7, 3) of displacements: at an end, or where its square is stationary."""
    edge = edge[0]
    size = np.abs(edge).max()
    if size == 0:
        return 0.0
    unit = edge / size
    squared = bernstein.product(unit.T, unit.T).sum(axis=0)
    places = np.concatenate([[0.0, 1.0], bernstein.roots(bernstein.derivative(squared, 0))])
    return float(size * np.linalg.norm(bernstein.basis(PATCH_DEGREE, places) @ unit, axis=1).max())
