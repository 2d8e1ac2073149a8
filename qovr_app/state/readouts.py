"""Where points stand and how far they have come, in one line."""

from __future__ import annotations

from qovr_app.state.names import AXES, points_text
from qovr_core import Document
from qovr_core.document import NetIndex
from qovr_core.number_texts import USUAL_DIGITS, percent_text, rounded_text, significant_text

_MOTION_DIGITS = 3

_STILL = 1e-12
"""A motion below this part of the net's size is rounding."""


def motion_text(motion: float | None, document: Document) -> str:
    """Return by how much the surface of a document moves at most; None where its windows have no one surface.

    Examples
    --------
    >>> document = Document([[[3 * j, 4 * i, 0] for j in range(5)] for i in range(5)])
    >>> motion_text(0.1, document)
    "The surface moves by at most 0.1, 0.5 % of the net's size."
    >>> motion_text(0.0, document)
    'No point of the surface moves.'
    """
    if motion is None:
        return "The windows do not meet, so that they have no one surface that could be compared."
    if motion <= _STILL * document.net_size:
        return "No point of the surface moves."
    size = percent_text(motion / document.net_size)
    return f"The surface moves by at most {significant_text(motion, _MOTION_DIGITS)}, {size} of the net's size."


def moved_text(indices: tuple[NetIndex, ...], before: Document, after: Document) -> str:
    """Return where the one point, or the mean of several, stands: "P 2,2: x 2, y 2, z 0.567 (+0.067)"."""
    rows, columns = zip(*indices, strict=True)
    old, new = (document.control_points[list(rows), list(columns)].mean(axis=0) for document in (before, after))
    name = points_text(indices) if len(indices) == 1 else f"Mean of {points_text(indices)}"
    axes = (_axis_text(letter, a, b) for letter, a, b in zip(AXES, old.tolist(), new.tolist(), strict=True))
    return f"{name}: {', '.join(axes)}"


def _axis_text(letter: str, before: float, after: float) -> str:
    place = f"{letter} {rounded_text(after, USUAL_DIGITS)}"
    difference = rounded_text(after - before, USUAL_DIGITS)
    if difference == "0":
        return place
    return f"{place} ({'+' * (after > before)}{difference})"
