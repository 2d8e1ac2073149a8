"""The paper's claims about neighbouring patches: Lemma 1, Lemma 2, Theorem 1."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from qovr_core.arrays import Array
from qovr_core.document import Document
from qovr_core.edits import set_all_knots, set_points
from qovr_core.geometry.knots import Knots, KnotTable
from qovr_core.laboratory.measurement import Condition, Measurement
from qovr_core.laboratory.neighbours import Continuation, joints

_POSITION, _TANGENT, _CURVATURE = 0, 1, 2

SAME_CROSSING = 1e-12
"""Knots that meet 1 - r_ip = u_ip to this are meant to: 1 - 0.3 is not 0.7 to the last bit."""

_EVEN_MIDDLES = (0.4, 0.6)
"""u_ip of the first and the last of curves that cross a joint alike and are different from each other."""


def c0(document: Document) -> Measurement:
    """Neighbours meet, Lemma 1, (45)."""
    return _worst_jump(document, _POSITION, "largest gap between neighbours as part of the surface's size")


def c1(document: Document) -> Measurement:
    """The cross derivatives of neighbours are the same, Lemma 2, (50)."""
    return _worst_jump(document, _TANGENT, "largest jump of the cross derivative as part of the surface's size")


def _worst_jump(document: Document, order: int, what: str) -> Measurement:
    """Measure a jump across both joints, the larger net drawn."""
    of_joints = [(joint.jumps()[order], joint) for joint in joints(document, Continuation.DRAWN)]
    worst, where = max(of_joints, key=lambda entry: entry[0].part)
    note = "" if worst.is_rounding else f"largest across {where.across} = 1"
    return Measurement(worst.part, what, all(jump.is_rounding for jump, _ in of_joints), note)


def _crosses_alike(document: Document) -> bool:
    """Whether every knot vector meets its neighbour's, and the knots of one direction do not differ."""
    families = document.row_knots, document.column_knots
    alike = all(_is_even(family[curve, 0]) for family in families for curve in range(len(family)))
    return alike and any(bool((family.array == family.array[0]).all()) for family in families)


def _is_even(knots: Knots) -> bool:
    """Whether t_ip = r_ip and t_ip / (1 - u_ip) = (1 - r_ip) / u_ip, the neighbour's knots being the same."""
    left, right = knots.t / (1 - knots.u), (1 - knots.r) / knots.u
    return abs(knots.t - knots.r) <= SAME_CROSSING and abs(left - right) <= SAME_CROSSING


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


def c2(document: Document) -> Measurement:
    """The second cross derivatives of neighbours are not the same, Theorem 1, (60)."""
    what = "largest jump of the second cross derivative as part of the surface's size"
    measured = _worst_jump(document, _CURVATURE, what)
    jumps = [jump for joint in joints(document, Continuation.DRAWN) for jump in joint.jumps()]
    smooth = _smooth_net(document)
    note = "none of the nets tried continues without a jump"
    if smooth is document:
        note = "yet this net, continued by reflection, has none"
    elif smooth is not None:
        note = "yet nets exist that have none: points affine in (i, j), 0.5 knots, continued by reflection"
    return Measurement(measured.value, what, not all(jump.is_rounding for jump in jumps), note, example=smooth)


def _smooth_net(document: Document) -> Document | None:
    """Return a document that reflection continues without any jump up to the second derivative, if one is found.

    Tried are the document itself and the net affine in (i, j) that is nearest to its own, with 0.5 knots.
    """
    affine = set_all_knots(set_points(document, _affine_net(document.control_points)), Knots())
    return next((tried for tried in (document, affine) if _is_smooth(tried)), None)


def _is_smooth(document: Document) -> bool:
    return all(jump.is_rounding for joint in joints(document, Continuation.REFLECTED) for jump in joint.jumps())


def _affine_net(net: Array) -> Array:
    """Return the net a + b i + c j nearest to a net."""
    i, j = np.indices(net.shape[:2])
    basis = np.stack([np.ones(i.size), i.ravel(), j.ravel()], axis=1)
    fitted, *_ = np.linalg.lstsq(basis, net.reshape(-1, 3), rcond=None)
    affine: Array = (basis @ fitted).reshape(net.shape)
    return affine
