"""The times and the id of a PDF, which Qt takes from the clock and at random: made of what the file says instead."""

from __future__ import annotations

import re
from functools import partial
from uuid import UUID, uuid5

from qovr_core.files.provenance import timestamp

_TIME = re.compile(rb"/(?:CreationDate|ModDate) \(([^)]*)\)")
_XMP_TIME = re.compile(rb'xmp:(?:CreateDate|ModifyDate|MetadataDate)="([^"]*)"')
_XMP_ID = re.compile(rb"uuid:([0-9a-f-]{36})")
_IDS = UUID("0c2a4d3e-59f1-4b7c-8a55-3b1f7f0e6d21")
"""Of which the id of a figure is made, with its content."""


def same_every_time(content: bytes) -> bytes:
    """Return a PDF of Qt's with the time that it is to tell, or none, and an id of its content.

    Nothing changes its length, for a PDF holds the places of its parts.
    """
    made = timestamp()
    for pattern, form in ((_TIME, "D:%Y%m%d%H%M%SZ"), (_XMP_TIME, "%Y-%m-%dT%H:%M:%SZ")):
        time = f"{made:{form}}".encode() if made else b""
        content = pattern.sub(partial(_retold, time=time), content)
    known = _XMP_ID.search(content)
    if known is None:
        return content
    blank = _with_id(content, known[1], bytes(len(known[1])))
    return _with_id(content, known[1], str(uuid5(_IDS, blank.hex())).encode())


def _retold(match: re.Match[bytes], time: bytes) -> bytes:
    """Return an entry with another time, and blanks instead of one that is none."""
    if not time:
        return b" " * len(match[0])
    return match[0].replace(match[1], time).ljust(len(match[0]))


def _with_id(content: bytes, known: bytes, chosen: bytes) -> bytes:
    """Return a PDF with another id, which it spells as text and in hexadecimal."""
    return content.replace(known, chosen).replace(known.hex().encode(), chosen.hex().encode())
