"""Waves of a surface, counted: how often the curvature of its isolines changes sign."""

from __future__ import annotations

import numpy as np

from qovr_core.arrays import Array
from qovr_core.construction import build_patch
from qovr_core.document import Document
from qovr_core.geometry.differential import ParametricSurface
from qovr_core.geometry.rounding import ROUNDING, largest
from qovr_core.laboratory.measurement import Measurement
from qovr_core.laboratory.splines import catmull_rom

ISOLINES = 9
"""Isolines looked at in each direction."""

_ALONG = 81
"""Places on each."""

DEAD_BAND = 0.01
"""Curvature below this part of the largest counts as straight, so that a nearly flat stretch shows no waves."""


def fairness(document: Document) -> Measurement:
    """The surface has no wave-like artifacts (abstract, 5.3): no more waves than Catmull-Rom has on the same net."""
    own = sign_changes(build_patch(document))
    others = sign_changes(catmull_rom(document.control_points))
    return Measurement(
        value=float(own),
        what=f"changes of sign of the normal curvature along {2 * ISOLINES} isolines",
        holds=own <= others,
        note=f"Catmull-Rom on the same net has {others}",
    )


def sign_changes(surface: ParametricSurface) -> int:
    """Return how often the normal curvature changes its sign along isolines of both directions.

    The sign is that of S_uu . (S_u x S_v) along v = const and of S_vv . (S_u x S_v) along u = const, which an affine
    map with positive determinant, as T is, only scales: the raw and the transformed surface have the same count.
    """
    across, along = np.linspace(0, 1, ISOLINES), np.linspace(0, 1, _ALONG)
    along_u = _bending(surface, along, across, (2, 0)).T
    along_v = _bending(surface, across, along, (0, 2))
    return sum(_changes_of_a_line(line) for bending in (along_u, along_v) for line in bending)


def _bending(surface: ParametricSurface, u: Array, v: Array, order: tuple[int, int]) -> Array:
    """Return the second derivative's part along the normal, not normalised, with what counts as straight set to 0."""
    su, sv = surface.derivative(u, v, 1, 0), surface.derivative(u, v, 0, 1)
    second = surface.derivative(u, v, *order)
    bending: Array = np.einsum("...k,...k", np.cross(su, sv), second)
    possible = largest(su) * largest(sv) * largest(surface.points(u, v))
    straight = max(DEAD_BAND * largest(bending), ROUNDING * possible)
    return np.where(np.abs(bending) <= straight, 0.0, bending)


def _changes_of_a_line(bending: Array) -> int:
    signs = np.sign(bending[bending != 0])
    return int((signs[1:] != signs[:-1]).sum())
