"""What is typed and not set, as the document that it would make."""

from __future__ import annotations

from collections.abc import Mapping
from contextlib import suppress

import numpy as np

from qovr_app.state.typed_numbers import typed_number
from qovr_core import Document, DocumentError, edits
from qovr_core.document import NetIndex
from qovr_core.edits import CoordinatePlace, Place


def with_typed(draft: Document, texts: Mapping[Place, str]) -> Document:
    """Return a draft with every number that is typed over it.

    A text that says no number, or none that its place may hold, is no work that could be kept: it is left out.
    """
    for place, text in texts.items():
        value = typed_number(text)
        if isinstance(value, float):
            with suppress(DocumentError):
                draft = edits.set_values(draft, {place: value})
    return draft


def points_that_differ(document: Document, other: Document) -> frozenset[NetIndex]:
    """Return the control points that are elsewhere in another document of the same net."""
    if document is other or document.control_points.shape != other.control_points.shape:
        return frozenset()
    differ = (document.control_points != other.control_points).any(axis=-1)
    return frozenset((i, j) for i, j in np.argwhere(differ).tolist())


def refused_points(texts: Mapping[Place, str]) -> frozenset[NetIndex]:
    """Return the control points over a coordinate of which something is typed that is no number."""
    return frozenset(
        (place.i, place.j)
        for place, text in texts.items()
        if isinstance(place, CoordinatePlace) and not isinstance(typed_number(text), float)
    )
