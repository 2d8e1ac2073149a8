"""The scene: what one viewport shows, in the unit space; made from an evaluation, never from its samples."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property
from typing import Any
from weakref import WeakSet

import numpy as np

from qovr_app.state.display import Scaling, Style
from qovr_app.view3d.scene.companions import Companions
from qovr_app.view3d.scene.curve_lines import curve_points
from qovr_app.view3d.scene.display_grid import display_grid
from qovr_app.view3d.scene.frame import FARTHEST, Frame, frame_around
from qovr_app.view3d.scene.grid import Grid, shared_grid, spread, windows_of
from qovr_app.view3d.scene.held_ranges import HeldRanges
from qovr_app.view3d.scene.mesh import FloatArray, revised_vertices, surface_vertices
from qovr_app.view3d.scene.values import revised_values
from qovr_core import CurveNetwork, Document, Evaluation, ParametricSurface, Patch, curve_network
from qovr_core.arrays import Array, read_only
from qovr_core.fields import Field, Need, field_values
from qovr_core.layer import Layer

CURVE_PIECES = 48
"""Pieces with which a curve C_i or K_j is drawn, at least: no corner shows at any size that fits a screen."""


_BESIDE = 1e-9
"""Part of an axis by which what lies on its end may miss it: rounding."""

_COARSE = (8, 8)
"""Cells whose vertices tell which side of a surface is the upper one."""


@dataclass(frozen=True, eq=False)
class Scene:
    """One layer of an evaluation in its frame.

    Parameters
    ----------
    layer : raw or transformed
    frame : the axes' limits and the way into the unit space
    patch : the surface in the unit space
    surface : the surface in the document's units
    evaluation : what the surface is of, and what its knots do
    document : whose control points and curves are shown: the evaluation's own, or one whose net has moved on
    surface_box, control_box : (3, 2) in the document's units
    companions : what it is looked at with
    name : of its surface where there are several, else empty
    is_comparison : whether the surface is not the document's, but one of the same control net that is compared with it
    lines_name, lines : another surface over this one, by its lines (k, n, 3) of the unit space; k is 0 without one
    peers : scenes beside this one in which a colour means the same
    held : the ranges of the colours that edits do not change
    """

    layer: Layer
    frame: Frame
    patch: ParametricSurface
    surface: ParametricSurface
    evaluation: Evaluation
    document: Document
    surface_box: Array
    control_box: Array
    companions: Companions = field(default_factory=Companions)
    name: str = ""
    is_comparison: bool = False
    lines_name: str = ""
    lines: Array = field(default_factory=lambda: np.empty((0, 2, 3)))
    held: HeldRanges = field(default_factory=HeldRanges)
    peers: WeakSet[Scene] = field(default_factory=WeakSet, init=False, repr=False)
    cache: dict[Any, Any] = field(default_factory=dict, init=False, repr=False)

    @cached_property
    def knot_slope(self) -> Patch | None:
        """dS/dknot for the companions' knot, in the document's units; None where there is no knot to move."""
        from qovr_core.laboratory.sensitivity import knot_sensitivity

        knot = self.companions.knot
        if knot is None or self.is_comparison:
            return None
        return knot_sensitivity(self.evaluation, knot, self.layer)

    @property
    def leaves_sight(self) -> bool:
        """Whether the surface runs so far between its samples, after which the axes are, that it cannot be seen."""
        return isinstance(self.patch, Patch) and bool(np.abs(self.patch.coefficients).max() > FARTHEST)

    def beside(self, need: Need | None) -> ParametricSurface | None:
        """Return what a field with this need must be given; None where it needs nothing, or nothing is there."""
        if need is Need.REFERENCE:
            return self.companions.reference
        return self.knot_slope if need is Need.KNOT else None

    def values(self, field: Field, grid: Grid, *, moving: bool) -> Array:
        """Return the values of a field on a grid, (n, m) float64 in the document's units; computed once."""

        def values(surface: ParametricSurface, u: Array, v: Array) -> Array:
            return field_values(field, surface, u, v, self.beside(field.needs))

        few = grid if field.finest is None else grid.within((field.finest[not moving] - 1,) * 2)
        if (field, few) not in self.cache:
            known = self._known((field, few)) if field.needs is not Need.KNOT else None
            before = None if known is None else self.cache[Scene].surface
            self.cache[field, few] = revised_values(known, before, self.surface, few, values)
        return spread(self.cache[field, few], few, grid)

    def follow(self, earlier: Scene) -> None:
        """Take over what an earlier scene of the layer has made, as far as nothing but some windows is another."""
        others, own = ((each.frame, each.companions.reference, each.document.samples) for each in (earlier, self))
        if others == own and windows_of(earlier.surface) == windows_of(self.surface) != (1, 1):
            earlier.cache.pop(Scene, None)  # what is older still is let go
            self.cache[Scene] = earlier

    def _known(self, key: Any) -> Any:
        """Return what the earlier scene has made; None where there is none, or it has not."""
        return self.cache[Scene].cache.get(key) if Scene in self.cache else None

    def grid(self, style: Style, *, moving: bool) -> Grid:
        """Return the grid on which the surface is drawn; while it moves that of the earlier scene."""
        if (style, moving) not in self.cache:
            known = self._known((style, moving)) if moving else None
            made = known or display_grid(self.patch, self.document.samples, style, moving=moving)
            self.cache[style, moving] = made
        found: Grid = self.cache[style, moving]
        return found

    @cached_property
    def leaves_frame(self) -> bool:
        """Whether something of the surface or its net lies outside the axes."""
        (low, high), net = self.frame.limits.T, self.document.control_points.reshape(-1, 3)
        slack, seen = _BESIDE * (high - low), np.concatenate([self.surface_box.T, net])
        return bool((seen < low - slack).any() or (seen > high + slack).any())

    @property
    def caption(self) -> str:
        """What tells the scene from the ones beside it."""
        text = ", ".join(part for part in (self.name, "" if self.is_comparison else str(self.layer)) if part)
        return text[0].upper() + text[1:]

    @property
    def net_shape(self) -> tuple[int, int]:
        """Rows and columns of the control net."""
        rows, columns = self.document.control_points.shape[:2]
        return rows, columns

    @cached_property
    def points(self) -> Array:
        """The control points in the unit space, (k, l, 3): k rows of l."""
        return read_only(self.frame.to_unit(self.document.control_points))

    def mesh(self, cells: int) -> tuple[Array, Grid]:
        """Return places on the surface in the unit space, (n, m, 3), and their grid, of so many cells a side at least;
        the same from wherever it is seen, and computed once."""
        grid = shared_grid(self.patch, (cells, cells))
        if ("mesh", grid) not in self.cache:
            self.cache["mesh", grid] = read_only(self._vertices(grid)[..., :3].astype(np.float64))
        return self.cache["mesh", grid], grid

    def _vertices(self, grid: Grid) -> FloatArray:
        """Return ``surface_vertices``: in a net of many windows several ask for those of one grid."""
        if ("vertices", grid) not in self.cache:
            known = self._known(("vertices", grid))
            if known is None:
                self.cache["vertices", grid] = surface_vertices(self.patch, grid)
            else:
                self.cache["vertices", grid], _ = revised_vertices(known, self.cache[Scene].patch, self.patch, grid)
        found: FloatArray = self.cache["vertices", grid]
        return found

    @cached_property
    def window_corners(self) -> Array:
        """The corners of all windows in the unit space, (n + 1, m + 1, 3): those of the windows that begin there."""
        assert isinstance(self.patch, Patch), "other surfaces have no windows"
        m, n = self.patch.windows
        corners, coefficients = np.empty((m + 1, n + 1, 3)), self.patch.coefficients
        corners[:m, :n], corners[m, :n] = coefficients[:, :, 0, 0], coefficients[-1, :, 0, -1]
        corners[:m, n], corners[m, n] = coefficients[:, -1, -1, 0], coefficients[-1, -1, -1, -1]
        return read_only(np.clip(corners, -FARTHEST, FARTHEST).swapaxes(0, 1))

    @cached_property
    def is_turned(self) -> bool:
        """Whether the surface's normals S_u x S_v point down on the whole, as those of a net that runs backward do."""
        return bool(self._vertices(shared_grid(self.patch, _COARSE))[..., 5].sum() < 0)

    @cached_property
    def network(self) -> CurveNetwork:
        """The curves of the document, in its own units."""
        return curve_network(self.document)

    @cached_property
    def row_curves(self) -> Array:
        """The curves C_i(u) in the unit space, (rows, points, 3): equally many points in every window."""
        return read_only(self.frame.to_unit(curve_points(self.network.rows, CURVE_PIECES)))

    @cached_property
    def column_curves(self) -> Array:
        """The curves K_j(v) in the unit space, (columns, points, 3), likewise."""
        return read_only(self.frame.to_unit(curve_points(self.network.columns, CURVE_PIECES)))


def mapped_box(box: Array, matrix: Array) -> Array:
    """Return a box (3, 2) mapped by a (4, 4) matrix that scales each axis by a positive factor and moves it."""
    return matrix[:3, :3].diagonal()[:, None] * box + matrix[:3, 3:]


def scene_frame(evaluation: Evaluation, layer: Layer, scaling: Scaling, *others: Array) -> Frame:
    """Return the frame that holds a layer's surface and the control net, as in the paper's Figure 5, and others."""
    return frame_around([_surface_box(evaluation, layer), evaluation.control_box, *others], scaling)


def make_scene(
    evaluation: Evaluation,
    layer: Layer,
    frame: Frame,
    companions: Companions | None = None,
    document: Document | None = None,
    *,
    earlier: Scene | None = None,
) -> Scene:
    """Return one layer of an evaluation in a frame, with the control points of a document or with its own.

    Parameters
    ----------
    earlier : a scene of the layer from which it may differ in few windows
    """
    surface, known = evaluation.layer_patch(layer), None
    if earlier is not None and earlier.frame is frame and isinstance(earlier.surface, Patch):
        assert isinstance(earlier.patch, Patch), "a surface laid in the unit space stays of its kind"
        known = earlier.surface, earlier.patch
    return Scene(
        layer=layer,
        frame=frame,
        patch=frame.laid_patch(surface, known),
        surface=surface,
        evaluation=evaluation,
        document=document or evaluation.document,
        surface_box=read_only(_surface_box(evaluation, layer)),
        control_box=evaluation.control_box,
        companions=companions or Companions(),
    )


def _surface_box(evaluation: Evaluation, layer: Layer) -> Array:
    box = evaluation.raw_box if layer is Layer.RAW else mapped_box(evaluation.raw_box, evaluation.matrix)
    return np.array(box)
