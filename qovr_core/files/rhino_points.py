"""The control points as they stand in a ``.3dm`` file, wherever another program has moved them.

Found here by their pattern, and not by openNURBS, which goes astray for minutes in damaged files.
"""

from __future__ import annotations

import mmap
import re
import struct
from itertools import pairwise
from uuid import UUID

from qovr_core.arrays import Array
from qovr_core.geometry.windows import NET_SIZE

_POINT_CLASS = UUID("c3101a1d-f157-11d3-bfe7-0010830122f0").bytes_le
"""What openNURBS calls a point."""

_COORDINATES = re.compile(rb".{4}\xfc\xff\x02\x00(?:.{4}|.{8})\x10(.{24})", re.DOTALL)
"""After the class: its checksum, code and length of its data (of 4 bytes, or 8 since version 5), a version, x y z."""

_NAME = re.compile(rb"\x05\x00\x00\x00P\x00([0-%d])\x00,\x00([0-%d])\x00\x00\x00" % (NET_SIZE - 1, NET_SIZE - 1))
"""The name ``Pi,j`` among a point's attributes: its length with the closing zero, and its 16-bit characters."""

_FARTHEST_NAME = 4096
"""Bytes from a point's class within which its coordinates and its name stand."""


def moved_points(content: bytes | mmap.mmap, net: Array) -> Array:
    """Return a net (5, 5, 3) with the points named ``Pi,j`` as they stand in a file's content.

    A point that is not there, or there twice, keeps its place in ``net``.
    """
    found: dict[tuple[int, int], list[tuple[float, ...]]] = {}
    starts = [match.end() for match in re.finditer(re.escape(_POINT_CLASS), content)]
    for start, end in pairwise([*starts, len(content)]):
        part = content[start : min(end, start + _FARTHEST_NAME)]
        coordinates = _COORDINATES.match(part)
        name = _NAME.search(part)
        if coordinates and name:
            found.setdefault((int(name[1]), int(name[2])), []).append(struct.unpack("<3d", coordinates[1]))
    result = net.copy()
    for place, points in found.items():
        if len(points) == 1:
            result[place] = points[0]
    return result
