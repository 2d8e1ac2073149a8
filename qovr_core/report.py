"""What ``qovr info`` says of a document."""

from __future__ import annotations

from typing import Any

from qovr_core.document import Document
from qovr_core.edits import knots_of
from qovr_core.evaluation import Evaluation
from qovr_core.formulations import FORMULATIONS
from qovr_core.geometry.knots import Direction, KnotPlace


def surface_facts(evaluation: Evaluation) -> dict[str, Any]:
    """Return boxes, matrix, degree and knots out of range of a configured surface, ready for JSON."""
    document = evaluation.document
    return {
        "formulation": str(document.formulation),
        "samples": list(document.samples),
        "degree": list(evaluation.patch.degree),
        "control_box": evaluation.control_box.tolist(),
        "raw_box": evaluation.raw_box.tolist(),
        "exact_raw_box": evaluation.patch.bounding_box().tolist(),
        "matrix": evaluation.matrix.tolist(),
        "flat_axes": list(evaluation.flat_axes),
        "not_monotone": not_monotone(document),
        "without_effect": [
            f"{direction}[{curve}]"
            for direction in Direction
            for curve in range(len(knots_of(document, direction)))
            if not document.formulation.is_active(direction, curve)
        ],
    }


def not_monotone(document: Document) -> list[str]:
    """Return the places of the s knots whose transformation s(u) folds back, as ``row_knots[2].s``."""
    return [
        str(KnotPlace(direction, curve, "s"))
        for direction in Direction
        for curve, knots in enumerate(knots_of(document, direction))
        if not knots.is_monotone
    ]


def facts_text(facts: dict[str, Any]) -> str:
    """Return the facts as lines for people."""
    n, m = facts["samples"]
    degree_u, degree_v = facts["degree"]
    lines = [
        f"formulation      {facts['formulation']}",
        f"samples          {n} x {m}",
        f"degree           {degree_u} in u, {degree_v} in v",
        *_box_lines("control points", facts["control_box"]),
        *_box_lines("raw, sampled", facts["raw_box"]),
        *_box_lines("raw, exact", facts["exact_raw_box"]),
        "matrix T",
        *("  " + " ".join(f"{value:>18.12g}" for value in row) for row in facts["matrix"]),
    ]
    if facts["flat_axes"]:
        lines.append(
            f"flat             the raw surface has no extent along {', '.join(facts['flat_axes'])}: T only moves there"
        )
    if facts["without_effect"]:
        formulation = FORMULATIONS[facts["formulation"]]
        names = [name for direction in Direction for name in formulation.active_names(direction)]
        entering = f"{', '.join(names)} {'enters' if len(names) == 1 else 'enter'}"
        lines.append(
            f"without effect   {', '.join(facts['without_effect'])}: only {entering} the {formulation} formulation"
        )
    folding = ", ".join(facts["not_monotone"]) or "none"
    lines.append(f"folding back     {folding}")
    return "\n".join(lines)


def _box_lines(title: str, box: list[list[float]]) -> list[str]:
    return [
        f"box {title}",
        *(f"  {axis}  {low:>18.12g} {high:>18.12g}" for axis, (low, high) in zip("xyz", box, strict=True)),
    ]
