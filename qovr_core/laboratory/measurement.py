"""What a claim comes to on one document, and conditions that a document may meet."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field

from qovr_core.document import Document
from qovr_core.laboratory.jumps import JointPlace


@dataclass(frozen=True, eq=False)
class Measurement:
    """What one claim comes to on one document.

    Parameters
    ----------
    value : the measured number
    what : what that number is
    holds : whether the claim holds on this document
    note : what else was found, as the weight rows that take the place of the paper's
    parts : for a claim about the knots of single curves, each curve with an effect and whether it keeps the claim
    example : a document that shows what the note says
    place : on a net of several windows, where the joint is whose difference is largest
    """

    value: float
    what: str
    holds: bool
    note: str = ""
    parts: Mapping[str, bool] = field(default_factory=dict)
    example: Document | None = None
    place: JointPlace | None = None


@dataclass(frozen=True)
class Condition:
    """A condition under which a claim is true.

    Parameters
    ----------
    text : the condition, to be read after "true if"
    is_met : whether a document meets it
    """

    text: str
    is_met: Callable[[Document], bool]
