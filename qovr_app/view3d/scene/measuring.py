"""Distances and an angle between places that are clicked: control points, or points of the surface. NumPy alone."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from qovr_app.view3d.scene.probing import Parameters
from qovr_app.view3d.scene.scene import Scene
from qovr_core.arrays import Array
from qovr_core.document import NetIndex

MOST_SPOTS = 3
"""Two places have a distance, three an angle at the one in the middle; the next click begins anew."""


@dataclass(frozen=True)
class Spot:
    """A place that stays where it is on the net or on the surface while these are edited.

    Parameters
    ----------
    index : the control point; None on the surface
    parameters : u and v on the surface; None at a control point
    """

    index: NetIndex | None = None
    parameters: Parameters | None = None

    @property
    def name(self) -> str:
        """What to call it."""
        if self.index is not None:
            return "P {},{}".format(*self.index)
        return "" if self.parameters is None else "S({:.3g}, {:.3g})".format(*self.parameters)

    def place(self, scene: Scene) -> Array:
        """Return where it is, (3,) in the document's units."""
        if self.parameters is not None:
            u, v = self.parameters
            return np.array(scene.surface.points([u], [v])[0, 0])
        return np.array(scene.document.control_points[self.index])


@dataclass(frozen=True)
class Measure:
    """What lies between places.

    Parameters
    ----------
    names : of the places
    ways : from each place to the next, in the document's units
    lengths : of the ways
    angle : between the ways at the place in the middle, in degrees; None of two places, or where one has no length
    """

    names: tuple[str, ...]
    ways: tuple[tuple[float, ...], ...]
    lengths: tuple[float, ...]
    angle: float | None


def measured(scene: Scene, spots: Sequence[Spot]) -> Measure:
    """Return what lies between places of a scene."""
    places = np.array([spot.place(scene) for spot in spots]).reshape(-1, 3)
    ways = np.diff(places, axis=0)
    lengths = np.linalg.norm(ways, axis=1)
    angle = None
    if len(ways) > 1 and lengths.min() > 0:
        back, on = -ways[0] / lengths[0], ways[1] / lengths[1]
        # The half angle from sum and difference is exact where the cosine alone would lose small angles.
        angle = float(np.degrees(2 * np.arctan2(np.linalg.norm(back - on), np.linalg.norm(back + on))))
    return Measure(tuple(spot.name for spot in spots), tuple(map(tuple, ways.tolist())), tuple(lengths.tolist()), angle)


def measure_text(measure: Measure) -> str:
    """Return a measure for the clipboard: a name and its numbers a line, at full precision, between tabs."""
    names = measure.names
    lines = [
        "\t".join([f"{a} to {b}", *map(repr, (length, *way))])
        for a, b, length, way in zip(names, names[1:], measure.lengths, measure.ways, strict=False)
    ]
    if measure.angle is not None:
        lines.append(f"angle at {names[1]}\t{measure.angle!r}")
    return "".join(f"{line}\n" for line in lines)
