"""What ``qovr compare`` and the editor's table say of a comparison."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from enum import Enum
from math import degrees, isfinite
from typing import Any

from qovr_core.geometry.patch import Edge
from qovr_core.laboratory.comparison import SHARES, Comparison, Contender, Measures, Trial

NAMES = {
    Contender.QOVR: "QOVR",
    Contender.BEZIER: "Bezier",
    Contender.B_SPLINE: "B-spline",
    Contender.NURBS: "NURBS",
    Contender.CATMULL_ROM: "Catmull-Rom",
}

DESCRIPTIONS = {
    Contender.QOVR: "The document's own surface, in the layer that lies on the net.",
    Contender.BEZIER: "The bi-quartic Bezier surface of the net: one polynomial.",
    Contender.B_SPLINE: "The clamped uniform bi-cubic B-spline surface of the net: 2 x 2 polynomials, C2.",
    Contender.NURBS: "The B-spline surface with a weight of its own for the chosen point; all other weights are 1.",
    Contender.CATMULL_ROM: "The uniform Catmull-Rom surface: 2 x 2 bi-cubic patches through the inner nine points, C1.",
}

_ROUNDING = 1e-12
"""A length below this part of the net's size is rounding, and is shown as 0; so is an angle in radians."""

NO_JOINTS, NO_NUMBER = "no joints", "-"


class Unit(Enum):
    """What a measure is counted in."""

    LENGTH = "length"
    CURVATURE = "1 / length"
    DEGREES = "degrees"
    SHARE = "share"
    PURE = "pure number"


@dataclass(frozen=True)
class Row:
    """One measure: what it is called, what it means, its unit, and its value, None where there are no joints."""

    label: str
    explanation: str
    unit: Unit
    value: Callable[[Measures], float | None]

    def text(self, measures: Measures, net_size: float) -> str:
        """Return the value as it is shown; what is rounding for a net of that size is 0."""
        value = self.value(measures)
        if value is None:
            return NO_JOINTS
        if not isfinite(value):
            return NO_NUMBER
        if self.unit is Unit.SHARE:
            return f"{100 * value:.1f} %"
        rounding = {Unit.LENGTH: net_size, Unit.CURVATURE: 1 / net_size, Unit.DEGREES: degrees(1)}.get(self.unit, 1.0)
        return "0" if abs(value) <= _ROUNDING * rounding else f"{value:.4g}"


def _share_row(index: int, share: float) -> Row:
    explanation = f"Part of the area that moves by more than {100 * share:g} % of the largest displacement."
    return Row(f"area moved > {100 * share:g} %", explanation, Unit.SHARE, lambda measures: measures.shares[index])


def _edge_row(edge: Edge) -> Row:
    explanation = "The largest displacement on this edge when the chosen point moves."
    return Row(
        f"edge {str(edge).replace('=', ' = ')} moves",
        explanation,
        Unit.LENGTH,
        lambda measures: measures.edge_motion[edge],
    )


ROWS = (
    Row(
        "largest displacement",
        "How far the surface moves where it moves most.",
        Unit.LENGTH,
        lambda measures: measures.largest_motion,
    ),
    *(_share_row(index, share) for index, share in enumerate(SHARES)),
    *(_edge_row(edge) for edge in Edge),
    Row(
        "corners move",
        "The largest displacement of the four corners.",
        Unit.LENGTH,
        lambda measures: float(measures.corner_motion.max()),
    ),
    Row(
        "off the inner points",
        "The largest distance of the nine inner control points from the surface; 0 where it runs through them.",
        Unit.LENGTH,
        lambda measures: measures.distance_from_points,
    ),
    Row(
        "tangent jump, degrees",
        "The largest angle between the tangents of parameter lines on both sides of an interior joint.",
        Unit.DEGREES,
        lambda measures: None if measures.joints is None else measures.joints.tangent,
    ),
    Row(
        "curvature jump",
        "The largest jump of the curvature vector of parameter lines across an interior joint, in 1 / length.",
        Unit.CURVATURE,
        lambda measures: None if measures.joints is None else measures.joints.curvature,
    ),
    Row(
        "bending energy",
        "The integral of k1^2 + k2^2 over the area; it has no unit, and no number where the surface folds.",
        Unit.PURE,
        lambda measures: measures.bending_energy,
    ),
    Row(
        "farthest from QOVR",
        "The largest distance of a point of this surface from the QOVR surface.",
        Unit.LENGTH,
        lambda measures: measures.distance_from_qovr,
    ),
    Row(
        "QOVR farthest from it",
        "The largest distance of a point of the QOVR surface from this one.",
        Unit.LENGTH,
        lambda measures: measures.distance_of_qovr,
    ),
)
"""The measures, in the order in which they are shown."""


def motion_text(trial: Trial) -> str:
    """Return the sentence that says what moves, and how the NURBS surface is weighted."""
    i, j = trial.point
    return (
        f"P_{i},{j} moves by {trial.step:.4g} along z, a tenth of the net's size; "
        f"its weight in the NURBS surface is {trial.weight:g}."
    )


def comparison_text(comparison: Comparison) -> str:
    """Return the table for people, at most 100 columns wide."""
    trial = comparison.trial
    formulation, size = trial.document.formulation, trial.document.net_size
    widest = max(len(row.label) for row in ROWS)
    lines = [
        motion_text(trial),
        f"QOVR is the {formulation} surface, {formulation.resting_layer}. Lengths are in the net's units.",
        "Areas move by more than 1 % and 10 % of the largest displacement; jumps are at interior joints.",
        "",
        " " * widest + "".join(f"{NAMES[contender]:>13}" for contender in comparison.measures),
    ]
    for row in ROWS:
        texts = [row.text(measures, size) for measures in comparison.measures.values()]
        lines.append(f"{row.label:<{widest}}" + "".join(f"{text:>13}" for text in texts))
    return "\n".join(lines)


def copied_text(comparison: Comparison) -> str:
    """Return the table for a spreadsheet: tab separated, every number in full, an empty cell for none."""
    columns = comparison.measures
    lines = [("measure", *(NAMES[contender] for contender in columns))]
    for row in ROWS:
        values = (row.value(measures) for measures in columns.values())
        lines.append((row.label, *("" if value is None or not isfinite(value) else repr(value) for value in values)))
    return motion_text(comparison.trial) + "\n" + "".join("\t".join(line) + "\n" for line in lines)


def comparison_facts(comparison: Comparison) -> dict[str, Any]:
    """Return the whole comparison, ready for JSON; None stands for what has no number."""
    trial = comparison.trial
    return {
        "formulation": str(trial.document.formulation),
        "layer": str(trial.document.formulation.resting_layer),
        "point": list(trial.point),
        "weight": trial.weight,
        "net_size": trial.document.net_size,
        "step": trial.step,
        "surfaces": {str(contender): _facts(measures) for contender, measures in comparison.measures.items()},
    }


def _facts(measures: Measures) -> dict[str, Any]:
    joints = measures.joints
    return {
        "largest_displacement": _finite(measures.largest_motion),
        "area_moved": {f"{share:g}": _finite(part) for share, part in zip(SHARES, measures.shares, strict=True)},
        "edge_motion": {str(edge): _finite(motion) for edge, motion in measures.edge_motion.items()},
        "corner_motion": measures.corner_motion.tolist(),
        "distance_from_inner_points": measures.distance_from_points,
        "tangent_jump_degrees": None if joints is None else joints.tangent,
        "curvature_jump": None if joints is None else joints.curvature,
        "bending_energy": _finite(measures.bending_energy),
        "distance_from_qovr": measures.distance_from_qovr,
        "distance_of_qovr": measures.distance_of_qovr,
    }


def _finite(value: float) -> float | None:
    return value if isfinite(value) else None
