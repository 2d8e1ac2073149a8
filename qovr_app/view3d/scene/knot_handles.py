"""The handles of the knots: each on the chord between the outer two of three points of a curve. NumPy alone."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from qovr_app.state.knot_in_hand import KnotInHand
from qovr_app.view3d.scene.camera import Camera, Size
from qovr_app.view3d.scene.frame import Frame
from qovr_core.arrays import Array, read_only
from qovr_core.document import NetIndex
from qovr_core.geometry.knots import Direction, KnotPlace
from qovr_core.geometry.windows import NET_SIZE, STEP

_SHORTEST = 1e-9
"""Unit lengths of a chord below which its ends are one point, and a knot has nowhere to go on it."""

_APART = 12.0
"""Pixels that a handle keeps from the control point between its chord's ends, so that a hand can take either."""

_ON_CHORD = 0.5
"""Pixels from its chord within which that point lies on neither side of it."""

_CHORDS = {"r": 0, "s": 1, "u": 1, "t": 2}
"""By the knot, which of a window's points its chord begins at; it ends two points on."""


@dataclass(frozen=True, eq=False)
class KnotHandle:
    """A knot as a place on a chord.

    Parameters
    ----------
    knot : which knot, of what curve
    ends : (2, 3) the chord, in the document's units
    middle : (3,) the control point between its ends
    """

    knot: KnotInHand
    ends: Array
    middle: Array

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


def last_point(place: KnotPlace) -> NetIndex:
    """Return the last control point of a knot's curve in its window."""
    along = STEP * place.window + NET_SIZE - 1
    return (place.curve, along) if place.direction is Direction.ROWS else (along, place.curve)


def handles_of(curve: KnotInHand, net: Array, frame: Frame) -> list[KnotHandle]:
    """Return the handles of a curve of a net (k, l, 3) that have a chord."""
    number, is_row = curve.place.curve, curve.place.direction is Direction.ROWS
    points = net[number] if is_row else net[:, number]
    handles = []
    for knot in curve.on_curve:
        first = STEP * curve.place.window + _CHORDS[knot.place.name]
        ends, middle = points[[first, first + 2]], points[first + 1]
        if np.linalg.norm(np.diff(frame.to_unit(ends), axis=0)) > _SHORTEST:
            handles.append(KnotHandle(knot, read_only(ends), middle))
    return handles


def seen_handle(handle: KnotHandle, frame: Frame, camera: Camera, size: Size) -> tuple[Array, Array]:
    """Return the pixel at which a handle is drawn and taken, (2,), and the way on which its letter is, (2,).

    It lies on its chord, but for what it goes around the control point there; not numbers where it is behind the eye.
    """
    points = np.stack([handle.point, handle.middle, *handle.ends])
    at, middle, start, end = camera.project(frame.to_unit(points), size)[:, :2]
    way = end - start
    length = float(np.hypot(*way))
    aside = np.array([way[1], -way[0]]) / length if np.isfinite(length) and length > 1 else np.array([0.0, 1.0])
    if aside[1] < 0:  # below its chord: the points' names stand above them
        aside = -aside
    away = at - middle
    if not np.hypot(*away) < _APART:
        return at, aside
    if away @ aside < -_ON_CHORD:
        aside = -aside
    across = float(away @ aside)
    return at + (np.sqrt(across**2 + _APART**2 - away @ away) - across) * aside, aside
