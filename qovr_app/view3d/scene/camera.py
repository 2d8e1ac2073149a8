"""The camera: one set of matrices for OpenGL, the overlay, picking and the painter. NumPy alone.

Screen coordinates are logical pixels, x to the right, y downward, from the upper left corner of the
viewport. Depth is the normalised one, -1 near to 1 far.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np

from qovr_core.arrays import Array, read_only
from qovr_core.cameras import NAMED_VIEWS

FIELD_OF_VIEW = 32.0
"""Degrees across the smaller side in perspective: a moderate lens, which bends the axes box without
distorting it."""

_REACH = 6.0
"""Unit lengths around the origin between the near and far planes: the axes box reaches 1.6, dragged points
beyond it."""

_NEAREST = 1e-3
"""The near plane is at least this part of the distance away, or depth would lose its resolution."""

SPAN_LIMITS = (1e-3, 60.0)
"""Unit lengths across the smaller side: from a thousandth of the surface to a surface a few pixels wide."""

_AROUND = 1.4
"""Unit lengths across a view of a single point, and of how many times the extent of several."""

_BEHIND = 1e-9
"""Points with w below this lie in or behind the eye's plane and have no place on the screen."""

Size = tuple[float, float]
"""Width and height of a viewport in logical pixels."""


@dataclass(frozen=True)
class Camera:
    """A turntable camera around a centre in the unit space.

    Parameters
    ----------
    azimuth, elevation : degrees; azimuth 0 looks from +x, -90 from -y; elevation 90 from above
    centre : the point of the unit space in the middle of the viewport
    span : unit lengths across the smaller side of the viewport, at the centre's depth
    perspective : whether near things are larger
    """

    azimuth: float = -54.0
    elevation: float = 64.0
    centre: tuple[float, float, float] = (0.0, 0.0, 0.0)
    span: float = 4.0
    perspective: bool = False

    @property
    def axes(self) -> Array:
        """The (3, 3) rows right, up and toward the viewer."""
        a, e = math.radians(self.azimuth), math.radians(self.elevation)
        right = [-math.sin(a), math.cos(a), 0.0]
        up = [-math.sin(e) * math.cos(a), -math.sin(e) * math.sin(a), math.cos(e)]
        back = [math.cos(e) * math.cos(a), math.cos(e) * math.sin(a), math.sin(e)]
        return np.array([right, up, back])

    @property
    def distance(self) -> float:
        """From the eye to the centre; in parallel projection only the reach of the depth planes."""
        return self.span / 2 / math.tan(math.radians(FIELD_OF_VIEW / 2))

    @property
    def eye(self) -> Array:
        """The eye in homogeneous coordinates, (4,): a point in perspective, else the direction toward the viewer."""
        toward = self.axes[2]
        if self.perspective:
            return np.append(np.array(self.centre) + self.distance * toward, 1.0)
        return np.append(toward, 0.0)

    def view_matrix(self) -> Array:
        """Return the (4, 4) matrix from the unit space to the eye's, which looks along -z."""
        matrix = np.eye(4)
        matrix[:3, :3] = self.axes
        matrix[:3, 3] = -self.axes @ np.array(self.centre)
        if self.perspective:
            matrix[2, 3] -= self.distance
        return matrix

    def projection_matrix(self, size: Size) -> Array:
        """Return the (4, 4) matrix from the eye's space to clip coordinates for a viewport."""
        width, height = size
        half_w, half_h = (self.span / 2 * side / min(width, height) for side in (width, height))
        reach = _REACH + float(np.linalg.norm(self.centre))
        matrix = np.zeros((4, 4))
        if self.perspective:
            near, far = max(self.distance - reach, self.distance * _NEAREST), self.distance + reach
            matrix[0, 0], matrix[1, 1] = self.distance / half_w, self.distance / half_h
            matrix[2, 2:] = (near + far) / (near - far), 2 * near * far / (near - far)
            matrix[3, 2] = -1
        else:
            matrix[0, 0], matrix[1, 1], matrix[2, 2], matrix[3, 3] = 1 / half_w, 1 / half_h, -1 / reach, 1
        return matrix

    @lru_cache(maxsize=8)  # noqa: B019 - cameras are small values, and one frame asks a dozen times
    def matrix(self, size: Size) -> Array:
        """Return the (4, 4) matrix from the unit space to clip coordinates, read-only."""
        return read_only(self.projection_matrix(size) @ self.view_matrix())

    def project(self, points: Array, size: Size) -> Array:
        """Return where points (..., 3) of the unit space appear.

        Returns
        -------
        (..., 3) float64: x, y in logical pixels and the depth; NaN where a point is not in front of the eye
        """
        matrix = self._screen_matrix(size)
        seen: Array = points @ matrix[:3, :3].T + matrix[:3, 3]
        if self.perspective:
            w = points @ matrix[3, :3] + matrix[3, 3]
            seen /= np.where(w > _BEHIND, w, np.nan)[..., None]
        return seen

    @lru_cache(maxsize=8)  # noqa: B019 - as above
    def _screen_matrix(self, size: Size) -> Array:
        """Return the (4, 4) matrix from the unit space to pixels and depth, still to be divided by w, read-only."""
        to_pixels = np.diag([size[0] / 2, -size[1] / 2, 1.0, 1.0])
        to_pixels[:2, 3] = size[0] / 2, size[1] / 2
        return read_only(to_pixels @ self.matrix(size))

    def unproject(self, screen: Array, size: Size) -> Array:
        """Return the points (..., 3) of the unit space that appear at x, y, depth (..., 3)."""
        ndc: Array = (screen - [size[0] / 2, size[1] / 2, 0]) / [size[0] / 2, -size[1] / 2, 1]
        inverse = np.linalg.inv(self.matrix(size))
        clip: Array = ndc @ inverse[:, :3].T + inverse[:, 3]
        points: Array = clip[..., :3] / clip[..., 3:]
        return points

    def ray(self, x: float, y: float, size: Size) -> tuple[Array, Array]:
        """Return a point (3,) and the unit direction (3,) of the line of sight through a pixel, away from
        the eye."""
        near, far = self.unproject(np.array([[x, y, -1.0], [x, y, 1.0]]), size)
        return near, (far - near) / np.linalg.norm(far - near)

    def pixel_length(self, size: Size, at: Array | None = None) -> float:
        """Return the unit lengths that one logical pixel covers at a point's depth, (3,), or at the centre's."""
        depth = 1.0
        if at is not None and self.perspective:
            depth -= float((at - np.array(self.centre)) @ self.axes[2]) / self.distance
        return depth * self.span / min(size)

    def orbited(self, azimuth: float, elevation: float, about: Array | None = None) -> Camera:
        """Return the camera turned by degrees; it stops at the poles, so that up stays up.

        Parameters
        ----------
        about : the point (3,) of the unit space that stays where it is seen; None for the centre
        """
        tilted = min(90.0, max(-90.0, self.elevation + elevation))
        turned = replace(self, azimuth=(self.azimuth + azimuth + 180) % 360 - 180, elevation=tilted)
        if about is None:
            return turned
        seen = self.axes @ (about - np.array(self.centre))
        return replace(turned, centre=tuple((about - turned.axes.T @ seen).tolist()))

    def panned(self, dx: float, dy: float, size: Size) -> Camera:
        """Return the camera moved so that what it shows moves by logical pixels."""
        right, up, _ = self.axes
        centre = np.array(self.centre) + self.pixel_length(size) * (dy * up - dx * right)
        return replace(self, centre=tuple(centre.tolist()))

    def zoomed(self, factor: float, at: tuple[float, float], size: Size) -> Camera:
        """Return the camera that shows things ``factor`` times as large, with the pixel ``at`` staying in
        place."""
        low, high = SPAN_LIMITS
        span = min(high, max(low, self.span / factor))
        dx, dy = at[0] - size[0] / 2, at[1] - size[1] / 2
        moved = 1 - span / self.span
        return replace(self.panned(-dx * moved, -dy * moved, size), span=span)

    def toward(self, other: Camera, part: float) -> Camera:
        """Return the camera on the way to another, from 0 (here) to 1 (there), turning the shorter way
        round."""
        turn = (other.azimuth - self.azimuth + 180) % 360 - 180
        centre = np.array(self.centre) * (1 - part) + np.array(other.centre) * part
        return replace(
            other,
            azimuth=self.azimuth + turn * part,
            elevation=self.elevation + (other.elevation - self.elevation) * part,
            centre=tuple(centre.tolist()),
            span=self.span * (other.span / self.span) ** part,
        )


def named_view(name: str, camera: Camera) -> Camera:
    """Return the camera looking in a named direction.

    Raises
    ------
    KeyError : there is no such direction
    """
    azimuth, elevation = NAMED_VIEWS[name]
    return replace(camera, azimuth=azimuth, elevation=elevation)


def looking_at(camera: Camera, points: Array) -> Camera:
    """Return the camera, in its direction, with points (k, 3) of the unit space in the middle, and what is around."""
    middle = (points.min(axis=0) + points.max(axis=0)) / 2
    extent = float(np.linalg.norm(points - middle, axis=1).max())
    span = min(SPAN_LIMITS[1], max(_AROUND, 2 * _AROUND * extent))
    return replace(camera, centre=tuple(middle.tolist()), span=span)


@dataclass(frozen=True)
class Margins:
    """Logical pixels that a fitted picture leaves free on each side, for labels and the colour bar."""

    left: float
    top: float
    right: float
    bottom: float


def fitted(camera: Camera, half_extents: Array, size: Size, margins: Margins) -> Camera:
    """Return the camera, in its direction, that shows the box around the origin as large as the margins
    allow.

    Parameters
    ----------
    half_extents : (3,) half the box in the unit space
    """
    signs = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)])
    corners = read_only(signs * half_extents)
    room = np.array([size[0] - margins.left - margins.right, size[1] - margins.top - margins.bottom])
    room = np.maximum(room, 0.2 * np.array(size))
    target = np.array([margins.left, margins.top]) + room / 2
    result = replace(camera, centre=(0.0, 0.0, 0.0), span=float(4 * np.linalg.norm(half_extents)))
    for _ in range(12 if camera.perspective else 1):  # in perspective, size and place depend on one another
        seen = result.project(corners, size)[:, :2]
        extent = np.maximum(np.ptp(seen, axis=0), 1e-6)
        result = replace(result, span=result.span * float((extent / room).max()))
        seen = result.project(corners, size)[:, :2]
        dx, dy = target - (seen.min(axis=0) + seen.max(axis=0)) / 2
        result = result.panned(float(dx), float(dy), size)
    return result
