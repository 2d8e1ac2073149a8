"""Joints made smooth, sharp, or a crease; knots that make all joints along curves smooth."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

import numpy as np

from qovr_core.arrays import Array
from qovr_core.document import ALIKE_WHERE_CLOSED, Document
from qovr_core.edits import knots_of, set_knots
from qovr_core.errors import DocumentError
from qovr_core.geometry.knots import KNOT_NAMES, Direction
from qovr_core.geometry.nodes import Spacing, knots_of_steps, steps_of_points
from qovr_core.geometry.windows import STEP
from qovr_core.joints import Joint
from qovr_core.structure.change import NetChange, check_continuous, check_joint, motion_between, unmoved_lines

STRONGEST_CREASE = 0.45
"""Beyond it t and r come so near to the ends of (0, 1) that the surface swings."""

_R, _S, _U, _T = range(len(KNOT_NAMES))

_DECIMALS = 15
"""Of a crease's knots: 0.5 - 0.4 is 0.09999999999999998, and fields show every digit."""


def make_smooth(document: Document, direction: Direction, joint: int) -> NetChange:
    """Return the document with one tangent plane on both sides of a joint; the windows on both sides move.

    All curves get the mean of t before it and r after it, and in each of the two windows the mean u, unless a smooth
    joint on its other side says it already; where a curve had s = u, s follows. The joint's line stays, and so do the
    far sides of both windows.

    Raises
    ------
    QovrError : there is no such joint, or windows do not meet
    """
    check_continuous(document.formulation, "A smooth joint")
    check_joint(document, direction, joint)
    knots = knots_of(document, direction).array.copy()
    windows, smooth = knots.shape[1], document.joints.smooth(direction)
    after = (joint + 1) % windows
    once = _each_once(document, direction)
    knots[:, joint, _T] = knots[:, after, _R] = shared_value(
        np.concatenate([knots[once, joint, _T], knots[once, after, _R]])
    )
    for window, other in ((joint, (joint - 1) % windows), (after, after)):
        if other != joint and other < len(smooth) and smooth[other]:
            continue
        follows = knots[:, window, _S] == knots[:, window, _U]
        knots[:, window, _U] = shared_value(knots[once, window, _U])
        knots[follows, window, _S] = knots[follows, window, _U]
    return _with_knots(document, direction, knots, {joint: Joint.SMOOTH}, (joint, after))


def make_sharp(document: Document, direction: Direction, joint: int) -> Document:
    """Return the document in which every curve has its own knots at a joint; no number changes, so nothing moves.

    Raises
    ------
    QovrError : there is no such joint
    """
    check_joint(document, direction, joint)
    return _with_joints(document, direction, {joint: Joint.SHARP})


def crease(document: Document, direction: Direction, joint: int, strength: float) -> NetChange:
    """Return the document with a joint that is sharp, with t = .5 - c before it and r = .5 + c after it on every curve.

    Parameters
    ----------
    strength : c, from 0, where evenly spaced points bend not at all, to 0.45

    Raises
    ------
    QovrError : there is no such joint, windows do not meet, or the strength is none
    """
    check_continuous(document.formulation, "A crease")
    check_joint(document, direction, joint)
    if not 0 <= strength <= STRONGEST_CREASE:
        raise DocumentError("The crease", f"{strength:g}", f"a number from 0 to {STRONGEST_CREASE}")
    knots = knots_of(document, direction).array.copy()
    after = (joint + 1) % knots.shape[1]
    t, r = (round(0.5 + part, _DECIMALS) for part in (-strength, strength))
    knots[:, joint, _T], knots[:, after, _R] = t, r
    return _with_knots(document, direction, knots, {joint: Joint.SHARP}, (joint, after))


def space_knots(document: Document, direction: Direction, spacing: Spacing) -> NetChange:
    """Return the document whose curves of a direction share the knots that the distances of its points say.

    s = u everywhere, and all joints along these curves are smooth.

    Raises
    ------
    QovrError : neighbouring points coincide on every curve, so that they say nothing; or windows do not meet
    """
    if not document.is_one_window:
        check_continuous(document.formulation, "One spacing for all windows")
    net = document.control_points if direction is Direction.ROWS else document.control_points.swapaxes(0, 1)
    steps = steps_of_points(net[_each_once(document, direction)], spacing).copy()
    if document.is_closed(direction):
        steps[-STEP:] = steps[:STEP]  # to the last bit, as the seam is a joint
    knots = np.broadcast_to(knots_of_steps(steps), knots_of(document, direction).array.shape)
    joints = dict.fromkeys(range(len(document.joints.along(direction))), Joint.SMOOTH)
    return _with_knots(document, direction, knots, joints, range(knots.shape[1]))


def shared_value(values: Array) -> float:
    """Return the mean, or to the last bit the value that all have."""
    mean = float(values.mean())
    return float(values[0]) if (values == values[0]).all() else min(max(mean, values.min()), values.max())


def _each_once(document: Document, direction: Direction) -> slice:
    """Return the curves of a direction without those that a net closed across it has twice."""
    return slice(-ALIKE_WHERE_CLOSED if document.is_closed(direction.other) else None)


def _with_knots(
    document: Document, direction: Direction, knots: Array, joints: dict[int, Joint], touched: Iterable[int]
) -> NetChange:
    """Return the document with other knots along curves and some joints in another state."""
    sharp = _with_joints(document, direction, dict.fromkeys(joints, Joint.SHARP))  # so that no smooth one is between
    after = _with_joints(set_knots(sharp, direction, knots), direction, joints)
    motion = motion_between(document, after, direction, {window: (window, window + 1) for window in touched})
    return NetChange(after, motion, unmoved_lines(document, direction))


def _with_joints(document: Document, direction: Direction, joints: dict[int, Joint]) -> Document:
    states = tuple(joints.get(k, joint) for k, joint in enumerate(document.joints.along(direction)))
    return replace(document, joints=replace(document.joints, **{direction.parameter: states}))
