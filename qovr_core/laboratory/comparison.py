"""The paper's Table 2 in numbers: the QOVR surface and the classical surfaces of the same net, measured alike."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from qovr_core.arrays import Array, read_only
from qovr_core.checks import LARGEST_MAGNITUDE, described
from qovr_core.document import Document, NetIndex
from qovr_core.edits import set_point
from qovr_core.errors import DocumentError, EvaluationError
from qovr_core.evaluation import Evaluation
from qovr_core.geometry.closest import ClosestSearch
from qovr_core.geometry.differential import ParametricSurface
from qovr_core.geometry.edges import Edge
from qovr_core.geometry.rounding import in_own_unit
from qovr_core.laboratory.comparison_surfaces import COMPARISON_SURFACES
from qovr_core.laboratory.own_unit import document_in_own_unit
from qovr_core.laboratory.shape_measures import Joints, bending_energy, joints, largest_distance

DEFAULT_POINT = (2, 2)
DEFAULT_WEIGHT = 4.0
"""Weight of the chosen point in the NURBS surface; 1 would give the B-spline, 4 draws it visibly toward the point."""

MOVE = 0.1
"""The chosen point moves along z by this part of the net's size."""

SHARES = (0.01, 0.10)
"""A point of the surface counts as moved beyond these parts of the largest displacement."""

_MOTION_SAMPLES = 201
"""Samples each way of the displacement: a share of the area is then told to about half a percent."""


REFERENCE = "qovr"
"""Name of the document's own surface, the reference surface with which the others are compared."""


@dataclass(frozen=True)
class Motion:
    """What moves of a surface when one point does; lengths are in the net's units.

    Parameters
    ----------
    largest_motion : the largest displacement
    shares : parts of the area of the unmoved surface displaced by more than each of ``SHARES`` of the largest
        displacement; NaN where the surface has no area
    edge_motion : largest displacement on each edge
    corner_motion : (2, 2) displacement of the corners, indexed [u, v]
    """

    largest_motion: float
    shares: tuple[float, ...]
    edge_motion: dict[Edge, float]
    corner_motion: Array


@dataclass(frozen=True)
class Measures(Motion):
    """What is measured of one surface: what moves with the chosen point, and what follows.

    Parameters
    ----------
    distance_from_points : largest distance of the inner control points from the surface
    joints : the jumps at the interior joints; None where the surface has none
    bending_energy : integral of k_1^2 + k_2^2 over the area, without a unit; NaN where it does not converge, as
        where the surface folds back or has no area
    distance_from_qovr : largest distance of a point of this surface from the QOVR surface
    distance_of_qovr : largest distance of a point of the QOVR surface from this one
    """

    distance_from_points: float
    joints: Joints | None
    bending_energy: float
    distance_from_qovr: float
    distance_of_qovr: float


@dataclass(frozen=True)
class ComparisonInput:
    """A document and the one motion under which every surface of its net is measured.

    Parameters
    ----------
    document : its net is compared; its formulation gives the QOVR surface, in the layer that lies on the net
    point : (i, j) of the point that moves, and that has the weight in the NURBS surface
    weight : of that point in the NURBS surface, where every other one has 1

    Raises
    ------
    DocumentError : there is no such point, or the weight is not positive or beyond 1e12
    EvaluationError : all control points are in one place, so that no length measures the motion; knots so near 0 or 1
        that there is no surface to measure
    """

    document: Document
    point: NetIndex = DEFAULT_POINT
    weight: float = DEFAULT_WEIGHT

    def __post_init__(self) -> None:
        rows, columns = self.document.control_points.shape[:2]
        if not (len(self.point) == 2 and self.point[0] in range(rows) and self.point[1] in range(columns)):
            both = f"each from 0 to {rows - 1}" if rows == columns else f"below {rows} and {columns}"
            raise DocumentError("the point", described(list(self.point)), f"i and j, {both}")
        if not 0 < self.weight <= LARGEST_MAGNITUDE:
            raise DocumentError("the weight", described(self.weight), f"a positive number up to {LARGEST_MAGNITUDE:g}")
        if self.document.net_size == 0:
            place = ", ".join(f"{value:.6g}" for value in self.document.control_points[0, 0] + 0.0)
            raise EvaluationError(
                f"the control points all lie in one place, ({place}); expected a net of some size to compare"
            )

    @property
    def step(self) -> float:
        """How far the chosen point moves, along z."""
        return MOVE * self.document.net_size

    @property
    def moved_document(self) -> Document:
        """The document with the chosen point moved."""
        moved = self.document.control_points[self.point] + [0.0, 0.0, self.step]
        return set_point(self.document, *self.point, moved)

    def surface(self, name: str, *, moved: bool = False) -> ParametricSurface:
        """Return one of the surfaces, before or after the motion; T is computed again after it, as always.

        Raises
        ------
        EvaluationError : the QOVR surface has no finite coordinates
        """
        document = self.moved_document if moved else self.document
        if name == REFERENCE:
            return Evaluation(document).layer_patch(document.formulation.resting_layer)
        return COMPARISON_SURFACES[name].build(document.control_points, self.point, self.weight)


@dataclass(frozen=True)
class Comparison:
    """All surfaces of one net, measured alike; measures by the surfaces' names, the QOVR surface first."""

    of: ComparisonInput
    measures: dict[str, Measures]


def compared_names() -> tuple[str, ...]:
    """Return the names of all surfaces that are measured, in the order in which they are shown."""
    return (REFERENCE, *COMPARISON_SURFACES)


@np.errstate(all="ignore")  # what overflows has no number, and is shown so
def compare(
    document: Document,
    point: NetIndex = DEFAULT_POINT,
    weight: float = DEFAULT_WEIGHT,
    report: Callable[[str, Measures], object] = lambda _name, _measures: None,
) -> Comparison:
    """Measure the QOVR surface of a document and the classical surfaces of its net (the paper's Table 2).

    Parameters
    ----------
    document, point, weight : as of ``ComparisonInput``
    report : called with name and measures of each surface as soon as they are known; what it raises ends the work

    Raises
    ------
    DocumentError, EvaluationError : as ``ComparisonInput`` does
    """
    of = ComparisonInput(document, point, weight)
    own_document, unit = document_in_own_unit(document)
    own = replace(of, document=own_document)
    measures: dict[str, Measures] = {}
    reference = ClosestSearch(own.surface(REFERENCE))
    for name in compared_names():
        measures[name] = _in_unit(measured(own, name, reference), unit)
        report(name, measures[name])
    return Comparison(of, measures)


def _in_unit(own: Measures, unit: float) -> Measures:
    """Return what is measured in a document's own unit in the unit that it was asked in."""
    jumps = own.joints and replace(own.joints, curvature=own.joints.curvature / unit)
    return replace(
        own,
        largest_motion=own.largest_motion * unit,
        edge_motion={edge: motion * unit for edge, motion in own.edge_motion.items()},
        corner_motion=read_only(own.corner_motion * unit),
        distance_from_points=own.distance_from_points * unit,
        joints=jumps,
        distance_from_qovr=own.distance_from_qovr * unit,
        distance_of_qovr=own.distance_of_qovr * unit,
    )


def measured(of: ComparisonInput, name: str, reference: ClosestSearch) -> Measures:
    """Measure one surface; ``reference`` searches the QOVR surface."""
    is_other = name != REFERENCE
    search = ClosestSearch(of.surface(name)) if is_other else reference
    surface = search.surface
    motion = motion_between(surface, of.surface(name, moved=True))
    inner = of.document.control_points[1:-1, 1:-1].reshape(-1, 3)
    return Measures(
        **vars(motion),
        distance_from_points=float(search(inner).distance.max()),
        joints=joints(surface),
        bending_energy=bending_energy(in_own_unit(surface)[0]),
        distance_from_qovr=largest_distance(surface, reference) if is_other else 0.0,
        distance_of_qovr=largest_distance(reference.surface, search) if is_other else 0.0,
    )


def motion_between(surface: ParametricSurface, moved: ParametricSurface) -> Motion:
    """Return how far each point of a surface is from the one with its parameters on another."""
    u = np.linspace(0.0, 1.0, _MOTION_SAMPLES)
    in_unit, unit = in_own_unit(surface)
    motion = np.linalg.norm((moved.points(u, u) - surface.points(u, u)) / unit, axis=2) * unit
    return Motion(
        largest_motion=float(motion.max()),
        shares=_shares(motion, _areas(in_unit, u)),
        edge_motion=_edge_motion(motion),
        corner_motion=read_only(motion[[[0], [-1]], [0, -1]]),
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
    return {edge: float(motion[edge.position].max()) for edge in Edge}
