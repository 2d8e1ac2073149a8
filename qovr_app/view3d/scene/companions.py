"""What a scene is looked at with, besides the surface itself."""

from __future__ import annotations

from dataclasses import dataclass

from qovr_core import ParametricSurface
from qovr_core.geometry.knots import KnotPlace


@dataclass(frozen=True, eq=False)
class Companions:
    """What a scene is looked at with, and is no part of it.

    Parameters
    ----------
    reference : a surface in the document's units, from which distances are taken; it stays what it was
    reference_name : what to call it
    knot : the knot to which the sensitivity is shown
    """

    reference: ParametricSurface | None = None
    reference_name: str = ""
    knot: KnotPlace | None = None
