"""Values over a surface on a grid."""

from __future__ import annotations

from collections.abc import Callable

from qovr_app.view3d.scene.grid import Grid, parameters, part_of, touched_windows
from qovr_core.arrays import Array, read_only
from qovr_core.geometry.differential import ParametricSurface
from qovr_core.geometry.patch import Patch

Values = Callable[[ParametricSurface, Array, Array], Array]
"""Gives values (n, m) over a surface at parameters (n,) and (m,), each by what the surface is there alone."""


def revised_values(
    known: Array | None, before: ParametricSurface | None, after: ParametricSurface, grid: Grid, values: Values
) -> Array:
    """Return the values of a surface on a grid, by those of another where it differs from that in few windows.

    Parameters
    ----------
    known, before : the values of the other surface on the same grid, and that surface; None where there are none
    """
    touched = None
    if isinstance(before, Patch) and isinstance(after, Patch) and grid.together == (1, 1):
        touched = touched_windows(before, after)
    if known is None or touched is None or not isinstance(after, Patch):
        return values(after, *parameters(after, grid))
    part, revised = part_of(after, *touched), known.copy()
    if part.coefficients.size:
        revised[grid.vertices_of(*touched)] = values(part, *parameters(part, grid.of_windows(*touched)))
    return read_only(revised)
