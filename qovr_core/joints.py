"""The joints of a net: the lines at which two windows meet, and what makes the surface smooth across them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from enum import StrEnum

import numpy as np

from qovr_core.arrays import Array, Flags, read_only
from qovr_core.checks import checked_choice, entries
from qovr_core.errors import DocumentError
from qovr_core.geometry.knots import KNOT_NAMES, Direction, KnotTable

_R, _U, _T = (KNOT_NAMES.index(name) for name in "rut")

_MOST_APART = 1e6
"""Windows of smooth joints whose lengths would differ by more than this part begin again at 1: beside longer ones their
parameters would have no digits left."""


class Joint(StrEnum):
    """What a joint promises: one tangent plane from both sides, or nothing but one curve."""

    SMOOTH = "smooth"
    SHARP = "sharp"


@dataclass(frozen=True)
class Joints:
    """The joints between the windows of a net.

    Parameters
    ----------
    u : those that the row curves cross, one fewer than windows; where the net is closed along u, the seam comes last
    v : those that the column curves cross, likewise
    """

    u: tuple[Joint, ...] = ()
    v: tuple[Joint, ...] = ()

    def along(self, direction: Direction) -> tuple[Joint, ...]:
        """Return those that the curves of a direction cross."""
        return self.u if direction is Direction.ROWS else self.v

    def smooth(self, direction: Direction) -> Flags:
        """Return which of them are smooth, (joints,)."""
        return read_only(np.array([joint is Joint.SMOOTH for joint in self.along(direction)], dtype=np.bool_))


def joint_count(windows: int, is_closed: bool) -> int:
    """Return how many joints a curve through so many windows crosses."""
    return windows if is_closed else windows - 1


def can_be_smooth(knots: KnotTable, is_closed: bool) -> Flags:
    """Return at which joints, (joints,), the knots make the surface smooth, whatever the points are.

    All curves share one tau, which is t before the joint and r after it, and they share u in either window: to the
    last bit, so that a file can be checked.
    """
    if not (count := joint_count(knots.windows, is_closed)):
        return _NO_JOINTS
    array = knots.array
    after = np.roll(array, -1, axis=1)
    tau = array[:1, :, _T]
    shares_tau = ((array[..., _T] == tau) & (after[..., _R] == tau)).all(axis=0)
    shares_u = (array[..., _U] == array[:1, :, _U]).all(axis=0)
    smooth: Flags = shares_tau & shares_u & np.roll(shares_u, -1)
    return read_only(smooth[:count])


_NO_JOINTS = read_only(np.zeros(0, dtype=np.bool_))


def smooth_where_possible(rows: KnotTable, columns: KnotTable, closed: Sequence[str]) -> Joints:
    """Return the joints of curves: smooth where the knots allow it, else sharp."""
    families = {Direction.ROWS: rows, Direction.COLUMNS: columns}
    u, v = (
        tuple(Joint.SMOOTH if is_it else Joint.SHARP for is_it in can_be_smooth(knots, direction.parameter in closed))
        for direction, knots in families.items()
    )
    return Joints(u, v)


def window_lengths(knots: KnotTable, joints: Sequence[Joint]) -> Array:
    r"""Return the lengths of the windows along a family of curves, (windows,): in the parameter that they give, smooth
    joints are C1.

    Across a smooth joint $h_b / h_{b+1} = \lambda = u_{b+1} \tau / ((1 - u_b)(1 - \tau))$; across a sharp one
    neighbours are alike.

    Examples
    --------
    >>> table = KnotTable(np.full((5, 2, 4), [0.5, 0.4, 0.4, 0.5]))
    >>> window_lengths(table, [Joint.SMOOTH]).round(3)
    array([1. , 1.5])
    """
    lengths = np.ones(knots.windows)
    u, tau = knots.array[0, :, _U], knots.array[0, :, _T]
    for b, joint in enumerate(joints[: knots.windows - 1]):
        before = lengths[b]
        if joint is Joint.SMOOTH:
            before = before * (1 - u[b]) * (1 - tau[b]) / (u[b + 1] * tau[b])
        is_ordinary = 1 / _MOST_APART <= before <= _MOST_APART
        lengths[b + 1] = before if is_ordinary else 1
    return read_only(lengths)


def checked_closed(closed: object) -> tuple[str, ...]:
    """Return the directions in which a net is closed, of ``u`` and ``v``, in this order, or raise DocumentError."""
    letters = [direction.parameter for direction in Direction]
    given = entries(closed, "closed", expected="a list of u, v or both")
    chosen = [checked_choice(entry, f"closed[{k}]", letters) for k, entry in enumerate(given)]
    if len(set(chosen)) < len(chosen):
        raise DocumentError("closed", "a list with an entry twice", "u, v or both, each once")
    return tuple(letter for letter in letters if letter in chosen)


def checked_joints(joints: Joints, rows: KnotTable, columns: KnotTable, closed: Sequence[str]) -> Joints:
    """Return the joints, or raise DocumentError where their number is wrong or a smooth one is not."""
    checked = []
    for direction, knots in ((Direction.ROWS, rows), (Direction.COLUMNS, columns)):
        place = f"joints.{direction.parameter}"
        states = [
            entry if isinstance(entry, Joint) else Joint(checked_choice(entry, f"{place}[{k}]", list(Joint)))
            for k, entry in enumerate(joints.along(direction))
        ]
        can_be = can_be_smooth(knots, direction.parameter in closed)
        for k, (joint, can) in enumerate(zip(entries(states, place, len(can_be)), can_be, strict=True)):
            if joint is Joint.SMOOTH and not can:
                raise DocumentError(f"{place}[{k}]", str(joint), f"sharp, or {_what_makes_smooth(knots, k, direction)}")
        checked.append(tuple(states))
    return Joints(*checked)


def _what_makes_smooth(knots: KnotTable, joint: int, direction: Direction) -> str:
    """Return which knots a smooth joint wants alike."""
    after = (joint + 1) % knots.windows
    family = "rows" if direction is Direction.ROWS else "columns"
    return (
        f"one value on all {family} for t in window {joint} and r in window {after}, "
        f"and one for {direction.parameter} in each of them"
    )
