"""The classical surfaces of the same control net, which the paper's Table 2 sets beside its own: one record each."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from qovr_core.arrays import Array
from qovr_core.document import NetIndex
from qovr_core.geometry.differential import ParametricSurface
from qovr_core.laboratory.splines import b_spline, bezier, catmull_rom, nurbs
from qovr_core.registry import Record, Registry


@dataclass(frozen=True, eq=False)
class ComparisonSurface(Record):
    """A surface that a control net alone gives, to be compared with the QOVR surface.

    Parameters
    ----------
    name : in commands and files
    title : for people
    description : what surface it is, in one sentence
    build : called with a net (k, l, 3), the chosen point (i, j) and its weight, which a surface without weights does
        not heed; every other point has the weight 1
    """

    name: str
    title: str
    description: str
    build: Callable[[Array, NetIndex, float], ParametricSurface]

    table: ClassVar[Registry[ComparisonSurface]]


COMPARISON_SURFACES = ComparisonSurface.table = Registry[ComparisonSurface]("comparison surface")
"""All comparison surfaces, in the order of the paper's Table 2."""


def _with_weight(net: Array, point: NetIndex, weight: float) -> ParametricSurface:
    weights = np.ones(net.shape[:2])
    weights[point] = weight
    return nurbs(net, weights)


for _surface in (
    ComparisonSurface(
        "bezier",
        "Bezier",
        "The bi-quartic Bezier surface of the net: one polynomial.",
        lambda net, _point, _weight: bezier(net),
    ),
    ComparisonSurface(
        "b-spline",
        "B-spline",
        "The clamped uniform bi-cubic B-spline surface of the net: 2 x 2 polynomials, C2.",
        lambda net, _point, _weight: b_spline(net),
    ),
    ComparisonSurface(
        "nurbs",
        "NURBS",
        "The B-spline surface with a weight of its own for the chosen point; all other weights are 1.",
        _with_weight,
    ),
    ComparisonSurface(
        "catmull-rom",
        "Catmull-Rom",
        "The uniform Catmull-Rom surface: 2 x 2 bi-cubic patches through the inner nine points, C1.",
        lambda net, _point, _weight: catmull_rom(net),
    ),
):
    COMPARISON_SURFACES.register(_surface)
COMPARISON_SURFACES.seal()
