"""What follows where control points are moved: their mirror images, and softly the points around them.

Displacements are an array of the net's shape, (rows, columns, 3), beside flags (rows, columns) that say which points
are moved at all. Nets of every size; NumPy alone.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import ceil

import numpy as np

from qovr_core.arrays import Array, Flags

Moves = tuple[Array, Flags]
"""The displacement of every point, and which of them are moved."""


@dataclass(frozen=True)
class Mirror:
    """A plane of symmetry through the middle of a net.

    Parameters
    ----------
    axis : of the net that is turned round, 0 for rows and 1 for columns: (i, j) mirrors (i, N-1-j)
    coordinate : of the plane's normal, 0, 1 or 2 for x, y, z
    at : where the plane cuts its normal; None for the mean of the middle row or column
    """

    axis: int
    coordinate: int
    at: float | None = None

    def flipped(self, array: Array) -> Array:
        """Return an array over the net in which every point has its partner's entry, vectors mirrored."""
        turned = np.flip(array, self.axis).copy()
        turned[..., self.coordinate] *= -1
        return turned

    def place(self, net: Array) -> float:
        """Return where the plane cuts its normal: where it is told to, or at the mean of the middle line or two."""
        if self.at is not None:
            return self.at
        count = net.shape[self.axis]
        middle = net.take(range((count - 1) // 2, count // 2 + 1), self.axis)
        return float(middle[..., self.coordinate].mean())


ROWS_MIRROR, COLUMNS_MIRROR = Mirror(0, 1), Mirror(1, 0)
"""Across rows in a plane of constant y, across columns in one of constant x, as the paper's nets lie."""


def mirrored(moves: Moves, mirror: Mirror, leader: tuple[int, int]) -> Moves:
    """Return the moves with their mirror images.

    Points of the middle stay in the plane. Where both of a pair are moved, the side on which ``leader`` lies decides;
    where it lies in the middle, both move by the mean.
    """
    field, moved = moves
    image, imaged = mirror.flipped(field), np.flip(moved, mirror.axis)
    last = field.shape[mirror.axis] - 1
    side = np.sign(2 * np.arange(last + 1) - last)
    shape = (-1, 1) if mirror.axis == 0 else (1, -1)
    of_point = np.broadcast_to(side.reshape(shape), moved.shape)
    of_leader = int(side[leader[mirror.axis]])
    own = np.where(of_point == 0, 0.5, np.where(of_leader == 0, 0.5, of_point == of_leader))
    weights = np.where(moved & imaged, own, moved)
    return field * weights[..., None] + image * np.where(moved | imaged, 1 - weights, 0)[..., None], moved | imaged


def softened(moves: Moves, radius: float) -> Moves:
    """Return the moves fading out over the points around: smoothstep of the steps along the net.

    A point k steps along the net's lines from the nearest moved ones follows their mean by smoothstep(1 - k / radius);
    those that are moved themselves move as they did.
    """
    field, reached = moves
    field, reached = field.copy(), reached.copy()
    front, carried = reached, field * reached[..., None]
    for steps in range(1, ceil(radius)):
        count = _summed(front[..., None].astype(np.float64))[..., 0]
        front = (count > 0) & ~reached
        if not front.any():
            break
        carried = np.where(front[..., None], _summed(carried) / np.maximum(count, 1)[..., None], 0.0)
        field += carried * smoothstep(1 - steps / radius)
        reached |= front
    return field, reached


def smoothstep(x: float) -> float:
    """Return 3 x^2 - 2 x^3: from 0 at 0 to 1 at 1, level at both."""
    return x * x * (3 - 2 * x)


def _summed(values: Array) -> Array:
    """Return for every point of a net the sum over its neighbours along the net's lines."""
    wide = np.pad(values, ((1, 1), (1, 1), (0, 0)))
    total: Array = wide[:-2, 1:-1] + wide[2:, 1:-1] + wide[1:-1, :-2] + wide[1:-1, 2:]
    return total
