"""Reading ``.xlsx`` in the published layout: the inputs, and the numbers that were computed from them."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from qovr_core.arrays import Array
from qovr_core.checks import LARGEST_MAGNITUDE, SAMPLES_RANGE, checked_knot, checked_number, described
from qovr_core.document import Document
from qovr_core.errors import DocumentError, quoted
from qovr_core.files import published_layout as layout
from qovr_core.files.qovr_document import document_from_json
from qovr_core.files.sample_grid import grid_of
from qovr_core.files.sheet_cells import SheetCells
from qovr_core.files.workbook_book import Book, opened_book
from qovr_core.formulations import Formulation
from qovr_core.geometry.knots import KNOT_NAMES, Knots
from qovr_core.geometry.windows import NET_SIZE

_ROWS_OF_INPUTS = layout.FIRST_ROW + SAMPLES_RANGE[1] + 1
"""The inputs, and a row of samples and one more, by which the samples are counted where nothing else tells them."""

_DEFAULT_SAMPLES = (101, 101)


@dataclass(frozen=True, eq=False)
class PublishedNumbers:
    """What a workbook holds besides its inputs.

    ``raw`` and ``transformed`` are (n, m, 3), indexed [iu, iv]; boxes are (3, 2); ``matrix`` is (4, 4).
    """

    document: Document
    raw: Array
    transformed: Array
    control_box: Array
    raw_box: Array
    matrix: Array


class _Sheet:
    """Cells of one sheet, with errors that name the cell."""

    def __init__(self, name: str, cells: SheetCells) -> None:
        self._name = quoted(name)
        self._cells = cells

    @property
    def raw(self) -> Array:
        """The raw points that were read, (k, 3), NaN where there is no number."""
        return self._cells.points[: self._cells.count, :3]

    def value(self, column: int, row: int) -> object:
        """Return a cell's value by zero-based column and one-based row; None where it is empty."""
        return self._cells.value(column, row)

    def place(self, column: int, row: int) -> str:
        return f"{self._name}!{layout.column_letters(column)}{row}"

    def number(self, column: int, row: int) -> float:
        return checked_number(self.value(column, row), self.place(column, row))

    def knot(self, column: int, row: int) -> float:
        return checked_knot(self.value(column, row), self.place(column, row))

    def numbers(self, first_column: str, rows: int, columns: int, *, skip: int = 1) -> Array:
        """Return a table of numbers that begins ``skip`` columns right of a table's first column."""
        start = layout.column_index(first_column) + skip
        return np.array([[self.number(start + c, layout.FIRST_ROW + r) for c in range(columns)] for r in range(rows)])

    def points(self, table: str, count: int) -> Array:
        """Return a table of points, (count, 3)."""
        first = 3 * (table == layout.TRANSFORMED)
        points = np.full((count, 3), np.nan)
        there = self._cells.points[:count, first : first + 3]
        points[: len(there)] = there
        for row, axis in np.argwhere(~(np.abs(points) <= LARGEST_MAGNITUDE))[:1].tolist():
            self.number(layout.column_index(table) + 1 + axis, layout.FIRST_ROW + row)
        return points


def read_workbook(path: Path) -> Document:
    """Return the document whose inputs a workbook in the published layout holds.

    The formulation and the samples are those that this program recorded in the workbook, else
    ``published`` and the grid on which the raw points lie (101 x 101 where there are none).

    Raises
    ------
    FileError : the file cannot be read, or a cell of the inputs holds anything but what belongs there
    """
    with opened_book(path) as book:
        sheet = _Sheet(book.sheet_name, book.cells(_ROWS_OF_INPUTS))
        few = len(sheet.raw)
        return _document(sheet, book, few if few < SAMPLES_RANGE[1] else book.point_count())


def read_published_numbers(path: Path) -> PublishedNumbers:
    """Return everything a workbook in the published layout holds.

    Raises
    ------
    FileError : the file cannot be read, or a cell holds anything but what belongs there
    """
    with opened_book(path) as book:
        sheet = _Sheet(book.sheet_name, book.cells(layout.LAST_ROW_OF_A_SHEET))
        first = layout.column_index(layout.RAW) + 1, layout.FIRST_ROW
        if sheet.value(*first) is None:
            raise DocumentError(sheet.place(*first), "empty", "the raw coordinates of the surface")
        document = _document(sheet, book, len(sheet.raw))
        n, m = document.samples
        return PublishedNumbers(
            document=document,
            raw=sheet.points(layout.RAW, n * m).reshape(n, m, 3),
            transformed=sheet.points(layout.TRANSFORMED, n * m).reshape(n, m, 3),
            control_box=sheet.numbers(layout.CONTROL_BOX, 3, 2),
            raw_box=sheet.numbers(layout.RAW_BOX, 3, 2),
            matrix=sheet.numbers(layout.MATRIX, 4, 4, skip=0),
        )


def _document(sheet: _Sheet, book: Book, count: int) -> Document:
    """Return the document of a sheet with so many raw points."""
    first = layout.column_index(layout.NET)
    for k, indices in enumerate(np.ndindex(NET_SIZE, NET_SIZE)):
        for column, index in zip((first + 1, first + 2), indices, strict=True):
            value = sheet.value(column, layout.FIRST_ROW + k)
            if value != index:
                raise DocumentError(sheet.place(column, layout.FIRST_ROW + k), described(value), f"the index {index}")
    net = sheet.numbers(layout.NET, NET_SIZE * NET_SIZE, 3, skip=3).reshape(NET_SIZE, NET_SIZE, 3)
    document = Document(
        control_points=net,
        row_knots=_row_knots(sheet),
        column_knots=_column_knots(sheet),
        formulation=book.record.get("formulation", Formulation.PUBLISHED),
    )
    document = replace(document, samples=_samples(document, sheet, book.record, count))
    return _to_the_last_bit(document, book.record)


def _to_the_last_bit(document: Document, record: dict[str, Any]) -> Document:
    """Return the recorded document where it is the one in the cells; what someone has edited there counts."""
    try:
        recorded = document_from_json(str(record[layout.RECORD_OF_DOCUMENT]))
    except (KeyError, DocumentError, ValueError):
        return document
    pairs = (
        (recorded.control_points, document.control_points),
        (recorded.row_knots.array, document.row_knots.array),
        (recorded.column_knots.array, document.column_knots.array),
    )
    is_same = (
        recorded.windows == document.windows
        and (recorded.formulation, recorded.samples) == (document.formulation, document.samples)
        and all(np.allclose(cells, exact, rtol=layout.CELL_ROUNDING, atol=0) for exact, cells in pairs)
    )
    return recorded if is_same else document


def _row_knots(sheet: _Sheet) -> tuple[Knots, ...]:
    first = layout.column_index(layout.ROW_KNOTS) + 1
    rows = range(layout.FIRST_ROW + NET_SIZE - 1, layout.FIRST_ROW - 1, -1)  # C_0 stands lowest
    return tuple(Knots(*(sheet.knot(first + c, row) for c in range(len(KNOT_NAMES)))) for row in rows)


def _column_knots(sheet: _Sheet) -> tuple[Knots, ...]:
    first = layout.column_index(layout.COLUMN_KNOTS) + 1
    rows = range(layout.FIRST_ROW + len(KNOT_NAMES) - 1, layout.FIRST_ROW - 1, -1)  # r stands lowest
    columns = range(first, first + NET_SIZE)
    return tuple(Knots(*(sheet.knot(column, row) for row in rows)) for column in columns)


def _samples(document: Document, sheet: _Sheet, record: dict[str, Any], count: int) -> tuple[int, int]:
    n, m = (_whole(record.get(name)) for name in ("samples_u", "samples_v"))
    if n * m == count > 0:
        return n, m
    if count == 0:
        return _DEFAULT_SAMPLES
    grid = grid_of(document, sheet.raw, count)
    if grid is None:
        place = sheet.place(layout.column_index(layout.RAW) + 1, layout.FIRST_ROW)
        raise DocumentError(f"the table at {place}", f"{count} points long", "a square number of points, as 101 x 101")
    return grid


def _whole(value: object) -> int:
    return int(value) if isinstance(value, float) and value.is_integer() else 0
