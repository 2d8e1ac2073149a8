"""The paper's claims about neighbouring patches: Lemma 1, Lemma 2, Theorem 1."""

from __future__ import annotations

from dataclasses import replace
from functools import lru_cache

import numpy as np

from qovr_core.arrays import Array
from qovr_core.document import Document
from qovr_core.edits import extract_window, knots_of, set_all_knots, set_points
from qovr_core.geometry.knots import KNOT_NAMES, Direction, Knots, KnotTable
from qovr_core.joints import can_be_smooth
from qovr_core.laboratory.jumps import Jump, Jumps, jumps
from qovr_core.laboratory.measurement import Condition, Measurement
from qovr_core.laboratory.neighbours import Continuation, continued_sides, document_sides

_POSITION, _TANGENT, _CURVATURE = 0, 1, 2

SAME_CROSSING = 1e-12
"""Knots that meet 1 - r_ip = u_ip to this are meant to: 1 - 0.3 is not 0.7 to the last bit."""

_EVEN_MIDDLES = (0.4, 0.6)
"""u_ip of the first and the last of curves that cross a joint alike and are different from each other."""

_SMOOTH = Knots(r=0.4, s=0.5, u=0.55, t=0.4)
"""Knots whose joints are smooth and for which lambda is not 1."""

_R, _S, _U, _T = (KNOT_NAMES.index(name) for name in "rsut")

_REMEMBERED = 16
"""The claims about joints ask for the same: what jumps in one document and its examples, under three formulations."""


@lru_cache(maxsize=_REMEMBERED)
def joint_jumps(document: Document) -> Jumps:
    """Return what jumps at the joints of a net, or at those of one window with neighbours whose points are drawn.

    Raises
    ------
    EvaluationError : there is no finite surface
    """
    return jumps(document_sides(document))


def c0(document: Document) -> Measurement:
    """Neighbours meet, Lemma 1, (45)."""
    gap = joint_jumps(document).by_order[_POSITION]
    return _measured(document, gap, "largest gap between neighbours as part of the surface's size")


def c1(document: Document) -> Measurement:
    """The cross derivatives of neighbours are the same, Lemma 2, (50)."""
    found = joint_jumps(document)
    what = "largest jump of the cross derivative as part of the surface's size"
    measured = _measured(document, found.by_order[_TANGENT], what)
    if document.is_one_window:
        return measured
    in_net = "no jump" if found.in_net.is_rounding else f"{found.in_net.value:.2g}"
    note = f"in the net's own parameter {in_net}"
    return replace(measured, note="; ".join(filter(None, (measured.note, note))))


def g1(document: Document) -> Measurement:
    """The tangent planes of neighbours are the same, Lemma 2, (52)-(54)."""
    found = joint_jumps(document)
    what = "largest angle between the tangent planes of neighbours in degrees"
    measured = _measured(document, found.planes, what)
    return replace(measured, holds=measured.holds and found.by_order[_POSITION].is_rounding)


def _measured(document: Document, jump: Jump, what: str) -> Measurement:
    """Return what a jump comes to, and where it is largest."""
    note = "" if jump.is_rounding else f"largest {_place(document, jump)}"
    place = None if document.is_one_window else jump.place
    return Measurement(jump.value, what, jump.is_rounding, note, place=place)


def _place(document: Document, jump: Jump) -> str:
    return f"across {jump.place.across.parameter} = 1" if document.is_one_window else f"at the {jump.place}"


def _crosses_alike(document: Document) -> bool:
    """Whether every knot vector meets its neighbour's, and the knots of one direction do not differ."""
    families = [family.array for family in (document.row_knots, document.column_knots)]
    alike = all(_are_even(knots) and _do_not_differ(knots[..., [_R, _U, _T]], axis=1) for knots in families)
    return alike and any(_do_not_differ(knots, axis=0) for knots in families)


def _do_not_differ(knots: Array, axis: int) -> bool:
    return bool((knots == knots.take([0], axis=axis)).all())


def _are_even(knots: Array) -> bool:
    """Whether t_ip = r_ip and t_ip / (1 - u_ip) = (1 - r_ip) / u_ip in every window of every curve."""
    r, u, t = (knots[..., k] for k in (_R, _U, _T))
    apart = np.maximum(np.abs(t - r), np.abs(t / (1 - u) - (1 - r) / u))
    return bool((apart <= SAME_CROSSING).all())


def crossing_examples(document: Document) -> tuple[Document, ...]:
    """Return the document with knots that meet the condition of C1, thrice, and with knots that miss either half."""
    rows, columns = _even(len(document.row_knots)), _even(len(document.column_knots))
    return (
        set_all_knots(document, Knots()),
        replace(document, row_knots=_all_as(rows, 1), column_knots=columns),
        replace(document, row_knots=rows, column_knots=_all_as(columns, 1)),
        replace(document, row_knots=rows, column_knots=columns),
        set_all_knots(document, Knots(r=0.4, t=0.4)),
    )


def _even(count: int) -> KnotTable:
    """Return knots of so many curves that cross a joint alike, different from curve to curve."""
    u = np.linspace(*_EVEN_MIDDLES, count)
    return KnotTable(np.stack([1 - u, u, u, 1 - u], axis=-1)[:, None])


def _all_as(knots: KnotTable, curve: int) -> KnotTable:
    """Return knots that are for all curves those of one."""
    return KnotTable(np.broadcast_to(knots.array[curve], knots.array.shape))


KNOTS_CROSS_ALIKE = Condition(
    "on every curve t_ip = r_ip and t_ip / (1 - u_ip) = (1 - r_ip) / u_ip, left of the joint as right of it, and the "
    "knots do not differ between the rows or not between the columns; 0.5 everywhere meets it",
    _crosses_alike,
)


def _all_smooth(document: Document) -> bool:
    """Whether every joint can be smooth; the neighbours of one window have its knots, as if it were closed."""
    return all(
        can_be_smooth(knots_of(document, direction), document.is_one_window or document.is_closed(direction)).all()
        for direction in Direction
    )


def smooth_examples(document: Document) -> tuple[Document, ...]:
    """Return the document with 0.5 knots, and with smooth joints between windows of different shape and free s."""
    smooth = set_all_knots(document, _SMOOTH)
    rows = smooth.row_knots.array.copy()
    rows[..., _S] = np.linspace(*_EVEN_MIDDLES, len(rows))[:, None]
    return set_all_knots(document, Knots()), replace(smooth, row_knots=KnotTable(rows))


JOINTS_ARE_SMOOTH = Condition(
    "at every joint t_ip before it and r_ip after it are one number on all curves that cross it, and so is u_ip (v_ip) "
    "on either side; 0.5 everywhere meets it",
    _all_smooth,
)


def c2(document: Document) -> Measurement:
    """The second cross derivatives of neighbours are not the same, Theorem 1, (60)."""
    found = joint_jumps(document)
    jump = found.by_order[_CURVATURE]
    what = "largest jump of the second cross derivative as part of the surface's size"
    smooth = _smooth_net(document)
    note = "none of the nets tried continues without a jump"
    if smooth is document:
        note = "yet this net, continued by reflection, has none" if document.is_one_window else "yet this net has none"
    elif smooth is not None:
        note = "yet nets exist that have none: points affine in (i, j), 0.5 knots, continued by reflection"
    measured = replace(_measured(document, jump, what), holds=not found.are_rounding, example=smooth)
    where = measured.note if measured.place is not None else ""
    return replace(measured, note="; ".join(filter(None, (where, note))))


def _smooth_net(document: Document) -> Document | None:
    """Return a document without any jump up to the second derivative, if one is found.

    Tried are the document itself and the net affine in (i, j) that is nearest to its first window's, with 0.5 knots.
    One window is continued by reflection.
    """
    first = extract_window(document, (0, 0))
    affine = set_all_knots(set_points(first, _affine_net(first.control_points)), Knots())
    return next((tried for tried in (document, affine) if _has_no_jump(tried)), None)


def _has_no_jump(document: Document) -> bool:
    if not document.is_one_window:
        return joint_jumps(document).are_rounding
    return jumps(continued_sides(document, Continuation.REFLECTED)).are_rounding


def _affine_net(net: Array) -> Array:
    """Return the net a + b i + c j nearest to a net."""
    i, j = np.indices(net.shape[:2])
    basis = np.stack([np.ones(i.size), i.ravel(), j.ravel()], axis=1)
    fitted, *_ = np.linalg.lstsq(basis, net.reshape(-1, 3), rcond=None)
    affine: Array = (basis @ fitted).reshape(net.shape)
    return affine
