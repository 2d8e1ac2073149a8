"""The probe: which point of the exact surface lies under a pixel, and everything that is so there. NumPy alone."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from qovr_app.view3d.camera import Camera, Size
from qovr_app.view3d.mesh import surface_vertices
from qovr_app.view3d.scene import Scene
from qovr_core.arrays import Array, read_only
from qovr_core.laboratory.fields import Field, field_values

_CELLS = 64
"""Cells a side of the mesh on which the search starts: no sheet of a surface of degree 6 is narrower than some."""

_STRAY = 2 / _CELLS
"""Parameters by which the exact place may differ from that on the mesh; beyond it Newton's method has lost its way."""

_MOST_STEPS = 20
_CLOSE = 1e-14
"""Parameters: a last step shorter than this changes nothing but rounding."""

Place = tuple[float, float]
"""u and v."""


def place_under(scene: Scene, camera: Camera, size: Size, x: float, y: float) -> Place | None:
    """Return the parameters of the frontmost point of the surface under a pixel; None beside the surface.

    Parameters
    ----------
    size : the viewport in logical pixels
    x, y : the pixel, not necessarily whole
    """
    start = _place_on_mesh(scene, camera, size, x, y)
    if start is None:
        return None
    exact = _place_on_ray(scene, *camera.ray(x, y, size), start)
    # Beside an outline of the mesh, or one of the surface, there may be no exact point.
    return start if max(abs(exact[0] - start[0]), abs(exact[1] - start[1])) > _STRAY else exact


def _place_on_mesh(scene: Scene, camera: Camera, size: Size, x: float, y: float) -> Place | None:
    mesh = surface_vertices(scene.patch, (_CELLS + 1, _CELLS + 1))[..., :3].astype(np.float64)
    seen = camera.project(mesh, size) - [x, y, 0]
    corners = seen[:-1, :-1], seen[1:, :-1], seen[:-1, 1:], seen[1:, 1:]
    best, place = np.inf, None
    for (a, b, c), (u, v), sign in ((corners[:3], (0, 0), 1), (corners[:0:-1], (1, 1), -1)):
        weight_b, weight_c, depth = _barycentric(a, b, c)
        inside = (weight_b >= 0) & (weight_c >= 0) & (weight_b + weight_c <= 1)
        depth = np.where(inside, depth, np.inf)
        i, j = np.unravel_index(int(np.argmin(depth)), depth.shape)
        if depth[i, j] < best:
            best = depth[i, j]
            along_u, along_v = (weight_b, weight_c) if sign > 0 else (weight_c, weight_b)
            place = (i + u + sign * along_u[i, j]) / _CELLS, (j + v + sign * along_v[i, j]) / _CELLS
    return None if place is None else (float(place[0]), float(place[1]))


def _barycentric(a: Array, b: Array, c: Array) -> tuple[Array, Array, Array]:
    """Return the weights of b and c at the origin of the screen, and the depth there; NaN for triangles edge on."""
    ab, ac = b - a, c - a
    area = ab[..., 0] * ac[..., 1] - ab[..., 1] * ac[..., 0]
    with np.errstate(divide="ignore", invalid="ignore"):
        weight_b = (ac[..., 0] * a[..., 1] - ac[..., 1] * a[..., 0]) / area
        weight_c = (ab[..., 1] * a[..., 0] - ab[..., 0] * a[..., 1]) / area
        return weight_b, weight_c, a[..., 2] + weight_b * ab[..., 2] + weight_c * ac[..., 2]


def _place_on_ray(scene: Scene, origin: Array, direction: Array, start: Place) -> Place:
    """Return where a ray meets the surface, by Newton's method in the plane across the ray."""
    across = np.linalg.svd(direction[None])[2][1:]
    at = np.array(start)
    for _ in range(_MOST_STEPS):
        point, su, sv = (scene.patch.derivative_at(at[:1], at[1:], *order)[0] for order in ((0, 0), (1, 0), (0, 1)))
        jacobian = across @ np.stack([su, sv], axis=1)
        step = np.linalg.lstsq(jacobian, across @ (origin - point), rcond=None)[0]
        at = np.clip(at + step, 0.0, 1.0)
        if np.abs(step).max() < _CLOSE:
            break
    return float(at[0]), float(at[1])


@dataclass(frozen=True, eq=False)
class Reading:
    """What is so at one point of a surface, in the document's units; arrays are float64 and read-only.

    Parameters
    ----------
    u, v : its parameters
    point, normal : (3,) and (3,), the normal of length 1 along S_u x S_v
    gaussian, mean, largest, smallest : the curvatures; NaN where there are none
    distance : from the reference; None where there is none
    sensitivity : to the knot that was turned to; None where there is none
    """

    u: float
    v: float
    point: Array
    normal: Array
    gaussian: float
    mean: float
    largest: float
    smallest: float
    distance: float | None
    sensitivity: float | None


def reading_at(scene: Scene, place: Place) -> Reading:
    """Return everything that is so at a place of a scene's surface."""
    (u, v), companions = place, scene.companions
    curvature = scene.surface.curvature([u], [v])

    def value(field: Field, companion: object) -> float:
        return float(field_values(field, scene.surface, [u], [v], companion)[0, 0])

    reference, knot = companions.reference, companions.knot
    return Reading(
        u,
        v,
        point=read_only(scene.surface.points([u], [v])[0, 0]),
        normal=read_only(scene.surface.normals([u], [v])[0, 0]),
        **{name: float(getattr(curvature, name)[0, 0]) for name in ("gaussian", "mean", "largest", "smallest")},
        distance=None if reference is None else value(Field.DISTANCE, reference),
        sensitivity=None if knot is None else value(Field.SENSITIVITY, scene.knot_slope),
    )
