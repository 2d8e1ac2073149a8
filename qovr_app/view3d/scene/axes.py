"""The axes box on the screen: which panes lie behind, which edges carry ticks, and where. NumPy alone."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from qovr_app.style.tick_labels import TickLabels, tick_labels
from qovr_app.style.ticks import tick_positions
from qovr_app.view3d.scene.camera import Camera, Size
from qovr_app.view3d.scene.frame import Frame
from qovr_core.arrays import Array

TITLES = ("X-Axis", "Y-Axis", "Z-Axis")

_SHORTEST = 26.0
"""An axis shorter than this on the screen points at the viewer: it has no room for ticks."""

_TICK_ROOM_UP, _TICK_ROOM_ACROSS = 24.0, 36.0
"""Pixels between ticks of an upright axis, and how many more a level one needs, whose texts stand side by
side."""

_MOST_INTERVALS = 6
"""More ticks on a long axis than on its neighbour would only set the two apart."""

_EDGE_ON = 1e-6
_SIGNS = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)])
_TIE = 1.5
"""Edges within this many pixels of one another are equally low on the screen."""


@dataclass(frozen=True, eq=False)
class AxisEdge:
    """One edge of the box that carries ticks; everything in logical pixels.

    ``start`` and ``end`` (2,), ``ticks`` (k, 2) with their ``labels``, ``outward`` (2,) a unit vector away from
    the box.
    """

    title: str
    start: Array
    end: Array
    ticks: Array
    labels: TickLabels
    outward: Array


@dataclass(frozen=True, eq=False)
class AxesBox:
    """The visible inside of the axes box: panes (p, 4, 2), grid lines (g, 2, 2), and the edges with ticks."""

    panes: Array
    grid: Array
    edges: list[AxisEdge]


def axes_box(frame: Frame, camera: Camera, size: Size) -> AxesBox:
    """Return how the axes box of a frame looks through a camera; nothing where the eye is too near."""
    half = frame.half_extents
    if not np.isfinite(camera.project(_SIGNS * half, size)).all():
        return AxesBox(np.empty((0, 4, 2)), np.empty((0, 2, 2)), [])
    sides = _back_sides(camera, half)
    chosen = [_edge_ends(axis, sides, half, camera, size) for axis in range(3)]
    positions = []
    for axis, ends in enumerate(chosen):
        start, end = camera.project(ends, size)[:, :2]
        positions.append(_ticks(frame.limits[axis], end - start))
    units = [(positions[axis] - frame.centre[axis]) * frame.scale[axis] for axis in range(3)]
    panes, grid = _panes(sides, half, units)
    middle = camera.project(np.zeros((1, 3)), size)[0, :2]
    edges = []
    for axis, ends in enumerate(chosen):
        along = ends[0] + np.zeros((len(units[axis]), 3))
        along[:, axis] = units[axis]
        ticks = camera.project(along, size)[:, :2]
        on_screen = camera.project(ends, size)[:, :2]
        edge = _axis_edge(TITLES[axis], on_screen, ticks, tick_labels(positions[axis].tolist()), middle)
        if edge is not None:
            edges.append(edge)
    return AxesBox(panes=camera.project(panes, size)[..., :2], grid=camera.project(grid, size)[..., :2], edges=edges)


def _back_sides(camera: Camera, half: Array) -> Array:
    """Return -1 or 1 for each axis: the face turned away from the viewer; the lower one where both are
    edge-on."""
    toward = camera.axes[2]
    if camera.perspective:
        eye = np.array(camera.centre) + camera.distance * toward
        return np.where(eye > half, -1.0, np.where(eye < -half, 1.0, np.where(toward >= 0, -1.0, 1.0)))
    return np.where(toward >= -_EDGE_ON, -1.0, 1.0)


def _edge_ends(axis: int, sides: Array, half: Array, camera: Camera, size: Size) -> Array:
    """Return the ends (2, 3) of the edge that carries an axis' ticks: on the floor and low, or upright and
    left."""
    others = [k for k in range(3) if k != axis]
    choices = []
    for a in (-1.0, 1.0):
        for b in (-1.0, 1.0):
            if axis != 2 and b != sides[2]:
                continue
            ends = np.empty((2, 3))
            ends[:, axis] = -half[axis], half[axis]
            ends[:, others] = np.array([a, b]) * half[others]
            choices.append(ends)
    places = [camera.project(ends, size)[:, :2].mean(axis=0) for ends in choices]
    if axis == 2:
        return choices[int(np.argmin([x for x, _ in places]))]
    lowest = max(y for _, y in places)
    level = [k for k, (_, y) in enumerate(places) if lowest - y < _TIE]
    return choices[min(level, key=lambda k: places[k][0])]


def _ticks(limits: Array, on_screen: Array) -> Array:
    length = float(np.hypot(*on_screen))
    level = abs(float(on_screen[0])) / max(length, 1.0)
    intervals = int(length / (_TICK_ROOM_UP + _TICK_ROOM_ACROSS * level))
    return tick_positions(float(limits[0]), float(limits[1]), min(max(intervals, 1), _MOST_INTERVALS))


def _panes(sides: Array, half: Array, units: list[Array]) -> tuple[Array, Array]:
    """Return the three far faces (3, 4, 3) and the grid lines on them (g, 2, 3) in the unit space."""
    panes, grid = [], []
    for axis in range(3):
        a, b = (k for k in range(3) if k != axis)
        corners = np.empty((4, 3))
        corners[:, axis] = sides[axis] * half[axis]
        corners[:, [a, b]] = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]]) * half[[a, b]]
        panes.append(corners)
        for along, across in ((a, b), (b, a)):
            lines = np.empty((len(units[along]), 2, 3))
            lines[..., axis] = sides[axis] * half[axis]
            lines[..., along] = units[along][:, None]
            lines[..., across] = np.array([-1, 1]) * half[across]
            grid.append(lines)
    return np.array(panes), np.concatenate(grid)


def _axis_edge(title: str, ends: Array, ticks: Array, labels: TickLabels, middle: Array) -> AxisEdge | None:
    """Return an edge with what it carries, all in pixels; None where it is too short to carry anything."""
    start, end = ends
    length = float(np.hypot(*(end - start)))
    if not length >= _SHORTEST:
        return None
    outward = np.array([end[1] - start[1], start[0] - end[0]]) / length
    if outward @ ((start + end) / 2 - middle) < 0:
        outward = -outward
    return AxisEdge(title, start, end, ticks, labels, outward)
