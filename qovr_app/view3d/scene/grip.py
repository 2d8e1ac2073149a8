"""Where a point belongs that a hand moves: along axes, along a way of its own, or in the plane of the view.

NumPy alone.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from qovr_app.view3d.scene.camera import Camera, Size
from qovr_app.view3d.scene.frame import Frame
from qovr_core.arrays import Array, read_only

_STEEP = 0.12
"""Sine of the angle between the line of sight and a way, or its plane, below which a pixel would mean a leap along it:
what cannot be seen to move follows the mouse's vertical way instead."""

_LEVEL = 1e-9
"""Pixels between two places on the screen below which the way from one to the other has no direction."""


@dataclass(frozen=True)
class Freedom:
    """What may change while a point is moved.

    Parameters
    ----------
    axes : the axes 0, 1, 2 along which it moves: one is a line, two a plane, all three the plane of the view
    along_way : it moves along a way of its own, and ``axes`` is empty
    """

    axes: tuple[int, ...] = ()
    along_way: bool = False

    @property
    def axis(self) -> int | None:
        """The one axis along which it moves; None where there is another way."""
        return self.axes[0] if len(self.axes) == 1 else None


IN_VIEW = Freedom((0, 1, 2))
ALONG_WAY = Freedom(along_way=True)


def along(axis: int) -> Freedom:
    """Return the freedom of a line along an axis."""
    return Freedom((axis,))


def across(axis: int) -> Freedom:
    """Return the freedom of the plane that an axis stands on."""
    return Freedom(tuple(other for other in range(3) if other != axis))


@dataclass(frozen=True, eq=False)
class Grip:
    """A point as it was when the hand took it; every move is computed from here, never from the last one.

    Parameters
    ----------
    frame, camera, size : as they were then
    point : (3,) where the point was, in the document's units
    way : (3,) a way of the point's own, in the document's units: the surface's normal, a knot's chord
    at : the pixel where the mouse was
    freedom : what may change
    fineness : what part of the mouse's way the point goes
    """

    frame: Frame
    camera: Camera
    size: Size
    point: Array
    way: Array
    at: tuple[float, float]
    freedom: Freedom
    fineness: float = 1.0

    def moved(self, x: float, y: float) -> Array:
        """Return how far the point goes when the mouse is at a pixel, (3,) in the document's units."""
        dx, dy = self.fineness * (x - self.at[0]), self.fineness * (y - self.at[1])
        ways = self.ways
        if self.freedom == IN_VIEW:
            move = self._in_view(dx, dy)
        elif len(ways) == 1:
            move = self._along(ways[0], dx, dy) * ways[0]
        else:
            move = self._in_plane(ways, dx, dy)
        result: Array = move / self.frame.scale
        return result

    @property
    def ways(self) -> Array:
        """The unit vectors (k, 3) of the unit space along which the point moves."""
        if self.freedom.along_way:
            way = self.way * self.frame.scale
            return read_only((way / np.linalg.norm(way))[None])
        return read_only(np.eye(3)[list(self.freedom.axes)])

    @property
    def pixel(self) -> Array:
        """How far a pixel's way is along each axis where the point is, (3,) in the document's units."""
        size: Array = self.fineness * self._pixel / self.frame.scale
        return size

    @property
    def _start(self) -> Array:
        return self.frame.to_unit(self.point)

    @property
    def _pixel(self) -> float:
        """The unit lengths that a pixel covers at the point's depth."""
        return self.camera.pixel_length(self.size, self._start)

    def _in_view(self, dx: float, dy: float) -> Array:
        seen = self.camera.project(self._start[None], self.size)[0]
        goal = seen + np.array([dx, dy, 0.0])
        move: Array = self.camera.unproject(goal[None], self.size)[0] - self._start
        return move

    def _sight(self, dx: float, dy: float) -> tuple[Array, Array]:
        """Return the line of sight through the point's pixel moved so far: where it begins, and its direction."""
        seen = self.camera.project(self._start[None], self.size)[0]
        return self.camera.ray(seen[0] + dx, seen[1] + dy, self.size)

    def _along(self, way: Array, dx: float, dy: float) -> float:
        """Return how far along a way its line comes closest to the line of sight, or the mouse has gone upward."""
        origin, sight = self._sight(dx, dy)
        seen_across = 1 - (sight @ way) ** 2
        if seen_across < _STEEP**2:
            return -dy * self._pixel
        offset = self._start - origin
        return float(((sight @ way) * (sight @ offset) - offset @ way) / seen_across)

    def _in_plane(self, ways: Array, dx: float, dy: float) -> Array:
        """Return where the line of sight meets the plane; in a plane seen edge on, what is seen of it and up."""
        origin, sight = self._sight(dx, dy)
        upright = np.cross(*ways)
        if abs(sight @ upright) >= _STEEP:
            distance = (self._start - origin) @ upright / (sight @ upright)
            move: Array = origin + distance * sight - self._start
            return move
        seen_way = np.cross(upright, sight)
        seen_way /= np.linalg.norm(seen_way)
        hidden_way = np.cross(seen_way, upright)
        places = self.camera.project(np.stack([self._start, self._start + self._pixel * seen_way]), self.size)
        ex, ey = places[1, :2] - places[0, :2]
        length = math.hypot(ex, ey)
        aside = (dx * ey - dy * ex) / length if length > _LEVEL else -dy
        if sight @ hidden_way < 0:  # up, or to the left, is away from the viewer
            hidden_way = -hidden_way
        return self._along(seen_way, dx, dy) * seen_way + aside * self._pixel * hidden_way


def rounded(values: Array, pixel: Array, step: float | None) -> Array:
    """Return coordinates (3,) as exact as a pixel means, or on multiples of a step, counted in decimals."""
    result = []
    for value, size in zip(values.tolist(), pixel.tolist(), strict=True):
        if step is not None:
            result.append(float(f"{round(value / step) * step:.12g}"))
        else:
            decimals = -math.floor(math.log10(size)) if size > 0 and math.isfinite(size) else 15
            result.append(round(value, decimals) + 0.0)
    return read_only(np.array(result))
