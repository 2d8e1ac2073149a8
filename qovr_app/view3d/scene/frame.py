"""The frame: how the document's space is laid into the unit space in which cameras, lights and grids work."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from qovr_app.state.display import Scaling
from qovr_app.style.ticks import round_limits
from qovr_core.arrays import Array, read_only

HALF_EXTENTS = read_only(np.array([1.0, 1.0, 0.62]))
"""Half the axes box when every axis is scaled by itself: a little flat, so that the surface lies rather
than stands."""


@dataclass(frozen=True, eq=False)
class Frame:
    """Limits of the axes and the scales that bring them to the unit space.

    Parameters
    ----------
    limits : (3, 2) in the document's units, columns low and high, low < high
    scale : (3,) unit-space lengths per unit of the document
    """

    limits: Array
    scale: Array

    @property
    def centre(self) -> Array:
        """The middle of the limits, (3,), which is the origin of the unit space."""
        centre: Array = self.limits.mean(axis=1)
        return centre

    @property
    def half_extents(self) -> Array:
        """Half the axes box in the unit space, (3,)."""
        return (self.limits[:, 1] - self.limits[:, 0]) / 2 * self.scale

    @property
    def matrix(self) -> Array:
        """The (4, 4) affine matrix from the document's space to the unit space."""
        matrix = np.diag([*self.scale, 1.0])
        matrix[:3, 3] = -self.centre * self.scale
        return matrix

    def to_unit(self, points: Array) -> Array:
        """Return points (..., 3) of the document in the unit space."""
        return (points - self.centre) * self.scale

    def to_document(self, points: Array) -> Array:
        """Return points (..., 3) of the unit space in the document's."""
        return points / self.scale + self.centre


def frame_around(boxes: list[Array], scaling: Scaling) -> Frame:
    """Return the frame whose round limits hold all boxes, each (3, 2) with columns min and max."""
    low = np.min([box[:, 0] for box in boxes], axis=0)
    high = np.max([box[:, 1] for box in boxes], axis=0)
    limits = np.array([round_limits(a, b) for a, b in zip(low.tolist(), high.tolist(), strict=True)])
    extents = limits[:, 1] - limits[:, 0]
    scale = np.full(3, 2 / extents.max()) if scaling is Scaling.EQUAL else 2 * HALF_EXTENTS / extents
    return Frame(read_only(limits), read_only(scale))
