"""Where points stand and how far they have come, in one line."""

from __future__ import annotations

from qovr_app.state.names import AXES, points_text
from qovr_core import Document
from qovr_core.document import NetIndex
from qovr_core.number_texts import USUAL_DIGITS, rounded_text


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
