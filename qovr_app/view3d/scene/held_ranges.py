"""The ranges of the colours, held while a document is edited: a colour means the same before and after."""

from __future__ import annotations

from collections.abc import Hashable
from dataclasses import dataclass

from qovr_core import Evaluation
from qovr_core.fields import Range


@dataclass(frozen=True, eq=False)
class _Held:
    """A range, the surface that it was taken from, and whether that moved."""

    limits: Range
    evaluation: Evaluation
    moving: bool


class HeldRanges:
    """The range of every quantity that was shown since the limits were last taken anew."""

    def __init__(self) -> None:
        self._held: dict[Hashable, _Held] = {}

    def range_of(self, key: Hashable, own: Range, evaluation: Evaluation, *, moving: bool) -> Range:
        """Return the range that is held for a key, or hold this surface's own from now on.

        A range without extent is not held: it has no colours to tell apart. What was taken from the coarse grid of a
        moving picture gives way to the same surface at rest.

        Parameters
        ----------
        own : the range of what is shown now
        """
        found = self._held.get(key)
        if found is not None and not (found.moving and not moving and found.evaluation is evaluation):
            return found.limits
        if own[1] > own[0]:
            self._held[key] = _Held(own, evaluation, moving)
        return own
