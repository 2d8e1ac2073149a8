"""The handles of the knots: each on the chord between the outer two of three points of a curve. NumPy alone."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from qovr_app.view3d.scene.frame import Frame
from qovr_core.arrays import Array, read_only
from qovr_core.geometry.knots import Direction, KnotPlace, Knots

_SHORTEST = 1e-9
"""Unit lengths of a chord below which its ends are one point, and a knot has nowhere to go on it."""

_CHORDS = {"r": 0, "s": 1, "u": 1, "t": 2}
"""By the knot, which of a window's points its chord begins at; it ends two points on."""


@dataclass(frozen=True)
class CurveInHand:
    """The curve whose knots have handles.

    Parameters
    ----------
    focus : the knot that is turned to, on this curve
    window : the window along the curve
    knots : of the curve there
    """

    focus: KnotPlace
    window: int
    knots: Knots


@dataclass(frozen=True, eq=False)
class KnotHandle:
    """A knot as a place on a chord.

    Parameters
    ----------
    place : which knot
    window : the window along the curve
    value : the knot
    ends : (2, 3) the chord, in the document's units
    takes_s : whether this is the handle of u, and s is the same number: then s goes with it
    """

    place: KnotPlace
    window: int
    value: float
    ends: Array
    takes_s: bool = False

    def at(self, value: float) -> Array:
        """Return where the handle of another value would be, (3,) in the document's units."""
        start, end = self.ends
        point: Array = start + value * (end - start)
        return point

    @property
    def point(self) -> Array:
        """Where it is, (3,) in the document's units."""
        return self.at(self.value)

    @property
    def way(self) -> Array:
        """The chord from its beginning to its end, (3,) in the document's units."""
        way: Array = self.ends[1] - self.ends[0]
        return way


def handles_of(curve: CurveInHand, net: Array, frame: Frame) -> list[KnotHandle]:
    """Return the handles of a curve of a net (k, l, 3) that have a chord; u and s are one while they are one number."""
    points = net[curve.focus.curve] if curve.focus.direction is Direction.ROWS else net[:, curve.focus.curve]
    is_one = curve.knots.is_quartic
    handles = []
    for name, first in _CHORDS.items():
        ends = points[2 * curve.window + first :][[0, 2]]
        has_chord = np.linalg.norm(np.diff(frame.to_unit(ends), axis=0)) > _SHORTEST
        if has_chord and not (name == "s" and is_one):
            place, value = replace(curve.focus, name=name), getattr(curve.knots, name)
            handles.append(KnotHandle(place, curve.window, value, read_only(ends), name == "u" and is_one))
    return handles
