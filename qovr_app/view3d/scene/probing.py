"""The probe: which point of the exact surface lies under a pixel, and everything that is so there. NumPy alone."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from qovr_app.view3d.scene.camera import Camera, Size
from qovr_app.view3d.scene.grid import breakpoints_of, cell_corners, windows_of
from qovr_app.view3d.scene.scene import Scene
from qovr_core.arrays import Array, Indices, read_only
from qovr_core.document import Window
from qovr_core.fields import FIELDS, Field, Need, field_values
from qovr_core.geometry.differential import ParametricSurface
from qovr_core.geometry.locate import located

_CELLS = 48
"""Cells a side of the mesh on which the search starts."""

_AROUND = 0.5
"""Part of a cell's extent on the screen by which the surface may leave the cell's rectangle, and then some."""

_LONGEST_STEP = 3
"""Newton's method is held back to a few cells a step, or at an outline it would lose its way."""

_MOST_STEPS = 30
_ROUNDING = 1e-15
"""Parameters: a last step that long changes nothing any more."""

_MET = 1e-11
"""Unit lengths between surface and line of sight that are rounding: they meet."""

_CURVATURES = (Field.GAUSSIAN, Field.MEAN, Field.LARGEST, Field.SMALLEST)

Parameters = tuple[float, float]
"""u and v of a point of the surface."""


def parameters_under(scene: Scene, camera: Camera, size: Size, x: float, y: float) -> Parameters | None:
    """Return the parameters of the frontmost point of the surface under a pixel; None beside the surface.

    Parameters
    ----------
    size : the viewport in logical pixels
    x, y : the pixel, not necessarily whole
    """
    starts = _cells_near(scene, camera, size, x, y)
    if starts.at.size == 0:
        return None
    origin, direction = camera.ray(x, y, size)
    met, points = _meetings(scene, origin, direction, starts)
    if met.size == 0:
        return None
    u, v = met[np.argmin((points - origin) @ direction)].tolist()
    return u, v


@dataclass(frozen=True, eq=False)
class _Starts:
    """Where a search begins, u and v (k, 2), and how far it may go: its window is one polynomial.

    Parameters
    ----------
    at : the middles of cells
    low, high : the ends of their windows
    longest : step of the search
    """

    at: Array
    low: Array
    high: Array
    longest: Array


def _cells_near(scene: Scene, camera: Camera, size: Size, x: float, y: float) -> _Starts:
    """Return the middles of the cells that may show at a pixel."""
    mesh, grid = scene.mesh(_CELLS)
    corners = np.stack(cell_corners(camera.project(mesh, size)[..., :2], grid))
    low, high = corners.min(axis=0), corners.max(axis=0)
    reach = _AROUND * (high - low) + 1.0
    near = ((low - reach <= [x, y]) & (high + reach >= [x, y])).all(axis=-1)
    found = [
        _along(cells, count, breakpoints)
        for cells, count, breakpoints in zip(
            np.argwhere(near).T, (grid.u[0], grid.v[0]), breakpoints_of(scene.patch), strict=True
        )
    ]
    return _Starts(*(np.stack(parts, axis=1) for parts in zip(*found, strict=True)))


def _along(cells: Indices, count: int, breakpoints: Array) -> tuple[Array, Array, Array, Array]:
    """Return of cells, ``count`` in every window, the middles, the windows' ends, and the longest step."""
    window, number = np.divmod(cells, count)
    start, length = breakpoints[window], np.diff(breakpoints)[window]
    ends = np.append(np.nextafter(breakpoints[1:-1], -np.inf), breakpoints[-1])
    return start + (number + 0.5) / count * length, start, ends[window], _LONGEST_STEP / count * length


def _meetings(scene: Scene, origin: Array, direction: Array, starts: _Starts) -> tuple[Array, Array]:
    """Return where a line of sight meets the surface in front of the eye: u and v (k, 2), and the points (k, 3).

    Newton's method in the plane across the line, from all starts at once; several find the same meeting, and
    those that find none are left out.
    """
    across = np.linalg.svd(direction[None])[2][1:]
    at = starts.at.copy()
    for _ in range(_MOST_STEPS):
        u, v = at.T
        point, su, sv = (scene.patch.derivative_at(u, v, *order) for order in ((0, 0), (1, 0), (0, 1)))
        missing, along_u, along_v = ((part @ across.T).T for part in (origin - point, su, sv))
        determinant = along_u[0] * along_v[1] - along_u[1] * along_v[0]
        with np.errstate(divide="ignore", invalid="ignore"):
            step_u = (missing[0] * along_v[1] - missing[1] * along_v[0]) / determinant
            step_v = (along_u[0] * missing[1] - along_u[1] * missing[0]) / determinant
        step = np.clip(np.nan_to_num(np.stack([step_u, step_v], axis=1)), -starts.longest, starts.longest)
        before, at = at, np.clip(at + step, starts.low, starts.high)
        if np.abs(at - before).max() <= _ROUNDING:
            break
    points = scene.patch.derivative_at(at[:, 0], at[:, 1], 0, 0)
    met = (np.linalg.norm((points - origin) @ across.T, axis=1) <= _MET) & ((points - origin) @ direction > 0)
    return at[met], points[met]


@dataclass(frozen=True, eq=False)
class Reading:
    """What is so at one point of a surface, in the document's units; arrays are float64 and read-only.

    Parameters
    ----------
    u, v : its parameters; in a net of windows, where in its window it lies
    window : of the net; None of a surface that is one
    point, normal : (3,) and (3,), the normal of length 1 along S_u x S_v
    curvatures : the fields that are always read; NaN where there are no curvatures
    others : the fields that need something that is there, and what colours say
    """

    u: float
    v: float
    window: Window | None
    point: Array
    normal: Array
    curvatures: dict[Field, float]
    others: dict[Field, float]


def reading_at(scene: Scene, parameters: Parameters, by: str) -> Reading:
    """Return everything that is so at a point of a scene's surface.

    Parameters
    ----------
    by : the name of what the colours say: a field that needs a knot is as costly as its colours, and read only then
    """
    u, v = parameters

    def values(fields: Iterable[Field]) -> dict[Field, float]:
        found = {field: field_values(field, scene.surface, [u], [v], scene.beside(field.needs)) for field in fields}
        return {field: float(value[0, 0]) for field, value in found.items()}

    window, (place_u, place_v) = window_at(scene.surface, parameters)
    return Reading(
        place_u,
        place_v,
        window,
        point=read_only(scene.surface.points([u], [v])[0, 0]),
        normal=read_only(scene.surface.normals([u], [v])[0, 0]),
        curvatures=values(_CURVATURES),
        others=values(field for field in FIELDS.values() if _is_read(scene, field, by)),
    )


def window_at(surface: ParametricSurface, parameters: Parameters) -> tuple[Window | None, Parameters]:
    """Return the window in which a point of a surface lies, None where it has only one, and where in it."""
    if windows_of(surface) == (1, 1):
        return None, parameters
    at_u, at_v = (located([x], ends) for x, ends in zip(parameters, breakpoints_of(surface), strict=True))
    return (int(at_v.window[0]), int(at_u.window[0])), (float(at_u.local[0]), float(at_v.local[0]))


def _is_read(scene: Scene, field: Field, by: str) -> bool:
    """Return whether a field is read besides coordinates and curvatures."""
    if field.axis is not None or field in _CURVATURES:
        return False
    is_wanted = field.needs is Need.REFERENCE or field.name == by
    return is_wanted and (field.needs is None or scene.beside(field.needs) is not None)
