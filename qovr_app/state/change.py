"""What differs between two documents, as a value: with either of them it makes the other, bit for bit."""

from __future__ import annotations

import sys
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, fields, replace
from functools import cached_property
from typing import Any

import numpy as np
import numpy.typing as npt

from qovr_core import Document
from qovr_core.arrays import Array
from qovr_core.geometry.knots import KnotTable

_Bits = npt.NDArray[np.uint64]
_Places = npt.NDArray[np.uint32]

_BYTES_A_PART = 450
"""One part of a change as Python holds it, without its numbers."""


@dataclass(frozen=True, eq=False)
class Flipped:
    """Numbers of an array are other ones: which of their bits differ. Flipped once more, they are back.

    Parameters
    ----------
    bits : (k,)
    places : (k,), where these numbers stand, all rows of the array in one; None where they are all of them
    """

    bits: _Bits
    places: _Places | None


@dataclass(frozen=True, eq=False)
class Replaced:
    """A part is another one as a whole."""

    before: Any
    after: Any


@dataclass(frozen=True, eq=False)
class Change:
    """The parts of a document, by the names of its fields, in which another one differs."""

    parts: Mapping[str, Flipped | Replaced]

    @classmethod
    def between(cls, before: Document, after: Document) -> Change:
        """Return what makes one document of the other."""
        pairs = {field.name: (getattr(before, field.name), getattr(after, field.name)) for field in fields(Document)}
        parts = {name: _part(*pair) for name, pair in pairs.items()}
        return cls({name: part for name, part in parts.items() if part is not None})

    @cached_property
    def bytes_held(self) -> int:
        """What it takes in memory."""
        return sum(_BYTES_A_PART + _bytes_of(part) for part in self.parts.values())


def forward(document: Document, changes: Iterable[Change]) -> Document:
    """Return the document after changes that begin with it."""
    return _followed(document, changes, is_forward=True)


def backward(document: Document, changes: Iterable[Change]) -> Document:
    """Return the document before changes that end with it, the last one first."""
    return _followed(document, changes, is_forward=False)


def _followed(document: Document, changes: Iterable[Change], *, is_forward: bool) -> Document:
    """Return the document at the end of a row of changes; the documents between are not made."""
    values: dict[str, Any] = {}
    for change in changes:
        for name, part in change.parts.items():
            if isinstance(part, Flipped):
                values[name] = _flipped(values.get(name, getattr(document, name)), part)
            else:
                values[name] = part.after if is_forward else part.before
    return replace(document, **values)


def _part(before: Any, after: Any) -> Flipped | Replaced | None:
    if before is after:
        return None
    old, new = _numbers_of(before), _numbers_of(after)
    if old is None or new is None:
        return None if before == after else Replaced(before, after)
    if old.shape != new.shape:
        return Replaced(before, after)
    bits = old.ravel().view(np.uint64) ^ new.ravel().view(np.uint64)
    places = np.flatnonzero(bits).astype(np.uint32)
    if not len(places):
        return None
    sparse = bits[places]
    is_shorter = sparse.nbytes + places.nbytes < bits.nbytes
    return Flipped(sparse, places) if is_shorter else Flipped(bits, None)


def _flipped(value: Any, part: Flipped) -> Array:
    """Return the numbers of a value with these bits flipped; an array that was made on the way is changed itself."""
    numbers = value.array if isinstance(value, KnotTable) else value
    mine: Array = numbers if numbers.flags.writeable else numbers.copy()
    mine.reshape(-1).view(np.uint64)[... if part.places is None else part.places] ^= part.bits
    return mine


def _numbers_of(part: Any) -> Array | None:
    """Return the numbers that a part of a document is or holds; None for what is no array."""
    numbers = part.array if isinstance(part, KnotTable) else part
    return numbers if isinstance(numbers, np.ndarray) else None


def _bytes_of(part: Flipped | Replaced) -> int:
    if isinstance(part, Flipped):
        return part.bits.nbytes + (0 if part.places is None else part.places.nbytes)
    both = [(value, _numbers_of(value)) for value in (part.before, part.after)]
    return sum(sys.getsizeof(value) if numbers is None else numbers.nbytes for value, numbers in both)
