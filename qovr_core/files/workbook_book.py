"""An open workbook: the sheet in the published layout, wherever it stands, and this program's own sheet beside it."""

from __future__ import annotations

import zipfile
import zlib
from collections.abc import Iterator
from contextlib import contextmanager
from itertools import islice
from pathlib import Path
from typing import Any
from xml.parsers import expat

import numpy as np

from qovr_core.errors import DocumentError
from qovr_core.files import archive as zipped
from qovr_core.files import published_layout as layout
from qovr_core.files.plain_rows import last_point_row
from qovr_core.files.reading import reading
from qovr_core.files.sheet_cells import HEAD_ROWS, SharedText, SheetCells
from qovr_core.files.sheet_read import read_cells
from qovr_core.files.workbook_parts import LARGEST_SHEET, SheetPart, shared_texts, sheet_parts
from qovr_core.geometry.windows import NET_SIZE

_COMPOUND_FILE = b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1"
"""What workbooks of Excel before 2007 begin with, and all that are behind a password."""

_MOST_SHEETS = 64
"""Sheets among which the layout is looked for."""

_HEAD_BLOCKS = 8
"""Megabytes of a sheet within which its first rows end."""


class Book:
    """A workbook of which nothing is read but what is asked for.

    Raises
    ------
    ValueError, expat.ExpatError, zipfile.BadZipFile, zlib.error : as every method does where the workbook is damaged
    """

    def __init__(self, archive: zipfile.ZipFile) -> None:
        self._archive = archive
        parts = sheet_parts(archive)[:_MOST_SHEETS]
        heads = [self._head(part) for part in parts]
        self._resolve(*heads)
        best = max(range(len(parts)), key=lambda k: _likeness(heads[k]))
        self._part = parts[best]
        self.record = next(
            (_pairs(head) for part, head in zip(parts, heads, strict=True) if part.name == layout.RECORD_SHEET), {}
        )

    @property
    def sheet_name(self) -> str:
        """What the sheet with the layout is called; the first sheet where none has it."""
        return self._part.name

    def cells(self, last_row: int) -> SheetCells:
        """Return what the sheet with the layout holds down to some row, or further."""
        sheet = read_cells(self._blocks(self._part), last_row)
        self._resolve(sheet)
        return sheet

    def point_count(self) -> int:
        """Return how many raw points the sheet holds, told from its end alone where that can be."""
        row = last_point_row(self._blocks(self._part))
        return row - layout.FIRST_ROW + 1 if row else self.cells(layout.LAST_ROW_OF_A_SHEET).count

    def _head(self, part: SheetPart) -> SheetCells:
        """Return the first rows of a sheet; nothing where it is damaged, which says who wants to read all of it."""
        try:
            return read_cells(islice(self._blocks(part), _HEAD_BLOCKS), HEAD_ROWS)
        except (ValueError, expat.ExpatError, zipfile.BadZipFile, zlib.error, EOFError):
            return SheetCells(0)

    def _blocks(self, part: SheetPart) -> Iterator[bytes]:
        return zipped.blocks(self._archive, part.member, LARGEST_SHEET)

    def _resolve(self, *sheets: SheetCells) -> None:
        """Put the texts that cells share into their cells."""
        places = [
            (sheet.cells, place, value)
            for sheet in sheets
            for place, value in sheet.cells.items()
            if isinstance(value, SharedText)
        ]
        texts = shared_texts(self._archive, {int(number) for _, _, number in places})
        for cells, place, number in places:
            cells[place] = texts[number]


@contextmanager
def opened_book(path: Path) -> Iterator[Book]:
    """Yield the workbook in a file.

    Raises
    ------
    FileError : it cannot be read, is no workbook, or the block raises DocumentError: a cell holds the wrong thing
    """
    with reading(path, "is no whole Excel workbook:") as file:
        if file.read(len(_COMPOUND_FILE)) == _COMPOUND_FILE:
            raise ValueError("it is of an Excel before 2007, or behind a password")
        with zipped.opened_archive(file) as archive:
            try:
                yield Book(archive)
            except DocumentError as error:
                raise DocumentError(error.place, error.found, f"{error.expected} (published layout)") from error


def _likeness(sheet: SheetCells) -> int:
    """Return how many of the layout's headings and indices stand where they belong."""
    texts = [(layout.TITLE_ROW, layout.TITLES), (layout.FIRST_ROW - 1, layout.HEADERS)]
    headings = [(layout.column_index(letters), row, text) for row, named in texts for letters, text in named.items()]
    first = layout.column_index(layout.NET) + 1
    indices = [
        (first + which, layout.FIRST_ROW + k, float(index))
        for k, pair in enumerate(np.ndindex(NET_SIZE, NET_SIZE))
        for which, index in enumerate(pair)
    ]
    return sum(sheet.value(column, row) == expected for column, row, expected in headings + indices)


def _pairs(sheet: SheetCells) -> dict[str, Any]:
    """Return what stands in column B by what stands in column A."""
    return {str(name): sheet.value(1, row) for (column, row), name in sheet.cells.items() if column == 0}
