"""Which knots change together with one that is set by hand."""

from __future__ import annotations

from dataclasses import dataclass

from qovr_core import Document, edits
from qovr_core.geometry.knots import Direction, KnotPlace

Window = tuple[int, int]
"""A window (a, b) of the net: b counts along the row curves, a along the column curves."""


@dataclass(frozen=True)
class Links:
    """What shares a knot that is set by hand: all curves of its direction, rows and columns."""

    curves: bool = True
    directions: bool = False

    def places(self, document: Document, place: KnotPlace) -> tuple[KnotPlace, ...]:
        """Return the knots that change with one of a document, itself among them."""
        return edits.linked_places(document, place, curves=self.curves, directions=self.directions)


def window_along(window: Window, direction: Direction) -> int:
    """Return a window's number along the curves of a direction."""
    return window[1] if direction is Direction.ROWS else window[0]
