"""Another surface of the same control net, shown beside or over the document's own."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from qovr_app.state.display import Placement
from qovr_app.view3d.scene.scene import Scene
from qovr_core import Document, ParametricSurface
from qovr_core.arrays import Array, read_only
from qovr_core.document import NetIndex, Window
from qovr_core.geometry.alignment import bounding_box
from qovr_core.geometry.windows import net_windows
from qovr_core.laboratory.comparison_surfaces import ComparisonSurface

OWN_NAME = "QOVR"

_BOX_SAMPLES = 33
"""Samples a side from which the other surface's box is taken: the limits of the axes are rounded outward anyway."""

_LINES = 11
"""Isoparametric lines each way of a surface over another: they show its form and let the one below be seen."""

_LINE_POINTS = 49


@dataclass(frozen=True)
class ComparisonView:
    """A kind of surface to look at beside the document's, or over it.

    Parameters
    ----------
    kind : how it is made of a control net
    placement : beside or over
    point, weight : a control point of the window, and its weight in a surface that has weights
    window : the window of the net that is compared
    """

    kind: ComparisonSurface
    placement: Placement
    point: NetIndex = (0, 0)
    weight: float = 1.0
    window: Window = (0, 0)

    @property
    def is_beside(self) -> bool:
        """Whether it has a viewport of its own."""
        return self.placement is Placement.BESIDE

    def made_of(self, document: Document) -> OtherSurface:
        """Return the surface of the control net of a window of a document."""
        net = net_windows(document.control_points)[self.window]
        return OtherSurface(self, self.kind.build(net, self.point, self.weight))


@dataclass(frozen=True, eq=False)
class OtherSurface:
    """The surface to compare with, made of one control net.

    Parameters
    ----------
    view : what it is and where it stands
    surface : in the document's units
    """

    view: ComparisonView
    surface: ParametricSurface

    @cached_property
    def box(self) -> Array:
        """Its sampled box, (3, 2) with columns min and max."""
        u, v = (np.linspace(*ends, _BOX_SAMPLES) for ends in self.surface.domain)
        return bounding_box(self.surface.points(u, v))

    def isolines(self) -> Array:
        """Return isoparametric lines, (k, n, 3): those along u, then those along v."""
        few, many = ([np.linspace(*ends, count) for ends in self.surface.domain] for count in (_LINES, _LINE_POINTS))
        along_u = self.surface.points(many[0], few[1]).transpose(1, 0, 2)
        return read_only(np.concatenate([along_u, self.surface.points(few[0], many[1])]))


def compared(own: Scene, other: OtherSurface) -> tuple[Scene, ...]:
    """Return the scenes that show a surface and another one: two, or one with the other's lines over it.

    Distances are those of each from the other; whatever else is shown, beside one another they share the limits of
    the colours, so that a colour means the same in both.
    """
    title, surface = other.view.kind.title, other.surface
    with_other = replace(own.companions, reference=surface, reference_name=title)
    if not other.view.is_beside:
        lines = read_only(own.frame.to_unit(other.isolines()))
        return (replace(own, companions=with_other, lines_name=title, lines=lines),)
    without_knot = replace(own.companions, reference=own.surface, reference_name=OWN_NAME, knot=None)
    scenes = (
        replace(own, companions=with_other, name=OWN_NAME),
        replace(
            own,
            companions=without_knot,
            name=title,
            is_comparison=True,
            patch=own.frame.laid(surface),
            surface=surface,
            surface_box=other.box,
        ),
    )
    for scene, peer in zip(scenes, scenes[::-1], strict=True):
        scene.peers.add(peer)
    return scenes
