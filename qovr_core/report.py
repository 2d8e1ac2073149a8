"""What ``qovr info`` says of a document."""

from __future__ import annotations

from typing import Any

import numpy as np

from qovr_core.document import Document
from qovr_core.edits import knots_of
from qovr_core.evaluation import Evaluation
from qovr_core.formulations import FORMULATIONS
from qovr_core.geometry.combs import ISOLINES, comb_changes, isolines
from qovr_core.geometry.folding import folding_parts, folds
from qovr_core.geometry.knots import Direction


def surface_facts(evaluation: Evaluation) -> dict[str, Any]:
    """Return boxes, matrix, degree and folding curves of a configured surface, ready for JSON."""
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
        "folding": folding_curves(document),
        "comb_changes": fairness_facts(evaluation),
        "without_effect": [
            f"{direction}[{curve}]"
            for direction in Direction
            for curve in range(len(knots_of(document, direction)))
            if not document.formulation.is_active(direction, curve)
        ],
    }


def fairness_facts(evaluation: Evaluation) -> dict[str, Any]:
    """Return the sums of comb changes of the surface in the layer that lies on the net, ready for JSON.

    ``u`` and ``v`` are sums over ``isolines`` lines along each; None stands for a line that stops.
    """
    layer = evaluation.document.formulation.resting_layer
    along_u, along_v = (comb_changes(lines) for lines in isolines(evaluation.layer_patch(layer)))
    sums = {name: float(changes.sum()) for name, changes in (("u", along_u), ("v", along_v))}
    return {
        "layer": str(layer),
        "isolines": ISOLINES,
        **{name: total if np.isfinite(total) else None for name, total in sums.items()},
    }


def folding_curves(document: Document) -> list[dict[str, Any]]:
    """Return the curves that fold back on evenly spaced points, with the parameters between which they run back."""
    return [
        {"curve": f"{direction}[{curve}]", "backward": [list(ends) for ends in parts]}
        for direction in Direction
        for curve, window in np.argwhere(folds(knots_of(document, direction).array)).tolist()
        if (parts := folding_parts(knots_of(document, direction)[curve, window]))
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
    combs = facts["comb_changes"]
    sums = (f"{name} {'infinite' if combs[name] is None else format(combs[name], '.6g')}" for name in "uv")
    lines.append(f"comb changes     {', '.join(sums)} in 1 / length, over {combs['isolines']} isolines along each")
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
    folding = [_folding_text(**curve) for curve in facts["folding"]]
    lines.append(f"folding back     {', '.join(folding) or 'none'}")
    return "\n".join(lines)


def _folding_text(curve: str, backward: list[list[float]]) -> str:
    parts = " and ".join(f"{low:.6g} to {high:.6g}" for low, high in backward)
    return f"{curve} ({Direction(curve.partition('[')[0]).parameter} from {parts})"


def _box_lines(title: str, box: list[list[float]]) -> list[str]:
    return [
        f"box {title}",
        *(f"  {axis}  {low:>18.12g} {high:>18.12g}" for axis, (low, high) in zip("xyz", box, strict=True)),
    ]
