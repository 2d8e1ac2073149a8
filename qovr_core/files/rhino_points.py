"""The control points as they stand in a ``.3dm`` file, wherever another program has moved them.

Found here by their pattern, and not by openNURBS, which goes astray for minutes in damaged files.
"""

from __future__ import annotations

import mmap
import re
import struct
from collections.abc import Iterator
from itertools import pairwise
from uuid import UUID

import numpy as np

from qovr_core.arrays import Array
from qovr_core.document import ALIKE_WHERE_CLOSED, Document, NetIndex

_POINT_CLASS = UUID("c3101a1d-f157-11d3-bfe7-0010830122f0").bytes_le
"""What openNURBS calls a point."""

_COORDINATES = re.compile(rb".{4}\xfc\xff\x02\x00(?:.{4}|.{8})\x10(.{24})", re.DOTALL)
"""After the class: its checksum, code and length of its data (of 4 bytes, or 8 since version 5), a version, x y z."""

_NAME = re.compile(rb"([\x05-\x09])\x00{3}P\x00((?:[0-9]\x00){1,3}),\x00((?:[0-9]\x00){1,3})\x00\x00", re.DOTALL)
"""The name ``Pi,j`` among a point's attributes: its length with the closing zero, and its 16-bit characters."""

_FARTHEST_NAME = 4096
"""Bytes from a point's class within which its coordinates and its name stand."""


def own_points(document: Document) -> Iterator[NetIndex]:
    """Yield the control points of a document, and of those that are one on a closed net the first."""
    yield from np.ndindex(*_own_shape(document))


def moved_points(content: bytes | mmap.mmap, document: Document) -> tuple[Array, int]:
    """Return a document's net with the points named ``Pi,j`` as they stand in a file's content, and how many moved.

    A point that is not there, or there twice, keeps its place.
    """
    rows, columns = shape = _own_shape(document)
    found: dict[NetIndex, list[tuple[float, ...]]] = {}
    starts = [match.end() for match in re.finditer(re.escape(_POINT_CLASS), content)]
    for start, end in pairwise([*starts, len(content)]):
        part = content[start : min(end, start + _FARTHEST_NAME)]
        coordinates = _COORDINATES.match(part)
        place = _place(part, shape)
        if coordinates and place:
            found.setdefault(place, []).append(struct.unpack("<3d", coordinates[1]))
    own = document.control_points[:rows, :columns].copy()
    for place, points in found.items():
        if len(points) == 1:
            own[place] = points[0]
    moved = int((own != document.control_points[:rows, :columns]).any(axis=-1).sum())
    size = document.control_points.shape
    return own[np.arange(size[0]) % rows][:, np.arange(size[1]) % columns], moved


def _own_shape(document: Document) -> tuple[int, int]:
    """Return how many rows and columns of points repeat no others, as the last ones of a closed net do."""
    sizes = zip(document.control_points.shape[:2], ("v", "u"), strict=True)
    rows, columns = (size - ALIKE_WHERE_CLOSED if letter in document.closed else size for size, letter in sizes)
    return rows, columns


def _place(part: bytes, shape: tuple[int, int]) -> NetIndex | None:
    """Return which point of a net of a shape the first name in a part of a file is; None where there is none."""
    for match in _NAME.finditer(part):
        i, j = (digits.decode("utf-16-le") for digits in match.groups()[1:])
        is_whole = match[1][0] == len(f"P{i},{j}") + 1
        if is_whole and f"{int(i)},{int(j)}" == f"{i},{j}" and int(i) < shape[0] and int(j) < shape[1]:
            return int(i), int(j)
    return None
