"""Which knots change together with one that is set by hand."""

from __future__ import annotations

from dataclasses import dataclass

from qovr_core import Document, edits
from qovr_core.geometry.knots import KnotPlace


@dataclass(frozen=True)
class Links:
    """What shares a knot that is set by hand: all curves of its direction, rows and columns, all windows."""

    curves: bool = True
    directions: bool = False
    windows: bool = False

    def places(self, document: Document, place: KnotPlace) -> tuple[KnotPlace, ...]:
        """Return the knots that change with one of a document, itself among them."""
        return edits.linked_places(
            document, place, curves=self.curves, directions=self.directions, windows=self.windows
        )
