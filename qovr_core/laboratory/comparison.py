"""The paper's Table 2 in numbers: the QOVR surface and the classical surfaces of the same net, measured alike."""

from __future__ import annotations

from collections.abc import Generator, Iterator
from dataclasses import dataclass
from enum import StrEnum

import numpy as np

from qovr_core.arrays import Array, read_only
from qovr_core.checks import LARGEST_MAGNITUDE, described
from qovr_core.document import NET_SIZE, Document
from qovr_core.edits import set_point
from qovr_core.errors import DocumentError, EvaluationError
from qovr_core.evaluation import align_patch
from qovr_core.geometry.closest import closest_points
from qovr_core.geometry.differential import ParametricSurface
from qovr_core.geometry.patch import Edge
from qovr_core.geometry.rounding import in_own_unit
from qovr_core.laboratory.shape_measures import Joints, bending_energy, interior_joints, joints, largest_distance
from qovr_core.laboratory.splines import TensorSurface, b_spline, bezier, catmull_rom, nurbs

DEFAULT_POINT = (2, 2)
DEFAULT_WEIGHT = 4.0
"""Weight of the chosen point in the NURBS surface; 1 would give the B-spline, 4 draws it visibly toward the point."""

MOVE = 0.1
"""The chosen point moves along z by this part of the net's size."""

SHARES = (0.01, 0.10)
"""A point of the surface counts as moved beyond these parts of the largest displacement."""

_MOTION_SAMPLES = 201
"""Samples each way of the displacement: a share of the area is then told to about half a percent."""


class Contender(StrEnum):
    """The surfaces that are compared, in the order of the paper's Table 2 after its own."""

    QOVR = "qovr"
    BEZIER = "bezier"
    B_SPLINE = "b-spline"
    NURBS = "nurbs"
    CATMULL_ROM = "catmull-rom"


RIVALS = tuple(Contender)[1:]
"""The classical surfaces, which a net alone gives."""


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
    DocumentError : there is no such point, or the weight is not positive or beyond 1e12
    EvaluationError : all control points are in one place, so that no length measures the motion
    """

    document: Document
    point: tuple[int, int] = DEFAULT_POINT
    weight: float = DEFAULT_WEIGHT

    def __post_init__(self) -> None:
        if not (len(self.point) == 2 and all(index in range(NET_SIZE) for index in self.point)):
            raise DocumentError("the point", described(list(self.point)), "i and j, each from 0 to 4")
        if not 0 < self.weight <= LARGEST_MAGNITUDE:
            raise DocumentError("the weight", described(self.weight), f"a positive number up to {LARGEST_MAGNITUDE:g}")
        if self.document.net_size == 0:
            raise EvaluationError("the control points all lie in one place; expected a net of some size to compare")

    @property
    def step(self) -> float:
        """How far the chosen point moves, along z."""
        return MOVE * self.document.net_size

    @property
    def moved_document(self) -> Document:
        """The document with the chosen point moved."""
        moved = self.document.control_points[self.point] + [0.0, 0.0, self.step]
        return set_point(self.document, *self.point, moved)

    def surface(self, contender: Contender, *, moved: bool = False) -> ParametricSurface:
        """Return one of the surfaces, before or after the motion; T is computed again after it, as always.

        Raises
        ------
        EvaluationError : the QOVR surface has no finite coordinates
        """
        document = self.moved_document if moved else self.document
        if contender is Contender.QOVR:
            return align_patch(document).layer_patch(document.formulation.resting_layer)
        return rival_surface(contender, document.control_points, self.point, self.weight)


@dataclass(frozen=True)
class Comparison:
    """All surfaces of one net, measured alike."""

    trial: Trial
    measures: dict[Contender, Measures]


def rival_surface(
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
    steps = _steps(trial)
    while True:
        with np.errstate(all="ignore"):  # what overflows has no number, and is shown so
            try:
                found = next(steps)
            except StopIteration:
                return
        yield found


def _steps(trial: Trial) -> Iterator[tuple[Contender, Measures] | None]:
    qovr = trial.surface(Contender.QOVR)
    for contender in Contender:
        measures = yield from _measure(trial, contender, qovr)
        yield contender, measures


def _measure(trial: Trial, contender: Contender, qovr: ParametricSurface) -> Generator[None, None, Measures]:
    """Measure one surface, piece by piece."""
    surface, moved = (trial.surface(contender, moved=moved) for moved in (False, True))
    u = np.linspace(0.0, 1.0, _MOTION_SAMPLES)
    in_unit, unit = in_own_unit(surface)
    motion = np.linalg.norm((moved.points(u, u) - surface.points(u, u)) / unit, axis=2) * unit
    areas = _areas(in_unit, u)
    yield
    inner = trial.document.control_points[1:-1, 1:-1].reshape(-1, 3)
    breaks = interior_joints(surface)
    from_points, jumps = closest_points(surface, inner).distance.max(), joints(surface, breaks)
    energy = bending_energy(in_unit, breaks)
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
