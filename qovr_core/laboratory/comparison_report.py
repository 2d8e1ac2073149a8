"""What ``qovr compare`` and the editor's table say of a comparison."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from math import isfinite, isnan
from typing import Any

from qovr_core.laboratory.comparison import SHARES, Comparison, Contender, Measures, Trial
from qovr_core.patch import Edge
from qovr_core.pipeline import default_layer

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

_NO_JOINTS = "no joints"
_NO_NUMBER = "-"


@dataclass(frozen=True)
class Row:
    """One measure: what it is called, what it means, and its text for one surface of a net of some size."""

    label: str
    explanation: str
    text: Callable[[Measures, float], str]


def _length(get: Callable[[Measures], float]) -> Callable[[Measures, float], str]:
    return lambda measures, size: _number(get(measures), _ROUNDING * size)


def _share(index: int) -> Callable[[Measures, float], str]:
    def text(measures: Measures, _size: float) -> str:
        share = measures.shares[index]
        return _NO_NUMBER if isnan(share) else f"{100 * share:.1f} %"

    return text


def _tangent_jump(measures: Measures, _size: float) -> str:
    return _NO_JOINTS if measures.joints is None else _number(measures.joints.tangent, 60 * _ROUNDING)


def _curvature_jump(measures: Measures, size: float) -> str:
    return _NO_JOINTS if measures.joints is None else _number(measures.joints.curvature, _ROUNDING / size)


def _number(value: float, rounding: float) -> str:
    if not isfinite(value):
        return _NO_NUMBER
    return "0" if abs(value) <= rounding else f"{value:.4g}"


def _edge_row(edge: Edge) -> Row:
    explanation = "The largest displacement on this edge when the chosen point moves."
    return Row(f"motion of the edge {edge}", explanation, _length(lambda measures: measures.edge_motion[edge]))


ROWS = (
    Row(
        "largest displacement",
        "How far the surface moves where it moves most.",
        _length(lambda m: m.largest_motion),
    ),
    *(
        Row(
            f"area moved by > {100 * share:g} % of it",
            f"Part of the area that moves by more than {100 * share:g} % of the largest displacement.",
            _share(index),
        )
        for index, share in enumerate(SHARES)
    ),
    *(_edge_row(edge) for edge in Edge),
    Row(
        "motion of the corners",
        "The largest displacement of the four corners.",
        _length(lambda m: float(m.corner_motion.max())),
    ),
    Row(
        "distance from the inner points",
        "The largest distance of the nine inner control points from the surface; 0 where it runs through them.",
        _length(lambda m: m.distance_from_points),
    ),
    Row(
        "tangent jump at the joints, degrees",
        "The largest angle between the tangents of parameter lines on both sides of an interior joint.",
        _tangent_jump,
    ),
    Row(
        "curvature jump at the joints",
        "The largest jump of the curvature vector of parameter lines across an interior joint, in 1 / length.",
        _curvature_jump,
    ),
    Row(
        "bending energy",
        "The integral of k1^2 + k2^2 over the area; it has no unit, and no number where the surface folds.",
        lambda m, _size: _number(m.bending_energy, _ROUNDING),
    ),
    Row(
        "farthest from QOVR",
        "The largest distance of a point of this surface from the QOVR surface.",
        _length(lambda m: m.distance_from_qovr),
    ),
    Row(
        "QOVR farthest from it",
        "The largest distance of a point of the QOVR surface from this one.",
        _length(lambda m: m.distance_of_qovr),
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
    document, size = trial.document, trial.net_size
    widest = max(len(row.label) for row in ROWS)
    lines = [
        motion_text(trial),
        f"QOVR is the {document.formulation} surface, {default_layer(document)}. Lengths are in the net's units.",
        "",
        " " * widest + "".join(f"{NAMES[contender]:>13}" for contender in comparison.measures),
    ]
    for row in ROWS:
        texts = [row.text(measures, size) for measures in comparison.measures.values()]
        lines.append(f"{row.label:<{widest}}" + "".join(f"{text:>13}" for text in texts))
    return "\n".join(lines)


def comparison_facts(comparison: Comparison) -> dict[str, Any]:
    """Return the whole comparison, ready for JSON; None stands for what has no number."""
    trial = comparison.trial
    return {
        "formulation": str(trial.document.formulation),
        "layer": str(default_layer(trial.document)),
        "point": list(trial.point),
        "weight": trial.weight,
        "net_size": trial.net_size,
        "step": trial.step,
        "surfaces": {str(contender): _facts(measures) for contender, measures in comparison.measures.items()},
    }


def _facts(measures: Measures) -> dict[str, Any]:
    joints = measures.joints
    return {
        "largest_displacement": measures.largest_motion,
        "area_moved": {f"{share:g}": _finite(part) for share, part in zip(SHARES, measures.shares, strict=True)},
        "edge_motion": {str(edge): motion for edge, motion in measures.edge_motion.items()},
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
