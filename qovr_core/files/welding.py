"""Which vertices of a mesh's grid are one place: on both sides of joints and seams, along edges that are a point."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import product

import numpy as np

from qovr_core.arrays import Array, Flags
from qovr_core.files import bspline
from qovr_core.files.mesh_grid import MeshGrid, Numbers
from qovr_core.geometry.edges import Edge
from qovr_core.geometry.patch import Patch

WindowEdge = tuple[tuple[int, int], Edge]
"""A window (a, b), and one of its edges."""

_WELDED = 1e-12
"""Edges closer than this part of the surface's size are the same points, moved by rounding."""

_SAME_NORMAL = 1e-6
"""Normals closer than this are shared where vertices are; those of a crease differ by far more."""

Group = Numbers
"""Vertices by number, (g, k): those along the first axis are one place."""


def joints(grid: MeshGrid) -> list[Group]:
    """Return the vertices on both sides of the joints between windows; none where windows do not meet."""
    if not grid.is_joined:
        return []
    numbers = grid.numbers
    sides = (
        (numbers[grid.u.ends[:-1]], numbers[grid.u.starts[1:]]),
        (numbers[:, grid.v.ends[:-1]], numbers[:, grid.v.starts[1:]]),
    )
    return [np.stack([before.ravel(), after.ravel()]) for before, after in sides if before.size]


def seams(grid: MeshGrid, patch: Patch) -> list[Group]:
    """Return the vertices of edges that are one point, and of first and last edges that are one curve, by windows."""
    within = _WELDED * bspline.diagonal(patch.coefficients)
    groups = [_edge(grid, at)[:, None] for at in _collapsed(patch, within)]
    for first, last in _opposite_edges(patch.windows, grid.is_joined):
        curve, other = (patch.coefficients[window][edge.position] for window, edge in (first, last))
        if bspline.coincide(curve, other, within):
            groups.append(np.stack([_edge(grid, first), _edge(grid, last)]))
    return groups


def one_place(grid: MeshGrid, groups: list[Group]) -> Numbers:
    """Return for every vertex the smallest number of those that are one place with it, (n, m)."""
    smallest = np.arange(grid.numbers.size, dtype=np.int32)
    changed = bool(groups)
    while changed:  # groups share corners, so that joining one may lengthen another
        before = smallest.copy()
        for group in groups:
            smallest[group] = smallest[group].min(axis=0)
        changed = bool((before != smallest).any())
    return smallest.reshape(grid.shape)


def of_one_normal(normals: Array, joints: list[Group], seams: list[Group]) -> list[Group]:
    """Return those that share their normal (k, 3) too: of joints where they are smooth, of seams all or none."""
    parts = (joint[:, _alike(normals, joint)] for joint in joints)
    return [*(part for part in parts if part.size), *(seam for seam in seams if _alike(normals, seam).all())]


def _alike(normals: Array, group: Group) -> Flags:
    there = normals[group]
    return np.asarray(np.abs(there - there[:1]).max(axis=(0, 2)) <= _SAME_NORMAL)


def _collapsed(patch: Patch, within: float) -> Iterator[WindowEdge]:
    """Yield the windows' edges that are one point."""
    for edge in Edge:
        iu, iv = edge.position
        curves = patch.coefficients[:, :, iu, iv]
        is_point = np.linalg.norm(curves - curves[:, :, :1], axis=-1).max(axis=-1) <= within
        for a, b in np.argwhere(is_point).tolist():
            yield (a, b), edge


def _opposite_edges(windows: tuple[int, int], is_joined: bool) -> Iterator[tuple[WindowEdge, WindowEdge]]:
    """Yield the edges that may be one curve: those of the whole, window by window, or of each window by itself."""
    m, n = windows
    for a, b in product(range(m), [0] if is_joined else range(n)):
        yield ((a, b), Edge.U0), ((a, n - 1 if is_joined else b), Edge.U1)
    for a, b in product([0] if is_joined else range(m), range(n)):
        yield ((a, b), Edge.V0), ((m - 1 if is_joined else a, b), Edge.V1)


def _edge(grid: MeshGrid, at: WindowEdge) -> Numbers:
    """Return the vertices of an edge of a window, in their order along it."""
    (a, b), edge = at
    return np.asarray(grid.numbers[grid.u.samples(b), grid.v.samples(a)][edge.position])
