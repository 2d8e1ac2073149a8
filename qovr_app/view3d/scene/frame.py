"""The frame: how the document's space is laid into the unit space in which cameras, lights and grids work."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from qovr_app.state.display import Scaling
from qovr_app.style.ticks import is_flat, round_limits
from qovr_app.view3d.scene.grid import touched_windows
from qovr_core.arrays import Array, read_only
from qovr_core.geometry.differential import ParametricSurface
from qovr_core.geometry.patch import Patch

HALF_EXTENTS = read_only(np.array([1.0, 1.0, 0.62]))
"""Half the axes box when every axis is scaled by itself: a little flat, so that the surface lies rather
than stands."""

FARTHEST = 1e6
"""Unit lengths: what is farther off is drawn there, out of sight at every magnification, and nothing overflows."""

WILDEST = 1e60
"""Unit lengths, of the coefficients of a patch that swings far beyond its samples: their products are finite."""

_LARGEST = 1e300
"""Coordinates up to which axes reach: the extent between larger ones overflows."""


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

    def laid(self, surface: ParametricSurface) -> ParametricSurface:
        """Return a surface of the document's space in the unit space; the same kind of surface.

        It is moved before it is scaled: far from the origin the two at once would leave nothing but rounding.
        """
        moved, scaled = np.eye(4), np.diag([*self.scale, 1.0])
        moved[:3, 3] = -self.centre
        return surface.transformed(moved).transformed(scaled)

    def laid_patch(self, patch: Patch, known: tuple[Patch, Patch] | None = None) -> Patch:
        """Return a patch of the document's space in the unit space, its coefficients no larger than ``WILDEST``.

        Parameters
        ----------
        known : another patch and what it is in the unit space; only windows that differ from it are laid anew
        """
        touched = touched_windows(known[0], patch) if known else None
        if known is None or touched is None:
            return patch.mapped(lambda points: self._laid_points(points, WILDEST))
        coefficients = known[1].coefficients.copy()
        coefficients[touched] = self._laid_points(patch.coefficients[touched], WILDEST)
        return Patch(read_only(coefficients), patch.degree, patch.lengths)

    def to_unit(self, points: Array) -> Array:
        """Return points (..., 3) of the document in the unit space, none of them farther off than ``FARTHEST``."""
        return self._laid_points(points, FARTHEST)

    @np.errstate(over="ignore")
    def _laid_points(self, points: Array, limit: float) -> Array:
        laid = points - self.centre
        laid *= self.scale
        return np.clip(laid, -limit, limit, out=laid)


def frame_around(boxes: list[Array], scaling: Scaling) -> Frame:
    """Return the frame whose round limits hold all boxes, each (3, 2) with columns min and max.

    An axis without extent is no wider than the others, which could not be seen beside it.
    """
    low, high = np.clip([np.min(boxes, axis=0)[:, 0], np.max(boxes, axis=0)[:, 1]], -_LARGEST, _LARGEST)
    ends = list(zip(low.tolist(), high.tolist(), strict=True))
    widest = max((b - a for a, b in ends if not is_flat(a, b)), default=math.inf)
    limits = np.array([round_limits(a, b, widest) for a, b in ends])
    extents = limits[:, 1] - limits[:, 0]
    scale = np.full(3, 2 / extents.max()) if scaling is Scaling.EQUAL else 2 * HALF_EXTENTS / extents
    return Frame(read_only(limits), read_only(scale))
