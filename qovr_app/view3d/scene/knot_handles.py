"""The handles of the knots: each on the chord between the outer two of three points of a curve. NumPy alone."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from qovr_app.state.knot_in_hand import KnotInHand
from qovr_app.view3d.scene.frame import Frame
from qovr_core.arrays import Array, read_only
from qovr_core.geometry.knots import Direction

_SHORTEST = 1e-9
"""Unit lengths of a chord below which its ends are one point, and a knot has nowhere to go on it."""

_CHORDS = {"r": 0, "s": 1, "u": 1, "t": 2}
"""By the knot, which of a window's points its chord begins at; it ends two points on."""


@dataclass(frozen=True, eq=False)
class KnotHandle:
    """A knot as a place on a chord.

    Parameters
    ----------
    knot : which knot, of what curve
    ends : (2, 3) the chord, in the document's units
    """

    knot: KnotInHand
    ends: Array

    def at(self, value: float) -> Array:
        """Return where the handle of another value would be, (3,) in the document's units."""
        point: Array = self.ends[0] + value * self.way
        return point

    @property
    def point(self) -> Array:
        """Where it is, (3,) in the document's units."""
        return self.at(self.knot.value)

    @property
    def way(self) -> Array:
        """The chord from its beginning to its end, (3,) in the document's units."""
        way: Array = self.ends[1] - self.ends[0]
        return way


def handles_of(curve: KnotInHand, net: Array, frame: Frame) -> list[KnotHandle]:
    """Return the handles of a curve of a net (k, l, 3) that have a chord."""
    number, is_row = curve.place.curve, curve.place.direction is Direction.ROWS
    points = net[number] if is_row else net[:, number]
    handles = []
    for knot in curve.on_curve:
        first = 2 * curve.window + _CHORDS[knot.place.name]
        ends = points[[first, first + 2]]
        if np.linalg.norm(np.diff(frame.to_unit(ends), axis=0)) > _SHORTEST:
            handles.append(KnotHandle(knot, read_only(ends)))
    return handles
