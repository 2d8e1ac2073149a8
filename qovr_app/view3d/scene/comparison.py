"""Another surface of the same control net, shown beside or over the document's own."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from qovr_app.state.display import Placement
from qovr_app.view3d.scene.scene import Scene
from qovr_core import Document, ParametricSurface
from qovr_core.arrays import Array, read_only
from qovr_core.geometry.alignment import bounding_box

OWN_NAME = "QOVR"

_BOX_SAMPLES = 33
"""Samples a side from which a rival's box is taken: the limits of the axes are rounded outward anyway."""

_LINES = 11
"""Isoparametric lines each way of a rival over the surface: they show its form and let the surface be seen."""

_LINE_POINTS = 49


@dataclass(frozen=True)
class Rival:
    """A kind of surface to look at beside the document's, or over it.

    Parameters
    ----------
    name : what the picture calls it
    surface_of : gives the surface, in the document's units, of a document's control net
    placement : beside or over
    """

    name: str
    surface_of: Callable[[Document], ParametricSurface]
    placement: Placement

    @property
    def is_beside(self) -> bool:
        """Whether it has a viewport of its own."""
        return self.placement is Placement.BESIDE


@dataclass(frozen=True, eq=False)
class RivalSurface:
    """A rival's surface for one document, in the document's units.

    Parameters
    ----------
    rival : what it is
    surface : the surface
    """

    rival: Rival
    surface: ParametricSurface

    @cached_property
    def box(self) -> Array:
        """Its sampled box, (3, 2) with columns min and max."""
        samples = np.linspace(0.0, 1.0, _BOX_SAMPLES)
        return bounding_box(self.surface.points(samples, samples))

    def isolines(self) -> Array:
        """Return isoparametric lines, (k, n, 3): those along u, then those along v."""
        few, many = np.linspace(0.0, 1.0, _LINES), np.linspace(0.0, 1.0, _LINE_POINTS)
        along_u = self.surface.points(many, few).transpose(1, 0, 2)
        return read_only(np.concatenate([along_u, self.surface.points(few, many)]))


def face_rival(own: Scene, opposite: RivalSurface) -> tuple[Scene, ...]:
    """Return the scenes that show a surface and its rival: two, or one with the rival's lines over it.

    Distances are those of each from the other; whatever else is shown, beside one another they share the limits of
    the colours, so that a colour means the same in both.
    """
    rival, surface = opposite.rival, opposite.surface
    with_rival = replace(own.companions, reference=surface, reference_name=rival.name)
    if not rival.is_beside:
        lines = read_only(own.frame.to_unit(opposite.isolines()))
        return (replace(own, companions=with_rival, rival_name=rival.name, rival_lines=lines),)
    without_knot = replace(own.companions, reference=own.surface, reference_name=OWN_NAME, knot=None)
    scenes = (
        replace(own, companions=with_rival, name=OWN_NAME),
        replace(
            own,
            companions=without_knot,
            name=rival.name,
            is_rival=True,
            patch=surface.transformed(own.frame.matrix),
            surface=surface,
            surface_box=opposite.box,
        ),
    )
    for scene, other in zip(scenes, scenes[::-1], strict=True):
        scene.peers.append(other)
    return scenes
