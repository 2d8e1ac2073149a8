"""The form of a recovery file: a line of JSON, and behind it all numbers as they lie in memory.

So the largest net is kept in a few milliseconds; its text would take the thread that writes it half a second, in which
no frame could be drawn.
"""

from __future__ import annotations

import json
import math
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from qovr_app.state.intents import Stamp
from qovr_core import Document
from qovr_core.arrays import Array
from qovr_core.joints import Joints

_NUMBER = np.dtype("<f8")


@dataclass(frozen=True, eq=False)
class Snapshot:
    """What is kept of a document that is not saved.

    Parameters
    ----------
    draft : the document with what is typed over it and not set; None where nothing is
    path, stamp : the file that Save writes, and what it was when it was read or written last
    """

    document: Document
    title: str
    path: Path | None = None
    stamp: Stamp | None = None
    draft: Document | None = None


def write_snapshot(snapshot: Snapshot, file: Path) -> None:
    """Write a file that ``read_snapshot`` reads.

    Raises
    ------
    OSError : it cannot be written
    """
    documents = [snapshot.document] if snapshot.draft is None else [snapshot.document, snapshot.draft]
    head = {
        "title": snapshot.title,
        "path": None if snapshot.path is None else str(snapshot.path),
        "stamp": snapshot.stamp,
        "documents": [_entries(document) for document in documents],
    }
    with file.open("wb") as content:
        content.write(json.dumps(head).encode() + b"\n")
        for document in documents:
            for numbers in _arrays(document).values():
                content.write(np.ascontiguousarray(numbers, _NUMBER).data)


def read_snapshot(file: Path) -> Snapshot:
    """Return what a file holds.

    Raises
    ------
    OSError, ValueError, KeyError, TypeError, RecursionError, QovrError : it is not what ``write_snapshot`` writes
    """
    with file.open("rb") as content:
        head = json.loads(content.readline())
        numbers = np.frombuffer(content.read(), _NUMBER)
    document, *drafts = _documents(head["documents"], numbers)
    path, stamp = head["path"], head["stamp"]
    return Snapshot(
        document=document,
        title=str(head["title"]),
        path=None if path is None else Path(path),
        stamp=None if stamp is None else tuple(map(int, stamp)),
        draft=next(iter(drafts), None),
    )


def _arrays(document: Document) -> dict[str, Array]:
    """Return the numbers of a document, in the order in which they are kept."""
    return {
        "control_points": document.control_points,
        "row_knots": document.row_knots.array,
        "column_knots": document.column_knots.array,
    }


def _entries(document: Document) -> dict[str, Any]:
    """Return all of a document but its numbers, of which the shapes stand here."""
    return {
        "shapes": {name: array.shape for name, array in _arrays(document).items()},
        "formulation": str(document.formulation),
        "samples": document.samples,
        "joints": {"u": document.joints.u, "v": document.joints.v},
        "closed": document.closed,
    }


def _documents(all_entries: Iterable[dict[str, Any]], numbers: Array) -> Iterator[Document]:
    start = 0
    for entries in all_entries:
        arrays = {}
        for name, shape in entries["shapes"].items():
            end = start + math.prod(shape)
            arrays[name] = numbers[start:end].reshape(shape)
            start = end
        yield Document(
            **arrays,
            formulation=entries["formulation"],
            samples=entries["samples"],
            joints=Joints(**entries["joints"]),
            closed=entries["closed"],
        )
    if start != len(numbers):
        raise ValueError(f"{len(numbers) - start} numbers belong to nothing")
