"""Where the names of a curve's points and parabolas stand in a drawing of it."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from qovr_core.arrays import Array
from qovr_core.laboratory.labels import free_place, place_labels
from qovr_core.laboratory.one_curve import SAMPLES, OneCurve
from qovr_core.laboratory.planes import Plane

FLATTEST = 0.02
"""Across a curve that is straight a drawing shows this part of its length, not rounding drawn large."""

_DENSE = 1001
"""Points of a line that may run far out of the drawing, so that enough of them are in it."""

_DISC = 25
"""A disc is as much in a name's way as so many points of a line."""


def seen_points(curve: OneCurve, plane: Plane) -> Array:
    """Return points of what a drawing must show, the curve and the whole parabolas, as they are drawn, (n, 2)."""
    return plane.drawn(np.concatenate([curve.at(SAMPLES), *(curve.parabola(p, SAMPLES) for p in range(3))]))


def named_places(curve: OneCurve, plane: Plane, to_pixels: Callable[[Array], Array]) -> Array:
    """Return what the names belong to, as it is drawn: the five points, and on each parabola a place of its own.

    Parameters
    ----------
    to_pixels : maps drawn points (n, 2) to pixels

    Returns
    -------
    (8, 2) float64
    """
    points = plane.drawn(curve.points)
    others = to_pixels(np.concatenate([plane.drawn(curve.at(SAMPLES)), points]))
    parts = [plane.drawn(curve.parabola(p, curve.free_part(p))) for p in range(3)]
    return np.concatenate([points, [part[free_place(to_pixels(part), others)] for part in parts]])


def name_centres(
    curve: OneCurve,
    plane: Plane,
    named: Array,
    to_pixels: Callable[[Array], Array],
    sizes: Array,
    *,
    gap: float,
    box: Array,
) -> Array:
    """Return where the centres of the names lie, clear of lines, discs and each other.

    Parameters
    ----------
    named : (8, 2) the places that ``named_places`` returns for the same curve, plane and ``to_pixels``
    to_pixels : as there
    sizes : (8, 2) widths and heights of the names in pixels, in the order of ``named``
    gap : pixels between a name and its place
    box : (2, 2) lower left and upper right corner of the drawing in pixels

    Returns
    -------
    (8, 2) float64, in pixels
    """
    places = to_pixels(named)
    count = len(curve.points)
    points, middle = places[:count], to_pixels(plane.drawn(curve.at(SAMPLES))).mean(axis=0)
    ends = np.pad(points, ((1, 1), (0, 0)), mode="edge")
    outward = points - (ends[:-2] + ends[2:]) / 2
    beyond = [curve.parabola(p, np.linspace(*curve.auxiliary[p], _DENSE)) for p in range(3)]
    lines = to_pixels(np.concatenate([seen_points(curve, plane), plane.drawn(np.concatenate(beyond))]))
    obstacles = np.concatenate([lines, np.repeat(points, _DISC, axis=0)])
    wanted = np.concatenate([outward, places[count:] - middle])
    return place_labels(places, sizes, wanted, obstacles, gap=gap, box=box)
