"""What is typed and not set, as the document that it would make."""

from __future__ import annotations

from collections.abc import Mapping
from contextlib import suppress

import numpy as np

from qovr_app.state.typed_numbers import typed_value
from qovr_core import Document, DocumentError, edits
from qovr_core.checks import checked_number
from qovr_core.document import NetIndex
from qovr_core.edits import CoordinatePlace, Place, value_at


def with_typed(draft: Document, texts: Mapping[Place, str]) -> Document:
    """Return a draft with every number that is typed over it.

    A text that says no number, or none that its place may hold, is no work that could be kept: it is left out.
    """
    for place, text in texts.items():
        with suppress(DocumentError):
            value = typed_value(text, str(place), checked_number, value_at(draft, place))
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
        if isinstance(place, CoordinatePlace) and not _is_coordinate(text)
    )


def _is_coordinate(text: str) -> bool:
    """Return whether a text says a coordinate, as a number or as what is worked out from the one that stands there."""
    try:
        typed_value(text, "", checked_number, 1.0)
    except DocumentError:
        return False
    return True
