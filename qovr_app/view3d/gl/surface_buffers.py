"""What the driver knows of a surface: vertices, indices and colours, rewritten where the picture has changed."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from qovr_app.view3d.gl import api
from qovr_app.view3d.scene.colouring import Colouring
from qovr_app.view3d.scene.grid import Cells, Grid, cell_starts, places, windows_of
from qovr_app.view3d.scene.mesh import (
    FloatArray,
    revised_vertices,
    sample_places,
    surface_vertices,
    triangle_indices,
)
from qovr_app.view3d.scene.picture import Picture
from qovr_core.arrays import Array
from qovr_core.geometry.differential import ParametricSurface

ATTRIBUTES = ("a_position", "a_normal", "a_part", "a_cell")
"""The vertex attributes in the order of their locations."""

_VERTEX, _SAMPLE = (3, 3), (3,)
"""Floats of a position and a normal, and of a sample: a facet's own normal is seen where it is drawn."""


class SurfaceBuffers:
    """The buffers and textures of one surface, made in the context that is current."""

    def __init__(self) -> None:
        self._array = api.make_vertex_array()
        self._vertices, self._parts, self._cells, self._indices = (api.make_buffer() for _ in range(4))
        self._colours = api.make_texture(api.Filtering.LINEAR)
        self._facets = api.make_texture(api.Filtering.NEAREST)
        self._drawn: tuple[ParametricSurface, Grid, FloatArray] | None = None
        self._indexed: Grid | None = None
        self._celled: tuple[Grid, Grid] | None = None
        self._table: npt.NDArray[np.uint8] | None = None
        self._faceted: tuple[Colouring, Grid] | None = None
        self._parted: tuple[Colouring, Grid] | None = None

    def release(self) -> None:
        """Destroy everything; a context that shares it is current."""
        api.delete_vertex_array(self._array)
        api.delete_buffers([self._vertices, self._parts, self._cells, self._indices])
        api.delete_textures([self._colours, self._facets])

    def bind(self, picture: Picture) -> None:
        """Bring to the driver what has changed since the last picture, and let it draw from these buffers."""
        api.bind_vertex_array(self._array)
        grid = picture.grid
        if picture.settings.document_samples:
            self._load_samples(picture.scene.patch, grid)
        else:
            self._load_vertices(picture.scene.patch, grid)
        if self._indexed != grid:
            api.load_indices(self._indices, triangle_indices(grid))
            self._indexed = grid
        if windows_of(picture.scene.patch) != (1, 1):
            self._load_cells(grid, picture.lined_grid)
        self._load_colours(picture)
        api.bind_textures([self._colours, self._facets])

    def _load_vertices(self, patch: ParametricSurface, grid: Grid) -> None:
        drawn_patch, drawn_grid, vertices = self._drawn_as(_VERTEX)
        if drawn_patch is patch and drawn_grid == grid:
            return
        if drawn_patch is None or vertices is None or drawn_grid != grid or windows_of(patch) == (1, 1):
            is_resized = drawn_grid != grid
            # What one window had is written over. Of a net the last vertices are read again, also after a failure.
            if vertices is None or is_resized or windows_of(patch) != (1, 1):
                vertices = np.empty((*grid.shape, sum(_VERTEX)), dtype=np.float32)
            surface_vertices(patch, grid, vertices)
            api.load_attributes(self._vertices, vertices, _VERTEX, location=0, is_resized=is_resized)
        else:
            vertices, rows = revised_vertices(vertices, drawn_patch, patch, grid)
            api.rewrite(self._vertices, vertices, rows)
        self._drawn = patch, grid, vertices

    def _load_samples(self, patch: ParametricSurface, grid: Grid) -> None:
        drawn_patch, drawn_grid, places = self._drawn_as(_SAMPLE)
        if drawn_patch is patch and drawn_grid == grid:
            return
        is_resized = places is None or drawn_grid != grid
        if places is None or is_resized:
            places = np.empty((*grid.shape, *_SAMPLE), dtype=np.float32)
        sample_places(patch, grid, places)
        api.load_attributes(self._vertices, places, _SAMPLE, location=0, is_resized=is_resized)
        self._drawn = patch, grid, places

    def _drawn_as(
        self, widths: tuple[int, ...]
    ) -> tuple[ParametricSurface, Grid, FloatArray] | tuple[None, None, None]:
        """Return what was drawn last, if its vertices had so many floats."""
        if self._drawn is None or self._drawn[2].shape[-1] != sum(widths):
            return None, None, None
        return self._drawn

    def _load_cells(self, grid: Grid, lined: Grid) -> None:
        """Say of every vertex of a net among which cells it lies: in one window counting tells."""
        if self._celled != (grid, lined):
            self._celled = grid, lined
            u, v = (
                _cell_places(*each) for each in zip((grid.u, grid.v), (lined.u, lined.v), grid.together, strict=True)
            )
            cells = np.empty((*grid.shape, 2), dtype=np.float32)
            cells[..., 0], cells[..., 1] = u[:, None], v
            api.load_attributes(self._cells, cells, (2,), location=len(_VERTEX) + 1, is_resized=True)

    def _load_colours(self, picture: Picture) -> None:
        colouring, grid = picture.colouring, picture.coloured_grid
        if self._table is not colouring.table:
            self._table = colouring.table
            api.load_colours(self._colours, colouring.table)
        if picture.settings.document_samples and colouring.ramp is not None:
            return
        if picture.has_facets and not picture.settings.document_samples:
            if self._faceted != (colouring, grid):
                self._faceted = colouring, grid
                firsts = np.ix_(cell_starts(grid.u), cell_starts(grid.v))
                api.load_values(self._facets, colouring.parts(grid)[firsts])
        elif self._parted != (colouring, grid):
            self._parted = colouring, grid
            parts = colouring.parts(grid)
            api.load_attributes(self._parts, parts, (1,), location=len(_VERTEX), is_resized=True)


def _cell_places(drawn: Cells, lined: Cells, together: int) -> Array:
    """Return among which of the lined cells each vertex of one direction lies, counted through all windows."""
    window, cells = (
        np.repeat(np.arange(len(drawn)), np.add(drawn, 1)),
        np.add.reduceat(lined, range(0, len(lined), together)),
    )
    before = np.cumsum(cells) - cells
    found: Array = before[window] + places(drawn) * cells[window]
    return found
