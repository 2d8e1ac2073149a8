"""The paper's claims: one record each, beside the function that measures it."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import ClassVar

from qovr_core.document import Document
from qovr_core.laboratory import curve_claims, fairness, joint_claims, knot_claims, proofs, shape_claims
from qovr_core.laboratory.measurement import Condition, Measurement
from qovr_core.laboratory.proofs import Proofs
from qovr_core.registry import Record, Registry


def _no_examples(_document: Document) -> tuple[Document, ...]:
    """Try no documents but the usual ones; it has a name, so that a claim can go to another process."""
    return ()


@dataclass(frozen=True, eq=False, repr=False)
class Claim(Record):
    """One claim of the paper and the function that decides it.

    Parameters
    ----------
    name : its short name
    text : what the paper says
    where : the equation, lemma or section
    measure : what it comes to on a document, under that document's formulation
    condition : under what it may be true
    parts_condition : for a claim about the knots of single curves, the condition with ``{parts}`` for the curves
    examples : documents made from one that are tried too, such as meet the condition and such as do not
    is_general : whether it speaks of all surfaces; if not, it is decided by the document alone
    proofs : by formulation, why it is true, under its condition if it has one
    is_of_joints : whether it is measured at all joints of a net, and not on one window of it
    """

    name: str
    text: str
    where: str
    measure: Callable[[Document], Measurement]
    condition: Condition | None = None
    parts_condition: str = ""
    examples: Callable[[Document], Sequence[Document]] = _no_examples
    is_general: bool = True
    proofs: Proofs = field(default_factory=dict)
    is_of_joints: bool = False

    table: ClassVar[Registry[Claim]]

    @property
    def file_name(self) -> str:
        """Its name where no apostrophe may stand."""
        return self.name.replace("'", "-transformed")


CLAIMS = Claim.table = Registry[Claim]("claim")
"""Every claim, in the paper's order."""

for _claim in (
    Claim(
        "inverse",
        "M times M^-1 is the identity",
        "(14)-(17), (21), (22)",
        curve_claims.inverse,
        proofs=proofs.INVERSE,
    ),
    Claim(
        "unity",
        "the weights of a curve sum to 1",
        "(4)",
        curve_claims.unity,
        condition=curve_claims.KERNELS_HOLD,
        examples=curve_claims.kernel_examples,
        proofs=proofs.UNITY,
    ),
    Claim(
        "quartic",
        "curves and surface are of degree four",
        "title, abstract",
        curve_claims.quartic,
        condition=curve_claims.S_IS_U,
        examples=curve_claims.degree_examples,
        proofs=proofs.QUARTIC,
    ),
    Claim("ends", "the weights are [0 0 1 0 0] at both ends of a curve", "(46), (48)", curve_claims.ends),
    Claim(
        "tangents",
        "the first derivatives of the weights are [0 -0.5 0 0.5 0] at both ends",
        "(51), (53)",
        curve_claims.tangents,
    ),
    Claim(
        "curvatures",
        "the second derivatives of the weights are [0 0 2 -4 2] at 0 and [2 -4 2 0 0] at 1",
        "(55), (57)",
        curve_claims.curvatures,
    ),
    Claim(
        "C0",
        "neighbouring patches meet without a gap",
        "Lemma 1, (45)",
        joint_claims.c0,
        proofs=proofs.C0,
        is_of_joints=True,
    ),
    Claim(
        "C1",
        "the tangents of neighbouring patches agree across the joint",
        "Lemma 2, (50)",
        joint_claims.c1,
        condition=joint_claims.KNOTS_CROSS_ALIKE,
        examples=joint_claims.crossing_examples,
        proofs=proofs.C1,
        is_of_joints=True,
    ),
    Claim(
        "G1",
        "the tangent planes of neighbouring patches agree across the joint",
        "Lemma 2, (52)-(54)",
        joint_claims.g1,
        condition=joint_claims.JOINTS_ARE_SMOOTH,
        examples=joint_claims.smooth_examples,
        proofs=proofs.G1,
        is_of_joints=True,
    ),
    Claim(
        "C2",
        "the second derivatives of neighbouring patches do not agree across the joint",
        "Theorem 1, (60)",
        joint_claims.c2,
        proofs=proofs.C2,
        is_of_joints=True,
    ),
    Claim(
        "edges",
        "internal knots do not move the boundary",
        "abstract, 5.2",
        knot_claims.edges,
        parts_condition=knot_claims.EDGES_KEPT_BY,
        proofs=proofs.EDGES,
    ),
    Claim(
        "edges'",
        "internal knots do not move the boundary of the transformed surface",
        "abstract, 5.2, 5.3",
        knot_claims.edges_transformed,
        parts_condition=knot_claims.EDGES_KEPT_AFTER_T,
        examples=knot_claims.box_examples,
        proofs=proofs.EDGES_TRANSFORMED,
    ),
    Claim(
        "local",
        "the effect of a moved point decreases exponentially with the distance",
        "abstract, 5.3",
        shape_claims.local,
    ),
    Claim(
        "symmetry",
        "0.5 knots and a symmetric net give a symmetric surface",
        "5.3",
        shape_claims.symmetry,
        condition=shape_claims.ROW_4_SYMMETRIC,
        examples=shape_claims.symmetry_examples,
        proofs=proofs.SYMMETRY,
    ),
    Claim(
        "boxes",
        "T maps the box of the raw surface onto that of the control points",
        "(61)-(65), 5.1",
        shape_claims.boxes,
        condition=shape_claims.RAW_HAS_EXTENT,
        proofs=proofs.BOXES,
    ),
    Claim("fairness", "there are no wave-like artifacts", "abstract, 5.3", fairness.fairness, is_general=False),
):
    CLAIMS.register(_claim)
CLAIMS.seal()
