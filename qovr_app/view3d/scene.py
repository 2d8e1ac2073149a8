"""The scene: what one viewport shows, in the unit space; made from a result, never from its samples."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Protocol

import numpy as np

from qovr_app.view3d.frame import Frame, frame_around
from qovr_app.view3d.mesh import curve_points
from qovr_app.view3d.settings import Layer, Scaling
from qovr_core import CurveNetwork, Document, Patch, curve_network
from qovr_core.arrays import Array, read_only

CURVE_POINTS = 49
"""Points a curve C_i or K_j is drawn with: no corner shows at any size that fits a screen."""

NetIndex = tuple[int, int]
"""Row i and column j of a control point."""


class Result(Protocol):
    """The part of ``qovr_core.Surface`` that the view reads: nothing of the size of the samples."""

    @property
    def document(self) -> Document: ...
    @property
    def patch(self) -> Patch: ...
    @property
    def control_box(self) -> Array: ...
    @property
    def raw_box(self) -> Array: ...
    @property
    def matrix(self) -> Array: ...


@dataclass(frozen=True, eq=False)
class Scene:
    """One layer of a result in its frame.

    Parameters
    ----------
    layer : raw or transformed
    frame : the axes' limits and the way into the unit space
    patch : the surface in the unit space
    heights : lowest and highest z of the surface, in the document's units: the ends of the colour map
    document : for the samples, the control points and the curves
    surface_box, control_box : (3, 2) in the document's units
    """

    layer: Layer
    frame: Frame
    patch: Patch
    heights: tuple[float, float]
    document: Document
    surface_box: Array
    control_box: Array

    @cached_property
    def points(self) -> Array:
        """The control points in the unit space, (5, 5, 3)."""
        return read_only(self.frame.to_unit(self.document.control_points))

    @cached_property
    def network(self) -> CurveNetwork:
        """The ten curves of the document, in its own units."""
        return curve_network(self.document)

    @cached_property
    def row_curves(self) -> Array:
        """C_0(u) .. C_4(u) in the unit space, (5, k, 3)."""
        return read_only(self.frame.to_unit(curve_points(self.network.rows, CURVE_POINTS)))

    @cached_property
    def column_curves(self) -> Array:
        """K_0(v) .. K_4(v) in the unit space, (5, k, 3)."""
        return read_only(self.frame.to_unit(curve_points(self.network.columns, CURVE_POINTS)))

    @property
    def unit_heights(self) -> tuple[float, float]:
        """The ends of the colour map as z in the unit space."""
        centre, scale = self.frame.centre[2], self.frame.scale[2]
        low, high = ((height - centre) * scale for height in self.heights)
        return float(low), float(high)


def mapped_box(box: Array, matrix: Array) -> Array:
    """Return a box (3, 2) mapped by a (4, 4) matrix that scales each axis by a positive factor and moves
    it."""
    return matrix[:3, :3].diagonal()[:, None] * box + matrix[:3, 3:]


def scene_frame(result: Result, layer: Layer, scaling: Scaling) -> Frame:
    """Return the frame that holds a layer's surface and the control net, as in the paper's Figure 5."""
    return frame_around([_surface_box(result, layer), result.control_box], scaling)


def make_scene(result: Result, layer: Layer, frame: Frame) -> Scene:
    """Return one layer of a result in a frame."""
    matrix = frame.matrix if layer is Layer.RAW else frame.matrix @ result.matrix
    box = _surface_box(result, layer)
    return Scene(
        layer=layer,
        frame=frame,
        patch=result.patch.transformed(matrix),
        heights=(float(box[2, 0]), float(box[2, 1])),
        document=result.document,
        surface_box=read_only(box),
        control_box=result.control_box,
    )


def _surface_box(result: Result, layer: Layer) -> Array:
    box = result.raw_box if layer is Layer.RAW else mapped_box(result.raw_box, result.matrix)
    return np.array(box)
