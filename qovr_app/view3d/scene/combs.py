"""Curvature combs on isolines of the surface: teeth and the lines along their tips, in the unit space."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from qovr_app.view3d.scene.grid import parameters, shared_grid
from qovr_app.view3d.scene.scene import Scene
from qovr_core.arrays import Array, read_only
from qovr_core.geometry.combs import ISOLINES, curvature_vectors

_GAPS = 48
"""Between the teeth of one comb, at least; every window of a net has as many, and teeth of its own at its ends."""

_LONGEST = 0.4
"""The longest tooth of all in the unit space, whose axes box is about 2 wide, at scale 1."""


@dataclass(frozen=True, eq=False)
class Combs:
    """The combs of the isolines along one parameter.

    Parameters
    ----------
    teeth : (k, 2, 3) from the surface to the tips
    tips : (m, n, 3) the line along the tips of each isoline
    """

    teeth: Array
    tips: Array


def combs_along(scene: Scene, *, is_u: bool, scale: float) -> Combs:
    """Return the combs along u or v; computed once a scene and scale.

    Curvature is that of the surface in the document's units; teeth are drawn in the axes' scales, as all else is.
    """
    if ("combs", is_u, scale) not in scene.cache:
        scene.cache["combs", is_u, scale] = _made(scene, is_u, scale)
    found: Combs = scene.cache["combs", is_u, scale]
    return found


def _made(scene: Scene, is_u: bool, scale: float) -> Combs:
    few = [np.linspace(*ends, ISOLINES) for ends in scene.surface.domain]
    many = parameters(scene.surface, shared_grid(scene.surface, (_GAPS, _GAPS)))
    feet, vectors = [], []
    for along in (True, False):  # one scale for both, so that their teeth can be compared
        u, v = (many[0], few[1]) if along else (few[0], many[1])
        first, second = (scene.surface.derivative(u, v, *((k, 0) if along else (0, k))) for k in (1, 2))
        places, curvature = scene.surface.points(u, v), curvature_vectors(first, second) * scene.frame.scale
        turned = (1, 0, 2) if along else (0, 1, 2)
        feet.append(scene.frame.to_unit(places).transpose(turned))
        vectors.append(np.where(np.isfinite(curvature), curvature, 0.0).transpose(turned))
    longest = max(float(np.linalg.norm(each, axis=-1).max()) for each in vectors)
    on, teeth = feet[not is_u], vectors[not is_u]
    tips = on - teeth * (scale * _LONGEST / longest if longest > 0 else 0.0)
    return Combs(read_only(np.stack([on, tips], axis=2).reshape(-1, 2, 3)), read_only(tips))
