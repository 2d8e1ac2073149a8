"""The paper's Table 2 in numbers: the QOVR surface and the classical surfaces of the same net, measured alike."""

from __future__ import annotations

from collections.abc import Generator, Iterator
from dataclasses import dataclass
from enum import StrEnum
from itertools import pairwise
from math import isfinite

import numpy as np

from qovr_core.arrays import Array, read_only
from qovr_core.checks import described
from qovr_core.differential import ParametricSurface
from qovr_core.document import NET_SIZE, Document
from qovr_core.edits import set_points
from qovr_core.errors import DocumentError, EvaluationError
from qovr_core.laboratory.closest import closest_points
from qovr_core.laboratory.splines import TensorSurface, b_spline, bezier, catmull_rom, nurbs
from qovr_core.patch import Edge
from qovr_core.pipeline import align_patch, default_layer

DEFAULT_POINT = (2, 2)
DEFAULT_WEIGHT = 4.0
"""Weight of the chosen point in the NURBS surface; 1 would give the B-spline, 4 draws it visibly toward the point."""

MOVE = 0.1
"""The chosen point moves along z by this part of the net's size, the diagonal of the control points' box."""

SHARES = (0.01, 0.10)
"""A point of the surface counts as moved beyond these parts of the largest displacement."""

_MOTION_SAMPLES = 201
"""Samples each way of the displacement: a share of the area is then told to about half a percent."""

_DISTANCE_SAMPLES, _FINER_SAMPLES = 33, 9
"""Samples each way whose distance from another surface is taken, and between the neighbours of the farthest."""

_JOINT_SAMPLES = 101

_FIRST_NODES, _MOST_NODES = 24, 384
"""Gauss-Legendre nodes each way and piece: doubled until the energy settles, or given up."""

_ENERGY_SETTLED = 1e-6
"""Part of itself, or of the energy of a whole sphere, 8 pi, by which the energy may still change; it has no unit."""


class Contender(StrEnum):
    """The surfaces that are compared, in the order of the paper's Table 2 after its own."""

    QOVR = "qovr"
    BEZIER = "bezier"
    B_SPLINE = "b-spline"
    NURBS = "nurbs"
    CATMULL_ROM = "catmull-rom"


COMPANIONS = tuple(Contender)[1:]
"""The classical surfaces, which a net alone gives."""


@dataclass(frozen=True)
class Joints:
    """What jumps where two polynomials meet, the largest value along all interior joints.

    Parameters
    ----------
    tangent : angle in degrees between the tangents of the parameter lines that cross the joint
    curvature : length of the jump of their curvature vector, in 1 / length
    """

    tangent: float
    curvature: float


@dataclass(frozen=True)
class Measures:
    """What is measured of one surface; lengths are in the net's units.

    Parameters
    ----------
    largest_motion : the largest displacement when the chosen point moves
    shares : parts of the area of the unmoved surface displaced by more than each of ``SHARES`` of the largest
        displacement; NaN where the surface has no area
    edge_motion : largest displacement on each edge
    corner_motion : (2, 2) displacement of the corners, indexed [u, v]
    distance_from_points : largest distance of the nine inner control points from the surface
    joints : the jumps at the interior joints; None where the surface has none
    bending_energy : integral of k_1^2 + k_2^2 over the area, without a unit; NaN where it does not converge, as
        where the surface folds back or has no area
    distance_from_qovr : largest distance of a point of this surface from the QOVR surface
    distance_of_qovr : largest distance of a point of the QOVR surface from this one
    """

    largest_motion: float
    shares: tuple[float, ...]
    edge_motion: dict[Edge, float]
    corner_motion: Array
    distance_from_points: float
    joints: Joints | None
    bending_energy: float
    distance_from_qovr: float
    distance_of_qovr: float


@dataclass(frozen=True)
class Trial:
    """A document and the one motion under which every surface is measured.

    Parameters
    ----------
    document : its net is compared; its formulation gives the QOVR surface, in the layer that lies on the net
    point : (i, j) of the point that moves, and that has the weight in the NURBS surface
    weight : of that point in the NURBS surface, where every other one has 1

    Raises
    ------
    DocumentError : there is no such point, or the weight is not positive and finite
    EvaluationError : all control points are in one place, so that no length measures the motion
    """

    document: Document
    point: tuple[int, int] = DEFAULT_POINT
    weight: float = DEFAULT_WEIGHT

    def __post_init__(self) -> None:
        if not (len(self.point) == 2 and all(index in range(NET_SIZE) for index in self.point)):
            raise DocumentError("the point", described(list(self.point)), "i and j, each from 0 to 4")
        if not (isfinite(self.weight) and self.weight > 0):
            raise DocumentError("the weight", described(self.weight), "a positive number")
        if self.net_size == 0:
            raise EvaluationError("the control points all lie in one place; expected a net of some size to compare")

    @property
    def net_size(self) -> float:
        """The diagonal of the control points' box."""
        return float(np.linalg.norm(np.ptp(self.document.control_points.reshape(-1, 3), axis=0)))

    @property
    def step(self) -> float:
        """How far the chosen point moves, along z."""
        return MOVE * self.net_size

    @property
    def moved_document(self) -> Document:
        """The document with the chosen point moved."""
        net = self.document.control_points.copy()
        net[(*self.point, 2)] += self.step
        return set_points(self.document, net)

    def surface(self, contender: Contender, *, moved: bool = False) -> ParametricSurface:
        """Return one of the surfaces, before or after the motion; T is computed again after it, as always.

        Raises
        ------
        EvaluationError : the QOVR surface has no finite coordinates
        """
        document = self.moved_document if moved else self.document
        if contender is Contender.QOVR:
            return align_patch(document).layer_patch(default_layer(document))
        return companion(contender, document.control_points, self.point, self.weight)


@dataclass(frozen=True)
class Comparison:
    """All surfaces of one net, measured alike."""

    trial: Trial
    measures: dict[Contender, Measures]


def companion(
    contender: Contender, net: Array, point: tuple[int, int] = DEFAULT_POINT, weight: float = DEFAULT_WEIGHT
) -> TensorSurface:
    """Return a classical surface of a net (5, 5, 3); the point and its weight shape the NURBS surface alone."""
    weights = np.ones((NET_SIZE, NET_SIZE))
    weights[point] = weight
    surfaces = {
        Contender.BEZIER: bezier,
        Contender.B_SPLINE: b_spline,
        Contender.NURBS: lambda net: nurbs(net, weights),
        Contender.CATMULL_ROM: catmull_rom,
    }
    return surfaces[contender](net)


def compare(document: Document, point: tuple[int, int] = DEFAULT_POINT, weight: float = DEFAULT_WEIGHT) -> Comparison:
    """Measure the QOVR surface of a document and the classical surfaces of its net (the paper's Table 2).

    Parameters and errors are those of ``Trial``.
    """
    trial = Trial(document, point, weight)
    return Comparison(trial, {found[0]: found[1] for found in comparison_steps(trial) if found is not None})


def comparison_steps(trial: Trial) -> Iterator[tuple[Contender, Measures] | None]:
    """Measure one surface after the other, in pieces of some ten milliseconds that end with None."""
    qovr = trial.surface(Contender.QOVR)
    for contender in Contender:
        measures = yield from _measure(trial, contender, qovr)
        yield contender, measures


def _measure(trial: Trial, contender: Contender, qovr: ParametricSurface) -> Generator[None, None, Measures]:
    """Measure one surface, piece by piece."""
    surface, moved = (trial.surface(contender, moved=moved) for moved in (False, True))
    u = np.linspace(0.0, 1.0, _MOTION_SAMPLES)
    motion = np.linalg.norm(moved.points(u, u) - surface.points(u, u), axis=2)
    areas = _areas(surface, u)
    yield
    inner = trial.document.control_points[1:-1, 1:-1].reshape(-1, 3)
    breaks = interior_joints(surface)
    from_points, jumps = closest_points(surface, inner).distance.max(), joints(surface, breaks)
    energy = bending_energy(surface, breaks)
    yield
    from_qovr = 0.0 if contender is Contender.QOVR else largest_distance(surface, qovr)
    yield
    of_qovr = 0.0 if contender is Contender.QOVR else largest_distance(qovr, surface)
    return Measures(
        largest_motion=float(motion.max()),
        shares=_shares(motion, areas),
        edge_motion=_edge_motion(motion),
        corner_motion=read_only(motion[[[0], [-1]], [0, -1]]),
        distance_from_points=float(from_points),
        joints=jumps,
        bending_energy=energy,
        distance_from_qovr=from_qovr,
        distance_of_qovr=of_qovr,
    )


def interior_joints(surface: ParametricSurface) -> tuple[Array, Array]:
    """Return the parameters in u and in v inside (0, 1) where a surface is joined of several polynomials."""
    if isinstance(surface, TensorSurface):
        return surface.breaks
    return np.empty(0), np.empty(0)


def largest_distance(surface: ParametricSurface, other: ParametricSurface) -> float:
    """Return the largest distance of a surface from another.

    It is that of 33 x 33 of its points, border and corners included, and of a finer grid around the farthest.
    """
    u = np.linspace(0.0, 1.0, _DISTANCE_SAMPLES)
    distance = _distances(surface, other, u, u)
    farthest = np.unravel_index(distance.argmax(), distance.shape)
    finer = (
        np.linspace(u[max(k - 1, 0)], u[min(k + 1, _DISTANCE_SAMPLES - 1)], _FINER_SAMPLES) for k in map(int, farthest)
    )
    return float(_distances(surface, other, *finer).max())


def _distances(surface: ParametricSurface, other: ParametricSurface, u: Array, v: Array) -> Array:
    """Return the distance of a surface's points on a grid from another surface, (n, m)."""
    distance = closest_points(other, surface.points(u, v).reshape(-1, 3)).distance
    return distance.reshape(len(u), len(v))


def bending_energy(surface: ParametricSurface, breaks: tuple[Array, Array]) -> float:
    """Return the integral of k_1^2 + k_2^2 over the area, by Gauss-Legendre quadrature on every piece.

    Parameters
    ----------
    breaks : the joints of the pieces inside (0, 1), in u and in v

    Returns
    -------
    a number without a unit, settled to 1e-6 under doubled nodes; NaN where it does not settle, as at a fold, where
    the integral is infinite, or where the surface has no area
    """
    nodes, before = _FIRST_NODES, np.nan
    while nodes <= _MOST_NODES:
        energy = _energy(surface, breaks, nodes)
        if abs(energy - before) <= _ENERGY_SETTLED * max(energy, 8 * np.pi):
            return energy
        nodes, before = 2 * nodes, energy
    return np.nan


def _energy(surface: ParametricSurface, breaks: tuple[Array, Array], nodes: int) -> float:
    (u, weights_u), (v, weights_v) = (_piecewise_nodes(joints, nodes) for joints in breaks)
    curvature = surface.curvature(u, v)
    area = np.linalg.norm(np.cross(surface.derivative(u, v, 1, 0), surface.derivative(u, v, 0, 1)), axis=2)
    return float(weights_u @ ((4 * curvature.mean**2 - 2 * curvature.gaussian) * area) @ weights_v)


def _piecewise_nodes(breaks: Array, nodes: int) -> tuple[Array, Array]:
    """Return Gauss-Legendre nodes and weights over [0, 1], as many on every piece between the breaks."""
    x, weights = np.polynomial.legendre.leggauss(nodes)
    ends = [0.0, *breaks, 1.0]
    pieces = [((b - a) * (x + 1) / 2 + a, (b - a) * weights / 2) for a, b in pairwise(ends)]
    parameters, scaled = (np.concatenate(parts) for parts in zip(*pieces, strict=True))
    return parameters, scaled


def joints(surface: ParametricSurface, breaks: tuple[Array, Array]) -> Joints | None:
    """Return what jumps across the joints in u and in v; None where there are none."""
    along = np.linspace(0.0, 1.0, _JOINT_SAMPLES)
    lines = [_line_across(surface, at, along, axis) for axis in (0, 1) for at in breaks[axis]]
    if not lines:
        return None
    angle, jump = np.max(lines, axis=0)
    return Joints(float(angle), float(jump))


def _line_across(surface: ParametricSurface, at: float, along: Array, axis: int) -> tuple[float, float]:
    """Return the largest angle and jump of curvature of the parameter lines that cross one joint."""
    sides = np.array([np.nextafter(at, 0.0), at])  # a joint belongs to the polynomial on its right

    def across(order: int) -> Array:
        if axis == 0:
            return surface.derivative(sides, along, order, 0)
        return surface.derivative(along, sides, 0, order).swapaxes(0, 1)

    first, second = across(1), across(2)
    speed = np.linalg.norm(first, axis=-1, keepdims=True)
    tangent = first / np.where(speed > 0, speed, 1.0)
    bend = second - np.einsum("sni,sni->sn", second, tangent)[..., None] * tangent
    curvature = bend / np.where(speed > 0, speed, 1.0) ** 2
    sine = np.linalg.norm(np.cross(*tangent), axis=-1)
    cosine = np.einsum("ni,ni->n", *tangent)
    angle = np.degrees(np.arctan2(sine, cosine)).max()
    return float(angle), float(np.linalg.norm(curvature[1] - curvature[0], axis=-1).max())


def _areas(surface: ParametricSurface, parameters: Array) -> Array:
    """Return the area that belongs to each sample of a grid, by the trapezoidal rule."""
    normal = np.cross(
        surface.derivative(parameters, parameters, 1, 0), surface.derivative(parameters, parameters, 0, 1)
    )
    weights = np.full(len(parameters), 1 / (len(parameters) - 1))
    weights[[0, -1]] /= 2
    areas: Array = np.linalg.norm(normal, axis=2) * weights[:, None] * weights
    return areas


def _shares(motion: Array, areas: Array) -> tuple[float, ...]:
    total = areas.sum()
    if total == 0:
        return (np.nan,) * len(SHARES)
    return tuple(float(areas[motion > share * motion.max()].sum() / total) for share in SHARES)


def _edge_motion(motion: Array) -> dict[Edge, float]:
    edges: dict[Edge, Array] = {Edge.U0: motion[0], Edge.U1: motion[-1], Edge.V0: motion[:, 0], Edge.V1: motion[:, -1]}
    return {edge: float(values.max()) for edge, values in edges.items()}
