"""What ``qovr info`` says of a document."""

from __future__ import annotations

from typing import Any

import numpy as np

from qovr_core.construction import active_curves
from qovr_core.document import Document
from qovr_core.edits import knots_of
from qovr_core.evaluation import Evaluation
from qovr_core.formulations import FORMULATIONS
from qovr_core.geometry.combs import ISOLINES, families_changes, isolines
from qovr_core.geometry.folding import folding_parts, folds
from qovr_core.geometry.knots import Direction
from qovr_core.joints import Joint

MOST_NAMED = 10
"""Curves of a kind that the text names, all there are in a net of one window; a large net has thousands."""


def surface_facts(evaluation: Evaluation, most: int | None = None) -> dict[str, Any]:
    """Return windows, boxes, matrix, degree and folding curves of a configured surface, ready for JSON.

    Parameters
    ----------
    most : of how many folding curves it is said where they run back, which is exact and takes time; None for all
    """
    document = evaluation.document
    folding = _folding(document)
    return {
        "formulation": str(document.formulation),
        **net_facts(evaluation),
        "samples": list(document.samples),
        "degree": list(evaluation.patch.degree),
        "control_box": evaluation.control_box.tolist(),
        "raw_box": evaluation.raw_box.tolist(),
        "exact_raw_box": evaluation.patch.bounding_box().tolist(),
        "matrix": evaluation.matrix.tolist(),
        "flat_axes": list(evaluation.flat_axes),
        "folding": [where for place in folding[:most] if (where := _where_it_folds(document, place))["backward"]],
        "folding_count": len(folding),
        "comb_changes": fairness_facts(evaluation),
        "without_effect": [
            f"{direction}[{curve}]"
            for direction in Direction
            for curve in sorted({*range(len(knots_of(document, direction)))} - {*active_curves(document, direction)})
        ],
    }


def net_facts(evaluation: Evaluation) -> dict[str, Any]:
    """Return what a document's net is, ready for JSON: windows (m, n), and along u and v their joints and lengths."""
    document = evaluation.document
    return {
        "windows": list(document.windows),
        "joints": {way.parameter: [str(joint) for joint in document.joints.along(way)] for way in Direction},
        "lengths": {
            way.parameter: np.diff(breakpoints).tolist()
            for way, breakpoints in zip(Direction, evaluation.patch.breakpoints, strict=True)
        },
        "closed": list(document.closed),
    }


def fairness_facts(evaluation: Evaluation) -> dict[str, Any]:
    """Return the sums of comb changes of the surface in the layer that lies on the net, ready for JSON.

    ``u`` and ``v`` are sums over ``isolines`` lines along each; None stands for a line that stops.
    """
    layer = evaluation.document.formulation.resting_layer
    along_u, along_v = families_changes(*isolines(evaluation.layer_patch(layer)))
    sums = {name: float(changes.sum()) for name, changes in (("u", along_u), ("v", along_v))}
    return {
        "layer": str(layer),
        "isolines": ISOLINES,
        **{name: total if np.isfinite(total) else None for name, total in sums.items()},
    }


def _folding(document: Document) -> list[tuple[Direction, int, int]]:
    """Return the curves that fold back on evenly spaced points, each with the window in which it does."""
    return [
        (direction, curve, window)
        for direction in Direction
        for curve, window in np.argwhere(folds(knots_of(document, direction).array)).tolist()
    ]


def _where_it_folds(document: Document, place: tuple[Direction, int, int]) -> dict[str, Any]:
    """Return a folding curve's name, in a net with its window, and between which parameters there it runs back."""
    direction, curve, window = place
    knots = knots_of(document, direction)
    name = f"{direction}[{curve}]" + (f"[{window}]" if knots.windows > 1 else "")
    return {"curve": name, "backward": [list(ends) for ends in folding_parts(knots[curve, window])]}


def facts_text(facts: dict[str, Any]) -> str:
    """Return the facts as lines for people."""
    n, m = facts["samples"]
    degree_u, degree_v = facts["degree"]
    lines = [
        f"formulation      {facts['formulation']}",
        f"samples          {n} x {m}",
        *_net_lines(facts),
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
        without_effect = _named(facts["without_effect"], len(facts["without_effect"]))
        entering = f"{', '.join(names)} {'enters' if len(names) == 1 else 'enter'}"
        lines.append(f"without effect   {without_effect}: only {entering} the {formulation} formulation")
    folding = [_folding_text(**curve) for curve in facts["folding"]]
    lines.append(f"folding back     {_named(folding, facts['folding_count']) or 'none'}")
    return "\n".join(lines)


def _net_lines(facts: dict[str, Any]) -> list[str]:
    """Return what a net of more than one window has besides."""
    if facts["windows"] == [1, 1]:
        return []
    joints, lengths = (
        "; ".join(f"{name}: {say(facts[kind][name])}" for name in "uv")
        for kind, say in (("joints", _joints_text), ("lengths", _lengths_text))
    )
    formulation = FORMULATIONS[facts["formulation"]]
    apart = "" if formulation.is_continuous else f"; under {formulation} they do not meet"
    return [
        "windows          {} x {}, m along v and n along u{}".format(*facts["windows"], apart),
        f"joints           {joints}",
        f"lengths          {lengths}",
        *([f"closed along     {', '.join(facts['closed'])}"] if facts["closed"] else []),
    ]


def _joints_text(joints: list[str]) -> str:
    counts = ((kind, joints.count(kind)) for kind in Joint)
    return ", ".join(f"{count} {kind}" for kind, count in counts if count) or "none"


def _lengths_text(lengths: list[float]) -> str:
    if min(lengths) == max(lengths):
        return f"all {lengths[0]:.6g}"
    return f"{min(lengths):.6g} to {max(lengths):.6g}"


def _named(names: list[str], count: int) -> str:
    """Return the first of so many names for a line of the text, and how many more there are."""
    more = count - MOST_NAMED
    return ", ".join(names[:MOST_NAMED]) + (f" and {more} more" if more > 0 else "")


def _folding_text(curve: str, backward: list[list[float]]) -> str:
    parts = " and ".join(f"{low:.6g} to {high:.6g}" for low, high in backward)
    return f"{curve} ({Direction(curve.partition('[')[0]).parameter} from {parts})"


def _box_lines(title: str, box: list[list[float]]) -> list[str]:
    return [
        f"box {title}",
        *(f"  {axis}  {low:>18.12g} {high:>18.12g}" for axis, (low, high) in zip("xyz", box, strict=True)),
    ]
