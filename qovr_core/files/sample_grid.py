"""How many samples along u and along v a list of points has, where nothing says so but the points themselves."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from math import isqrt

import numpy as np

from qovr_core.arrays import Array
from qovr_core.checks import SAMPLES_RANGE
from qovr_core.construction import build_patch
from qovr_core.document import Document
from qovr_core.errors import EvaluationError
from qovr_core.formulations import FORMULATIONS
from qovr_core.geometry.patch import Patch

SAME_SURFACE = 1e-6
"""Part of the points' size within which points are those of a surface: other programs write fewer digits."""


def grid_of(document: Document, points: Array, count: int) -> tuple[int, int] | None:
    """Return the samples along u and v of points, v running fastest, by where the document's own surfaces have them.

    Parameters
    ----------
    document : the inputs that the points were computed from, under whichever formulation
    points : (k, 3), the first of them, one row of samples and one more where there are as many
    count : how many there are in all

    Returns
    -------
    the numbers whose surface the points lie on, else equal numbers, else None
    """
    grids = list(_grids(count))
    size = float(np.ptp(points, axis=0).max(initial=0.0)) or 1.0
    misses = [(_miss(patch, points, n, m), (n, m)) for patch in _patches(document) for n, m in grids]
    miss, best = min(misses, key=lambda entry: entry[0], default=(np.inf, None))
    if miss <= SAME_SURFACE * size:
        return best
    side = isqrt(count)
    return (side, side) if (side, side) in grids else None


def _grids(count: int) -> Iterator[tuple[int, int]]:
    """Yield what numbers of samples make so many points, the most equal ones first."""
    fewest, most = SAMPLES_RANGE
    for smaller in range(min(isqrt(count), most), fewest - 1, -1):
        larger, rest = divmod(count, smaller)
        if rest == 0 and larger <= most:
            yield larger, smaller
            if larger != smaller:
                yield smaller, larger


def _patches(document: Document) -> Iterator[Patch]:
    for formulation in FORMULATIONS.values():
        try:
            yield build_patch(replace(document, formulation=formulation))
        except EvaluationError:
            continue


def _miss(patch: Patch, points: Array, n: int, m: int) -> float:
    """Return how far the points next to two corners are from where samples n x m would have them."""
    places = [k for k in (0, 1, m - 1, m, m + 1) if k < len(points)]
    u, v = (np.array(parameters) for parameters in zip(*(divmod(k, m) for k in places), strict=True))
    computed = np.array([patch.points([i / (n - 1)], [j / (m - 1)])[0, 0] for i, j in zip(u, v, strict=True)])
    return float(np.abs(computed - points[places]).max())
