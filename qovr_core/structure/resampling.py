"""Nets that run through any surface."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import numpy as np
import numpy.typing as npt

from qovr_core.arrays import Array, read_only
from qovr_core.construction import build_patch
from qovr_core.document import Document
from qovr_core.errors import QovrError
from qovr_core.formulations import Formulation
from qovr_core.geometry.differential import ParametricSurface
from qovr_core.geometry.knots import Direction
from qovr_core.geometry.nodes import knots_of_steps
from qovr_core.geometry.windows import STEP
from qovr_core.structure.change import (
    FEWEST_WHERE_CLOSED,
    MOST_WINDOWS,
    PLACES,
    NetChange,
    by_windows,
    largest_distance,
)


def resample(
    surface: ParametricSurface,
    windows: tuple[int, int],
    nodes: tuple[npt.ArrayLike, npt.ArrayLike] | None = None,
    *,
    closed: Iterable[str] = (),
    samples: Sequence[int] = (101, 101),
) -> NetChange:
    """Return a document whose interpolating surface runs through points of another one, and how far it is from it.

    The outermost rows and columns give it the surface's tangents along its edges. All curves of a direction share the
    knots that the nodes say. Between the points it is of order 3: half the steps leave an eighth of the error.

    Parameters
    ----------
    surface : what is met, over its whole domain
    windows : (m, n), along v and along u
    nodes : where along u, (2n + 1,), and along v, (2m + 1,), the surface is met, from end to end of its domain; None
        for evenly spaced ones, whose knots are .5
    closed : the directions in which the surface closes, and the net with it
    samples : of the document; where a net needs more, it has one interval a window

    Raises
    ------
    QovrError : there are more windows than a net may have, or too few where it closes
    ValueError : the nodes are of another number, or do not increase

    Examples
    --------
    >>> from qovr_core.laboratory.splines import bezier
    >>> dome = bezier([[[x, y, x * (2 - x) + y * (2 - y)] for x in range(3)] for y in range(3)])
    >>> change = resample(dome, (1, 1))
    >>> change.motion < 1e-14, change.document.control_points[1, 1].tolist()
    (True, [0.0, 0.0, 0.0])
    """
    closed = tuple(closed)
    along = []
    for k, direction in enumerate(Direction):
        count, is_closed = windows[1 - k], direction.parameter in closed
        _check_count(count, direction, is_closed=is_closed)
        start, end = surface.domain[k]
        if nodes is None:
            even = np.full(STEP * count, (end - start) / (STEP * count))
            along.append(_Nodes(np.linspace(start, end, STEP * count + 1), even, is_closed))
        else:
            at = np.asarray(nodes[k], dtype=np.float64)
            along.append(_Nodes(at, np.diff(at), is_closed))
    u, v = along
    net = _net(surface, u, v)
    knots_u, knots_v = (
        np.broadcast_to(knots, (curves, *knots.shape))
        for knots, curves in zip(map(knots_of_steps, (u.steps, v.steps)), net.shape[:2], strict=True)
    )
    enough = [max(count, least + 1) for count, least in zip(samples, reversed(windows), strict=True)]
    document = Document(net, knots_u, knots_v, Formulation.INTERPOLATING, enough, closed=closed)
    met = by_windows(build_patch(document)).points(*(each.places_in_windows for each in along))
    return NetChange(document, largest_distance(met, surface.points(*(each.places for each in along))), None)


class _Nodes:
    """Where a surface is met along one parameter, and the steps from node to node, one more at either end."""

    def __init__(self, at: Array, inner: Array, is_closed: bool) -> None:
        self.at, self.is_closed = at, is_closed
        ends = (inner[-1:], inner[:1]) if is_closed else (inner[:1], inner[-1:])
        self.steps = np.concatenate([ends[0], inner, ends[1]])

    @property
    def places(self) -> Array:
        """Places all over the surface, some in each window."""
        starts = self.at[:-1:STEP, None]
        places: Array = (starts + np.diff(self.at[::STEP])[:, None] * PLACES).ravel()
        return places

    @property
    def places_in_windows(self) -> Array:
        """The same as window + place in it."""
        places: Array = (np.arange(len(self.at) // STEP)[:, None] + PLACES).ravel()
        return places

    def extended(self, values: Array, tangents: Array) -> Array:
        """Return values at the nodes (k, ...) with one more at either end, (k + 2, ...), that gives the tangents there.

        Where the nodes close, these are the values on the other side.
        """
        if self.is_closed:
            values = np.concatenate([values[:-1], values[:1]])
            return np.concatenate([values[-2:-1], values, values[1:2]])
        first = _beyond(values[0], values[1], tangents[0], self.steps[:3])
        last = _beyond(values[-1], values[-2], -tangents[1], self.steps[:-4:-1])
        return np.concatenate([first[None], values, last[None]])


def _beyond(end: Array, next_: Array, tangent: Array, steps: Array) -> Array:
    """Return the value beyond an end with which the first derivative there, away from it, is a tangent.

    From b'(0) of a curve, with the window's length h: P0 = ((1 - 2r) P1 + r^2 P2 - u r h S_u) / (1 - r)^2.
    """
    r = steps[0] / (steps[0] + steps[1])
    result: Array = ((1 - 2 * r) * end + r**2 * next_ - r * steps[1] * tangent) / (1 - r) ** 2  # u h is the first step
    return result


def _net(surface: ParametricSurface, u: _Nodes, v: _Nodes) -> Array:
    """Return the points of a net, (rows, columns, 3); in its corners the mixed derivative counts."""
    ends_u, ends_v = u.at[[0, -1]], v.at[[0, -1]]
    inner = v.extended(surface.points(u.at, v.at).swapaxes(0, 1), surface.derivative(u.at, ends_v, 0, 1).swapaxes(0, 1))
    tangents = v.extended(
        surface.derivative(ends_u, v.at, 1, 0).swapaxes(0, 1), surface.derivative(ends_u, ends_v, 1, 1).swapaxes(0, 1)
    )
    return read_only(u.extended(inner.swapaxes(0, 1), tangents.swapaxes(0, 1)).swapaxes(0, 1).copy())


def _check_count(count: int, direction: Direction, *, is_closed: bool) -> None:
    fewest = FEWEST_WHERE_CLOSED if is_closed else 1
    if not fewest <= count <= MOST_WINDOWS:
        net = "net that closes" if is_closed else "net"
        raise QovrError(
            f"{count} windows along {direction.parameter} are no {net}; expected {fewest} to {MOST_WINDOWS} of them"
        )
