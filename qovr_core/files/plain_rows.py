"""Rows that hold nothing but points, as almost all rows of a large sheet do, read without a parser of XML.

The parser would take ten times as long for them.
"""

from __future__ import annotations

import re
from collections.abc import Iterable

import numpy as np

from qovr_core.files import published_layout as layout
from qovr_core.files.sheet_cells import POINT_COLUMNS, SheetCells


def without_plain_rows(block: bytes, sheet: SheetCells) -> bytes:
    """Take the rows that hold nothing but points out of a block of XML, and return the rest."""
    parts = _PLAIN_ROW.split(block)
    if len(parts) > 1:
        rows = np.array(parts[1::8], dtype=np.int64)
        if not layout.FIRST_ROW <= rows.min() <= rows.max() <= layout.LAST_ROW_OF_A_SHEET:
            raise ValueError(f"a point stands in row {rows.max()}; expected {layout.LAST_ROW_OF_A_SHEET:,} rows")
        sheet.last_row = max(sheet.last_row, int(rows.max()))
        columns = [list(map(float, parts[2 + k :: 8])) for k in range(len(POINT_COLUMNS))]
        kept = rows <= sheet.kept_rows
        sheet.points_for(int(rows[kept].max(initial=0)))[rows[kept] - layout.FIRST_ROW] = np.array(columns).T[kept]
    return b"".join(parts[::8])


def last_point_row(blocks: Iterable[bytes]) -> int:
    """Return the row of the last raw point in the last megabyte or two of a sheet; 0 where none is found there."""
    before = latest = b""
    for block in blocks:
        before, latest = latest, block
    found = _LAST_POINT.findall(before + latest)
    return int(found[-1]) if found else 0


def _plain(column: int, value: bytes) -> bytes:
    """Return the pattern of a cell with a number in the row at hand."""
    letters = layout.column_letters(column).encode()
    return rb'<c r="' + letters + rb'\1"(?: s="[0-9]{1,5}")?(?: t="n")?><v>' + value + rb"</v></c>"


_EMPTY = rb"(?:<c [^<>]*/>)*"
_COUNTER = rb"[0-9]{1,9}"
_FLOAT = rb"(-?[0-9]+(?:\.[0-9]*)?(?:[eE][-+]?[0-9]{1,4})?)"

_PLAIN_ROW = re.compile(
    rb'<row r="([0-9]{1,7})"[^<>]*>'
    + b"".join(
        _EMPTY
        + b"(?:"
        + _plain(layout.column_index(table), _COUNTER)
        + b")?"
        + b"".join(_plain(layout.column_index(table) + axis, _FLOAT) for axis in (1, 2, 3))
        for table in (layout.RAW, layout.TRANSFORMED)
    )
    + _EMPTY
    + rb"</row>"
)
"""A row as Excel and every library write it that holds raw and transformed coordinates and nothing else."""

_LAST_POINT = re.compile(
    rb'<c [^<>]*\br="'
    + layout.column_letters(POINT_COLUMNS[0]).encode()
    + rb'([0-9]{1,7})"[^<>]*>(?:<f[^<>]*/>|<f[^<>]*>[^<>]*</f>)?<v>[^<>]'
)
