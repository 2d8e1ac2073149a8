"""Reading ``.xlsx`` in the published layout: the inputs, and the numbers that were computed from them."""

from __future__ import annotations

from dataclasses import dataclass
from math import isqrt
from pathlib import Path
from typing import Any

import numpy as np

from qovr_core.arrays import Array
from qovr_core.checks import SAMPLES_RANGE, checked_knot, checked_number, described
from qovr_core.document import NET_SIZE, Document
from qovr_core.errors import DocumentError, FileError
from qovr_core.files import published_layout as layout
from qovr_core.files.qovr_document import document_from_json
from qovr_core.formulations import Formulation
from qovr_core.geometry.knots import KNOT_NAMES, Knots, knot_array


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

    def __init__(self, name: str, rows: list[list[Any]]) -> None:
        self._name = name
        self._rows = rows

    @property
    def height(self) -> int:
        return len(self._rows)

    def value(self, column: int, row: int) -> object:
        """Return a cell's value by zero-based column and one-based row; None where it is empty."""
        cells = self._rows[row - 1] if row <= len(self._rows) else []
        value = cells[column] if column < len(cells) else ""
        return None if value == "" else value

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


def read_workbook(path: Path) -> Document:
    """Return the document whose inputs a workbook in the published layout holds.

    The formulation and the samples are those that this program recorded in the workbook, else
    ``published`` and a square grid of as many samples as there are raw points (101 x 101 where there are none).

    Raises
    ------
    FileError : the file cannot be read, or a cell of the inputs holds anything but what belongs there
    """
    sheet, record = _sheets(path)
    try:
        return _document(sheet, record)
    except DocumentError as error:
        raise FileError(f"{path}: {error} (published layout)") from error


def read_published_numbers(path: Path) -> PublishedNumbers:
    """Return everything a workbook in the published layout holds.

    Raises
    ------
    FileError : the file cannot be read, or a cell holds anything but what belongs there
    """
    sheet, record = _sheets(path)
    try:
        document = _document(sheet, record)
        n, m = document.samples
        if _raw_points(sheet) == 0:
            place = sheet.place(layout.column_index(layout.RAW) + 1, layout.FIRST_ROW)
            raise DocumentError(place, "empty", "the raw coordinates of the surface")
        return PublishedNumbers(
            document=document,
            raw=sheet.numbers(layout.RAW, n * m, 3).reshape(n, m, 3),
            transformed=sheet.numbers(layout.TRANSFORMED, n * m, 3).reshape(n, m, 3),
            control_box=sheet.numbers(layout.CONTROL_BOX, 3, 2),
            raw_box=sheet.numbers(layout.RAW_BOX, 3, 2),
            matrix=sheet.numbers(layout.MATRIX, 4, 4, skip=0),
        )
    except DocumentError as error:
        raise FileError(f"{path}: {error} (published layout)") from error


def _sheets(path: Path) -> tuple[_Sheet, dict[str, Any]]:
    """Return the first sheet, and what this program recorded on its own sheet; empty for other workbooks."""
    from python_calamine import CalamineError, CalamineWorkbook

    try:
        with path.open("rb"):
            pass  # tells a missing or forbidden file apart from a damaged one
        book = CalamineWorkbook.from_path(path)
        first = book.get_sheet_by_index(0)
        sheet = _Sheet(first.name, first.to_python(skip_empty_area=False))
        if layout.RECORD_SHEET not in book.sheet_names:
            return sheet, {}
        rows = book.get_sheet_by_name(layout.RECORD_SHEET).to_python(skip_empty_area=False)
        return sheet, {str(row[0]): row[1] for row in rows if len(row) >= 2}
    except OSError as error:
        raise FileError(f"{path}: cannot be read: {error.strerror or error}") from error
    except CalamineError as error:
        reason = " ".join(str(error).split())
        raise FileError(f"{path}: is no whole Excel workbook: {reason}") from error


def _document(sheet: _Sheet, record: dict[str, Any]) -> Document:
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
        formulation=record.get("formulation", Formulation.PUBLISHED),
        samples=_samples(sheet, record),
    )
    return _to_the_last_bit(document, record)


def _to_the_last_bit(document: Document, record: dict[str, Any]) -> Document:
    """Return the recorded document where it is the one in the cells; what someone has edited there counts."""
    try:
        recorded = document_from_json(str(record[layout.RECORD_OF_DOCUMENT]))
    except (KeyError, DocumentError, ValueError):
        return document
    pairs = (
        (recorded.control_points, document.control_points),
        (knot_array(recorded.row_knots), knot_array(document.row_knots)),
        (knot_array(recorded.column_knots), knot_array(document.column_knots)),
    )
    is_same = (recorded.formulation, recorded.samples) == (document.formulation, document.samples) and all(
        np.allclose(cells, exact, rtol=layout.CELL_ROUNDING, atol=0) for exact, cells in pairs
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


def _raw_points(sheet: _Sheet) -> int:
    column = layout.column_index(layout.RAW) + 1
    row = layout.FIRST_ROW
    while sheet.value(column, row) is not None:
        row += 1
    return row - layout.FIRST_ROW


def _samples(sheet: _Sheet, record: dict[str, Any]) -> tuple[int, int]:
    count = _raw_points(sheet)
    if "samples_u" in record and "samples_v" in record:
        n, m = (_whole(record[name]) for name in ("samples_u", "samples_v"))
        if n * m == count:
            return n, m
    if count == 0:
        return 101, 101
    side = isqrt(count)
    if side * side != count or not SAMPLES_RANGE[0] <= side <= SAMPLES_RANGE[1]:
        place = sheet.place(layout.column_index(layout.RAW) + 1, layout.FIRST_ROW)
        raise DocumentError(f"the table at {place}", f"{count} points long", "a square number of points, as 101 x 101")
    return side, side


def _whole(value: object) -> int:
    return int(value) if isinstance(value, (int, float)) and float(value).is_integer() else 0
