"""Nets with more windows, or fewer: inserted, removed, appended along the curves of a direction."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from qovr_core.arrays import Array, read_only
from qovr_core.document import Document
from qovr_core.edits import knots_of
from qovr_core.errors import QovrError
from qovr_core.geometry import bernstein
from qovr_core.geometry.knots import KNOT_NAMES, Direction, KnotTable
from qovr_core.geometry.weights import CURVE_DEGREE, weight_coefficients
from qovr_core.geometry.windows import NET_SIZE, STEP
from qovr_core.joints import Joint, can_be_smooth
from qovr_core.structure.change import (
    FEWEST_WHERE_CLOSED,
    NetChange,
    check_continuous,
    check_joint,
    check_room,
    check_window,
    motion_between,
)
from qovr_core.structure.joints import shared_value
from qovr_core.structure.lines import Lines, rebuilt
from qovr_core.structure.turning import from_the_end, transpose

_R, _S, _U, _T = range(len(KNOT_NAMES))


def insert_pair(document: Document, direction: Direction, window: int) -> NetChange:
    """Return the document with one window along the curves of a direction split in two at its middle.

    All points stay, and two lines come in half-way, on the curves. The surface is the same where points are quadratic
    in their nodes. The new joint is smooth if the curves share u in the window.

    Raises
    ------
    QovrError : there is no such window, no room for another, or windows do not meet
    """
    check_continuous(document.formulation, "Inserting")
    check_window(document, direction, window)
    check_room(document, direction)
    return _along_rows(document, direction, lambda rows: _inserted(rows, window))


def remove_pair(document: Document, direction: Direction, joint: int) -> NetChange:
    """Return the document with the two windows at a joint made one: what ``insert_pair`` put in goes.

    The joint's line becomes the middle of the window. At the seam of a closed net, that window becomes the first.

    Raises
    ------
    QovrError : there is no such joint, or it would leave a closed net of one window
    """
    check_joint(document, direction, joint)
    if document.is_closed(direction) and knots_of(document, direction).windows == FEWEST_WHERE_CLOSED:
        raise QovrError(f"The net closes along {direction.parameter} with two windows; insert one before removing one")
    return _along_rows(document, direction, lambda rows: _removed(rows, joint))


def append_window(document: Document, direction: Direction, *, at_start: bool = False) -> NetChange:
    """Return the document with one window more, after the last or before the first along the curves of a direction.

    It is the last one, turned about the end of each curve: no old window moves, and the joint is smooth where the
    knots allow it.

    Raises
    ------
    QovrError : the net closes, has no room for another, or windows do not meet
    """
    check_continuous(document.formulation, "Appending")
    if document.is_closed(direction):
        letter = direction.parameter
        raise QovrError(f"The net closes along {letter}, so it has no end to append to; insert a window instead")
    check_room(document, direction)
    return _along_rows(document, direction, _prepended if at_start else _appended)


def _along_rows(document: Document, direction: Direction, edit: Callable[[Document], NetChange]) -> NetChange:
    if direction is Direction.ROWS:
        return edit(document)
    change = edit(transpose(document))
    return replace(change, document=transpose(change.document))


def _inserted(document: Document, b: int) -> NetChange:
    is_closed, rows = document.is_closed(Direction.ROWS), document.row_knots.array
    old = rows[:, b]
    halves = np.stack([old, old], axis=1)
    halves[:, 0, _T] = halves[:, 1, _R] = old[:, _U]
    halves[..., [_S, _U]] = 0.5
    knots = np.concatenate([rows[:, :b], halves, rows[:, b + 1 :]], axis=1)
    _scale_ends(knots, (b, b + 1), is_closed, (2.0, 0.5))
    lines, middle = Lines.of(document), STEP * b + 2
    around = lines.knots[middle - 1 : middle + 2]
    pair = Lines(_halfway(document, b), (around[:-1] + around[1:]) / 2, np.array([-1, -1]))
    lines = lines.ring().inserted(middle - 1, pair).unrolled() if is_closed else lines.inserted(middle, pair)
    joints = list(document.joints.u)
    joints.insert(b, Joint.SMOOTH if (old[:, _U] == old[0, _U]).all() else Joint.SHARP)
    after = rebuilt(document, lines, knots, joints)
    spans = _spans(b, float(old[:, _U].mean()), document)
    return NetChange(after, motion_between(document, after, Direction.ROWS, spans), read_only(lines.origin))


def _removed(document: Document, b: int) -> NetChange:
    is_closed, lines = document.is_closed(Direction.ROWS), Lines.of(document)
    if b == document.windows[1] - 1:  # the seam: counted from the last window on, it is the first joint
        b, lines = 0, lines.ring().rolled(STEP).unrolled()
        rolled, states = np.roll(document.row_knots.array, 1, axis=1), document.joints.u
        document = rebuilt(document, lines, rolled, [states[-1], *states[:-1]])
    rows = document.row_knots.array
    left, right = rows[:, b], rows[:, b + 1]
    u = _merged_u(document, b)
    merged = np.stack([left[:, _R], u, u, right[:, _T]], axis=1)
    knots = np.concatenate([rows[:, :b], merged[:, None], rows[:, b + 2 :]], axis=1)
    _scale_ends(knots, (b, b), is_closed, (left[:, _U], 1 / (1 - right[:, _U])))
    first = STEP * b + 2
    lines = lines.ring().without(first - 1, first + 1).unrolled() if is_closed else lines.without(first, first + 2)
    joints = [joint for k, joint in enumerate(document.joints.u) if k != b]
    after = rebuilt(document, lines, knots, joints)
    motion = motion_between(after, document, Direction.ROWS, _spans(b, float(u.mean()), after))
    return NetChange(after, motion, read_only(lines.origin))


def _merged_u(document: Document, b: int) -> Array:
    """Return where the joint b lies between the far sides of its two windows, (curves,): one number beside a smooth
    joint."""
    smooth, rows = document.joints.smooth(Direction.ROWS), document.row_knots.array
    left, right = rows[:, b], rows[:, b + 1]
    tau = (left[:, _T] + right[:, _R]) / 2
    before, after = right[:, _U] * tau, (1 - left[:, _U]) * (1 - tau)  # the windows' lengths are as these
    u: Array = before / (before + after)
    is_closed = document.is_closed(Direction.ROWS)
    beside = [k % len(smooth) for k in (b - 1, b + 1) if is_closed or 0 <= k < len(smooth)]
    return np.full_like(u, shared_value(u)) if smooth[beside].any() else u


def _appended(document: Document) -> NetChange:
    lines, rows = Lines.of(document), document.row_knots.array
    mirrored = [-4, -5]
    lines = lines.followed_by(
        Lines(2 * lines.points[-2] - lines.points[mirrored], lines.knots[mirrored], np.array([-1, -1]))
    )
    r, s, u, t = rows[:, -1].T
    knots = np.concatenate([rows, np.stack([t, 1 - s, 1 - u, 1 - r], axis=1)[:, None]], axis=1)
    is_smooth = can_be_smooth(KnotTable(knots), is_closed=False)[-1]
    joints = [*document.joints.u, Joint.SMOOTH if is_smooth else Joint.SHARP]
    return NetChange(rebuilt(document, lines, knots, joints), 0.0, read_only(lines.origin))


def _prepended(document: Document) -> NetChange:
    after = from_the_end(_appended(from_the_end(document)).document)
    columns = document.control_points.shape[1]
    return NetChange(after, 0.0, read_only(np.concatenate([[-1, -1], np.arange(columns)])))


def _halfway(document: Document, b: int) -> Array:
    """Return the points of the row curves half-way to the middle of a window and half-way on from there, (2, k, 3)."""
    knots = document.row_knots.array[:, b]
    points = document.control_points[:, STEP * b : STEP * b + NET_SIZE]
    coefficients = np.einsum("iab,ibd->iad", weight_coefficients(knots), points)
    u = knots[:, _U]
    bases = (bernstein.basis(CURVE_DEGREE, at) for at in (u / 2, (1 + u) / 2))
    return np.stack([np.einsum("ia,iad->id", basis, coefficients) for basis in bases])


def _scale_ends(
    knots: Array, ends: tuple[int, int], is_closed: bool, factors: tuple[Array | float, Array | float]
) -> None:
    """Scale the ratio of steps at the first and at the last joint of some windows, on both sides of each joint.

    A knot at a joint says which part the step before it is of both steps; what changes is the step inside.
    """
    first, last = ends
    windows = knots.shape[1]
    sides = [(first, _R, factors[0]), (last, _T, factors[1])]
    if first > 0 or is_closed:
        sides.append((first - 1, _T, factors[0]))
    if last < windows - 1 or is_closed:
        sides.append(((last + 1) % windows, _R, factors[1]))
    for window, name, factor in sides:
        scaled = knots[:, window, name] * factor
        knots[:, window, name] = scaled / (scaled + (1 - knots[:, window, name]))


def _spans(b: int, u: float, whole: Document) -> dict[int, tuple[float, float]]:
    """Return where the two halves of window b of a document, split at u, lie in it, and the windows beside them."""
    windows = whole.windows[1]
    at: list[tuple[float, float]] = [(k, k + 1) for k in range(windows)]
    split = [*at[:b], (b, b + u), (b + u, b + 1), *at[b + 1 :]]
    touched = range(b - 1, b + 3)
    if whole.is_closed(Direction.ROWS):
        return {k % (windows + 1): split[k % (windows + 1)] for k in touched}
    return {k: split[k] for k in touched if 0 <= k <= windows}
