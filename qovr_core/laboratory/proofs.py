"""What is proved of the paper's claims, by claim and formulation, and from which identities it follows."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

from qovr_core.formulations import FORMULATIONS, Formulation
from qovr_core.laboratory import identities, mirror_identities

_PUBLISHED, _DOUBLE_SUM, _INTERPOLATING = Formulation.PUBLISHED, Formulation.DOUBLE_SUM, Formulation.INTERPOLATING


@dataclass(frozen=True)
class Proof:
    """Why a claim is true for a formulation, under the claim's condition if it has one.

    Parameters
    ----------
    statement : what was proved, to be read after "proved:"
    identities : what it follows from; each is checked in exact arithmetic when it is asked
    parts : for a claim about the knots of single curves, the curves for which it is proved
    """

    statement: str
    identities: tuple[Callable[[], bool], ...]
    parts: frozenset[str] = frozenset()

    def holds(self) -> bool:
        """Return whether every identity holds."""
        return all(identity() for identity in self.identities)


Proofs = Mapping[Formulation, Proof]

_EXACT = (_DOUBLE_SUM, _INTERPOLATING)
"""Formulations whose kernels are not cut."""

INVERSE: Proofs = dict.fromkeys(
    _EXACT, Proof("every entry of k (1 - k) (M M^-1 - I) is the polynomial 0", (identities.kernels_invert,))
)

_SUM = "b_0 + ... + b_4 - 1 is the polynomial 0 of u"

UNITY: Proofs = {
    _PUBLISHED: Proof(f"{_SUM}, whatever else is in the kernels", (identities.unit_rows_sum_to_one,)),
    **dict.fromkeys(_EXACT, Proof(f"{_SUM} and the knots", (identities.weights_sum_to_one,))),
}

QUARTIC: Proofs = dict.fromkeys(
    FORMULATIONS.values(),
    Proof("the coefficients of u^5 and u^6 are 0, whatever the kernels", (identities.quartic_where_s_is_u,)),
)

_EDGES_ARE_CURVES = (identities.curves_end_on_points, identities.boolean_sum_ends_on_curves)
"""S(0, v) = K_1(v), S(1, v) = K_3(v), S(u, 0) = C_1(u), S(u, 1) = C_3(u) of the Boolean sum."""

_OTHERS = frozenset(f"{letter}_{number}" for letter in "CK" for number in (0, 2, 4))

C0: Proofs = {
    _INTERPOLATING: Proof("both sides are the same curve, K_3 of the one and K_1 of the other", _EDGES_ARE_CURVES)
}

EDGES: Proofs = {_INTERPOLATING: Proof("the edges are K_1, K_3, C_1, C_3 and nothing else", _EDGES_ARE_CURVES, _OTHERS)}

EDGES_TRANSFORMED: Proofs = {
    _INTERPOLATING: Proof(
        "the raw edges are K_1, K_3, C_1, C_3, and T is made of the boxes alone", _EDGES_ARE_CURVES, _OTHERS
    )
}

_TANGENTS = (
    identities.tangents_are_known,
    identities.tangents_meet,
    identities.equal_curves_make_products,
)
"""Along a joint whose rows, or columns, are alike in what their tangents depend on, the cross derivative is a sum of
tangents of curves, which differ from their continuation by lambda alone."""

C1: Proofs = {
    _INTERPOLATING: Proof(
        "the cross derivative has the same weights on both sides", (*_TANGENTS, identities.tangents_agree)
    )
}

G1: Proofs = {
    _INTERPOLATING: Proof(
        "the cross derivatives on both sides differ by one factor lambda, the same along the whole joint",
        (*_EDGES_ARE_CURVES, *_TANGENTS),
    )
}

_JUMPS = "S_uu at 1 has the weight 2 (1 - r)^2 (1 - u) / (u^2 r) > 0 of a point that the neighbour has not, so that, \
whatever the knots, almost every net jumps"

C2: Proofs = {
    _INTERPOLATING: Proof(_JUMPS, (*_EDGES_ARE_CURVES, identities.curvature_begins_before)),
    _DOUBLE_SUM: Proof(_JUMPS, (identities.curves_end_on_points, identities.curvature_begins_before)),
}
"""Of the double sum P_10 squared has that weight at v = 0, where K_0 is P_10."""

_MIRRORED = "the weights of 0.5 knots, read backwards, are themselves at 1 - u"

SYMMETRY: Proofs = {
    _INTERPOLATING: Proof(
        _MIRRORED,
        (
            mirror_identities.half_weights_mirror,
            identities.weights_sum_to_one,
            identities.equal_curves_make_products,
        ),
    ),
    _DOUBLE_SUM: Proof(f"{_MIRRORED}, and so are both sums of curves", (mirror_identities.sums_mirror,)),
    _PUBLISHED: Proof(f"{_MIRRORED}, and so are C_4 and the sum of the columns", (mirror_identities.last_row_mirrors,)),
}
"""The kernels of 0.5 have no more than four decimals."""

BOXES: Proofs = dict.fromkeys(
    FORMULATIONS.values(),
    Proof("wherever T is defined, its ends are those of the control box", (identities.boxes_are_mapped,)),
)
