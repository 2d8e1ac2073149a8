"""What ``qovr compare`` and the editor's table say of a comparison."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from enum import Enum
from math import degrees, isfinite
from typing import Any

from qovr_core.geometry.edges import Edge
from qovr_core.geometry.rounding import LEAST_NOISE
from qovr_core.laboratory.comparison import REFERENCE, SHARES, Comparison, ComparisonInput, Measures
from qovr_core.laboratory.comparison_surfaces import COMPARISON_SURFACES
from qovr_core.number_texts import percent_text

_REFERENCE_TITLE = "QOVR"
_REFERENCE_DESCRIPTION = "The document's own surface, in the layer that lies on the net."


def surface_titles() -> dict[str, str]:
    """Return what people read of each surface that is compared, by its name."""
    return {REFERENCE: _REFERENCE_TITLE, **{name: surface.title for name, surface in COMPARISON_SURFACES.items()}}


def surface_descriptions() -> dict[str, str]:
    """Return what each surface is, in one sentence, by its name."""
    others = {name: surface.description for name, surface in COMPARISON_SURFACES.items()}
    return {REFERENCE: _REFERENCE_DESCRIPTION, **others}


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
    """One measure: what it is called, what it means, its unit, and its value, None where there are no joints.

    The less of it the better where ``is_better_small``; of the others it cannot be said.
    """

    label: str
    explanation: str
    unit: Unit
    value: Callable[[Measures], float | None]
    is_better_small: bool = True

    def text(self, measures: Measures, net_size: float) -> str:
        """Return the value as it is shown; what is rounding for a net of that size is 0."""
        value = self.value(measures)
        if value is None:
            return NO_JOINTS
        if not isfinite(value):
            return NO_NUMBER
        if self.unit is Unit.SHARE:
            return f"{100 * value:.1f} %"
        sizes = {Unit.LENGTH: net_size, Unit.CURVATURE: 1 / max(net_size, LEAST_NOISE), Unit.DEGREES: degrees(1)}
        return "0" if abs(value) <= _ROUNDING * sizes.get(self.unit, 1.0) else f"{value:.4g}"


def _share_row(index: int, share: float) -> Row:
    explanation = f"Part of the area that moves by more than {percent_text(share)} of the largest displacement."
    return Row(f"area moved > {percent_text(share)}", explanation, Unit.SHARE, lambda measures: measures.shares[index])


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
        is_better_small=False,
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
        is_better_small=False,
    ),
    Row(
        "QOVR farthest from it",
        "The largest distance of a point of the QOVR surface from this one.",
        Unit.LENGTH,
        lambda measures: measures.distance_of_qovr,
        is_better_small=False,
    ),
)
"""The measures, in the order in which they are shown."""


def motion_text(of: ComparisonInput) -> str:
    """Return the sentence that says what moves, and how the NURBS surface is weighted."""
    i, j = of.point
    return (
        f"P_{i},{j} moves by {of.step:.4g} along z, a tenth of the net's size; "
        f"its weight in the NURBS surface is {of.weight:g}."
    )


def comparison_text(comparison: Comparison) -> str:
    """Return the table for people, at most 100 columns wide."""
    of, titles = comparison.of, surface_titles()
    formulation, size = of.document.formulation, of.document.net_size
    widest = max(len(row.label) for row in ROWS)
    lines = [
        motion_text(of),
        f"QOVR is the {formulation} surface, {formulation.resting_layer}. Lengths are in the net's units.",
        "Areas move by more than 1 % and 10 % of the largest displacement; jumps are at interior joints.",
        "",
        " " * widest + "".join(f"{titles[name]:>13}" for name in comparison.measures),
    ]
    for row in ROWS:
        texts = [row.text(measures, size) for measures in comparison.measures.values()]
        lines.append(f"{row.label:<{widest}}" + "".join(f"{text:>13}" for text in texts))
    return "\n".join(lines)


def copied_rows(comparison: Comparison) -> list[list[str | float]]:
    """Return the table for a spreadsheet: every number in full, an empty cell for none."""
    columns, titles = comparison.measures, surface_titles()
    rows: list[list[str | float]] = [[motion_text(comparison.of)], ["measure", *(titles[name] for name in columns)]]
    for row in ROWS:
        values = (row.value(measures) for measures in columns.values())
        rows.append([row.label, *("" if value is None or not isfinite(value) else value for value in values)])
    return rows


def comparison_facts(comparison: Comparison) -> dict[str, Any]:
    """Return the whole comparison, ready for JSON; None stands for what has no number."""
    of = comparison.of
    return {
        "formulation": str(of.document.formulation),
        "layer": str(of.document.formulation.resting_layer),
        "point": list(of.point),
        "weight": of.weight,
        "net_size": of.document.net_size,
        "step": of.step,
        "surfaces": {name: _facts(measures) for name, measures in comparison.measures.items()},
    }


def _facts(measures: Measures) -> dict[str, Any]:
    joints = measures.joints
    return {
        "largest_displacement": _finite(measures.largest_motion),
        "area_moved": {f"{share:g}": _finite(part) for share, part in zip(SHARES, measures.shares, strict=True)},
        "edge_motion": {str(edge): _finite(motion) for edge, motion in measures.edge_motion.items()},
        "corner_motion": [[_finite(motion) for motion in side] for side in measures.corner_motion.tolist()],
        "distance_from_inner_points": _finite(measures.distance_from_points),
        "tangent_jump_degrees": None if joints is None else _finite(joints.tangent),
        "curvature_jump": None if joints is None else _finite(joints.curvature),
        "bending_energy": _finite(measures.bending_energy),
        "distance_from_qovr": _finite(measures.distance_from_qovr),
        "distance_of_qovr": _finite(measures.distance_of_qovr),
    }


def _finite(value: float) -> float | None:
    return value if isfinite(value) else None
