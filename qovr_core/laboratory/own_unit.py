"""A document in a unit in which its net is about 1, where no measure of its surface leaves the range of numbers."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from qovr_core.document import Document
from qovr_core.errors import DocumentError
from qovr_core.geometry.rounding import largest


def document_in_own_unit(document: Document) -> tuple[Document, float]:
    """Return a document in a unit in which its largest coordinate is about 1, and that unit.

    It is a power of two, so that nothing is rounded but what is some 1e-300 of the largest.
    """
    size = largest(document.control_points)
    unit = float(np.ldexp(1.0, np.frexp(size)[1])) if size else 1.0
    with np.errstate(under="ignore"):
        return replace(document, control_points=document.control_points / unit), unit


def in_unit(document: Document, unit: float) -> Document:
    """Return a document made of one in its own unit in that of the first; itself where it would be no document."""
    try:
        with np.errstate(under="ignore"):
            return replace(document, control_points=document.control_points * unit)
    except DocumentError:
        return document
