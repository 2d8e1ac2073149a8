"""A document as the named arrays of ``.npz`` and ``.mat``, checked entry by entry."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from qovr_core.arrays import Array
from qovr_core.checks import Verbatim, checked_knot, checked_number, described
from qovr_core.document import Document
from qovr_core.errors import LONGEST_QUOTE, DocumentError, FileError, one_line
from qovr_core.geometry.knots import KNOT_NAMES, Knots
from qovr_core.geometry.windows import NET_SIZE

SHAPES = {
    "control_points": (NET_SIZE, NET_SIZE, 3),
    "row_knots": (NET_SIZE, len(KNOT_NAMES)),
    "column_knots": (NET_SIZE, len(KNOT_NAMES)),
}
INPUTS = (*SHAPES, "formulation", "u", "v")
"""The arrays that make a document; the samples are the lengths of ``u`` and ``v``."""

LARGEST_INPUT = 100_000
"""Bytes; the longest input, 4096 parameters, takes 33 kB."""


def document_from_arrays(arrays: Mapping[str, Any], path: Path) -> Document:
    """Return the document that named arrays hold.

    Raises
    ------
    FileError : an array is missing, of another shape or kind, or holds a value that a document cannot hold
    """
    try:
        for name in INPUTS:
            if name not in arrays:
                raise DocumentError(name, "missing", "the arrays " + ", ".join(INPUTS))
        net, row_knots, column_knots = (_numbers(arrays[name], name) for name in SHAPES)
        return Document(
            control_points=net,
            row_knots=_curves(row_knots),
            column_knots=_curves(column_knots),
            formulation=_text(arrays["formulation"]),
            samples=(np.size(arrays["u"]), np.size(arrays["v"])),
        )
    except DocumentError as error:
        raise FileError(f"{path}: {error}") from error


def _numbers(value: Any, name: str) -> Array:
    array, shape = np.asarray(value), SHAPES[name]
    if array.shape != shape or array.dtype.kind not in "fiu":
        kind = f"{array.dtype} in {' x '.join(map(str, array.shape)) or 'no dimension'}"
        found = described(value) if isinstance(value, Verbatim) else one_line(kind, LONGEST_QUOTE)
        raise DocumentError(name, found, f"numbers in {' x '.join(map(str, shape))}")
    for indices in np.ndindex(shape):
        place = name + "".join(f"[{k}]" for k in indices)
        (checked_number if len(shape) == 3 else checked_knot)(array[indices].item(), place)
    return array.astype(np.float64)


def _curves(knots: Array) -> tuple[Knots, ...]:
    return tuple(Knots(*values) for values in knots.tolist())


def _text(value: Any) -> Any:
    """Return the text of an array of one string; what is no text is told by the document's own check."""
    array = np.asarray(value)
    if isinstance(value, Verbatim):
        return value
    is_text = array.dtype.kind == "U" and array.size == 1
    return str(array.reshape(-1)[0]) if is_text else Verbatim(described(array))
