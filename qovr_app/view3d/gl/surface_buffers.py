"""What the driver knows of a surface: vertices, indices and colours, rewritten where the picture has changed."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from qovr_app.view3d.gl import api
from qovr_app.view3d.scene.colouring import Colouring
from qovr_app.view3d.scene.mesh import Counts, surface_vertices, triangle_indices
from qovr_app.view3d.scene.picture import Picture
from qovr_core.geometry.differential import ParametricSurface

ATTRIBUTES = ("a_position", "a_normal", "a_part")
"""The vertex attributes in the order of their locations."""

_VERTEX = (3, 3)
"""Floats of a position and a normal."""


class SurfaceBuffers:
    """The buffers and textures of one surface, made in the context that is current."""

    def __init__(self) -> None:
        self._array = api.make_vertex_array()
        self._vertices, self._parts, self._indices = (api.make_buffer() for _ in range(3))
        self._colours = api.make_texture(api.Filtering.LINEAR)
        self._facets = api.make_texture(api.Filtering.NEAREST)
        self._drawn: tuple[ParametricSurface, Counts] | None = None
        self._indexed: Counts | None = None
        self._table: npt.NDArray[np.uint8] | None = None
        self._faceted: tuple[Colouring, Counts] | None = None
        self._parted: tuple[Colouring, Counts] | None = None

    def release(self) -> None:
        """Destroy everything; a context that shares it is current."""
        api.delete_vertex_array(self._array)
        api.delete_buffers([self._vertices, self._parts, self._indices])
        api.delete_textures([self._colours, self._facets])

    def bind(self, picture: Picture) -> None:
        """Bring to the driver what has changed since the last picture, and let it draw from these buffers."""
        api.bind_vertex_array(self._array)
        self._load_vertices(picture.scene.patch, picture.counts)
        if self._indexed != picture.counts:
            api.load_indices(self._indices, triangle_indices(picture.counts))
            self._indexed = picture.counts
        self._load_colours(picture)
        api.bind_textures([self._colours, self._facets])

    def _load_vertices(self, patch: ParametricSurface, counts: Counts) -> None:
        drawn_patch, drawn_counts = self._drawn or (None, None)
        if drawn_patch is not patch or drawn_counts != counts:
            vertices, is_resized = surface_vertices(patch, counts), drawn_counts != counts
            api.load_attributes(self._vertices, vertices, _VERTEX, location=0, is_resized=is_resized)
            self._drawn = patch, counts

    def _load_colours(self, picture: Picture) -> None:
        colouring, counts = picture.colouring, picture.coloured_counts
        if self._table is not colouring.table:
            self._table = colouring.table
            api.load_colours(self._colours, colouring.table)
        if picture.has_facets:
            if self._faceted != (colouring, counts):
                self._faceted = colouring, counts
                api.load_values(self._facets, colouring.parts(counts))
        elif self._parted != (colouring, counts):
            self._parted = colouring, counts
            parts = colouring.parts(counts)
            api.load_attributes(self._parts, parts, (1,), location=len(_VERTEX), is_resized=True)
