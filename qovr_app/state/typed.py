"""Blocks of numbers that are pasted: from a spreadsheet, a table of comma separated values or a web page."""

from __future__ import annotations

import csv
import io
import re
from collections.abc import Callable, Sequence
from itertools import pairwise

from qovr_app.state.typed_numbers import trimmed, typed_number
from qovr_core import DocumentError
from qovr_core.checks import described

Cell = str | float
"""A cell as it was typed, or the number behind it where the table says it in full."""

Cells = Sequence[Sequence[Cell]]
"""The cells of a table, row by row; rows may be of different lengths."""

Fits = Callable[[int, int], bool]
"""Says whether there is a place for a block of so many rows and columns."""

_MOST_INDEX_COLUMNS = 2
"""A point is numbered by its row and its column; nothing here is numbered by more."""

_NO_NAMES = {"nan", "inf", "infinity", "na", "n/a", "null", "none"}
"""What programs write where there is no number."""

_GROUPED = re.compile(r"\s*[+-]?[1-9]\d{0,2}(,\d{3})+(\.\d*)?\s*", re.ASCII)


def text_cells(text: str) -> list[list[str]]:
    """Return the cells of a text; they are parted by tabs, else by semicolons, else by commas.

    A comma parts cells only where it cannot be the decimal one: where a line has a point too, or several commas.

    Raises
    ------
    DocumentError : a text is as well one number with group separators as several numbers, or quotes are not closed
    """
    text = text.strip("\r\n")
    separator = next((sign for sign in "\t;" if sign in text), "")
    lines = text.splitlines()
    if not separator and _is_comma_parted(lines):
        separator = ","
    if not separator:
        return [[line] for line in lines]
    try:
        rows = list(csv.reader(io.StringIO(text, newline=""), delimiter=separator, skipinitialspace=True))
    except csv.Error as error:
        raise DocumentError("what is pasted", "no table that can be read", "cells parted by tabs") from error
    return _without_empty_ends(rows)


def is_block(cells: Cells) -> bool:
    """Return whether there is more than one cell."""
    return len(cells) > 1 or any(len(row) > 1 for row in cells)


def typed_block(block: str | Cells, fits: Fits = lambda _rows, _columns: True) -> list[list[float]]:
    """Return the rows of numbers in a pasted table, without its headings.

    A first row of words and first columns of words are headings; counted numbers are where the block has no place with
    them, and one without them.

    Parameters
    ----------
    block : the cells, or a text of them
    fits : says which sizes have a place

    Raises
    ------
    DocumentError : there is no cell, a cell holds no number, one has another decimal separator than those before it, or
        the rows are of different lengths; it names the place
    """
    cells = text_cells(block) if isinstance(block, str) else block
    if not any(_is_filled(cell) for row in cells for cell in row):
        raise DocumentError("what is pasted", "empty", "a block of numbers")
    if _has_numbered_edges(cells) and fits(len(cells) - 1, len(cells[0]) - 1):
        return _numbers(cells, 1, 1)
    rows, columns = headings = _headings_of_words(cells)
    numbers = _numbers(cells, *headings)
    if not fits(len(numbers), len(numbers[0])):
        for count in range(1, _MOST_INDEX_COLUMNS - columns + 1):
            inner = [row[count:] for row in numbers]
            if inner[0] and fits(len(inner), len(inner[0])) and _is_counted([row[:count] for row in numbers]):
                return _numbers(cells, rows, columns + count)
    return numbers


def _is_comma_parted(lines: Sequence[str]) -> bool:
    """Return whether commas part the cells of lines without tabs and semicolons."""
    with_comma = [line for line in lines if "," in line]
    if with_comma and all(_GROUPED.fullmatch(line) for line in with_comma):
        if any(line.count(",") > 1 or "." in line for line in with_comma):
            where, line = next((k, line) for k, line in enumerate(lines, start=1) if line in with_comma)
            expected = "cells parted by tabs or semicolons, and numbers without group separators"
            raise DocumentError(f"row {where} of what is pasted", described(line.strip()), expected)
        return False
    return any(line.count(",") > 1 or "." in line for line in with_comma)


def _without_empty_ends(rows: list[list[str]]) -> list[list[str]]:
    """Return rows without the empty cells that a separator at the end of every line makes."""
    while rows and all(len(row) > 1 and not trimmed(row[-1]) for row in rows):
        rows = [row[:-1] for row in rows]
    return rows


def _headings_of_words(cells: Cells) -> tuple[int, int]:
    """Return how many first rows and columns are words."""
    rows = int(len(cells) > 1 and any(map(_is_word, cells[0])) and not any(map(_is_numeric, cells[0])))
    columns = 0
    while columns < _MOST_INDEX_COLUMNS and all(len(row) > columns + 1 for row in cells[rows:]):
        if not all(_is_word(row[columns]) for row in cells[rows:]):
            break
        columns += 1
    return rows, columns


def _has_numbered_edges(cells: Cells) -> bool:
    """Return whether first row and first column are counted from a corner that is no number."""
    if len(cells) < 2 or len(cells[0]) < 2 or _is_numeric(cells[0][0]) or not all(cells):
        return False
    across, down = list(cells[0][1:]), [row[0] for row in cells[1:]]
    return _is_count(across) and (_is_count(down) or all(map(_is_word, down)))


def _is_count(line: Sequence[Cell]) -> bool:
    return all(map(_is_numeric, line)) and _is_counted([[_number(cell, "")] for cell in line])


def _is_counted(indices: Sequence[Sequence[float]]) -> bool:
    """Return whether index columns count: one in steps of 1, several by pairs of whole numbers that all differ."""
    whole = all(index >= 0 and index.is_integer() for row in indices for index in row)
    if not whole or len(indices) < 2:
        return False
    if len(indices[0]) > 1:
        return len({tuple(row) for row in indices}) == len(indices)
    steps = {after[0] - before[0] for before, after in pairwise(indices)}
    return steps in ({1.0}, {-1.0})


def _is_filled(cell: Cell) -> bool:
    return not isinstance(cell, str) or bool(trimmed(cell))


def _is_numeric(cell: Cell) -> bool:
    return not isinstance(cell, str) or isinstance(typed_number(cell), float)


def _is_word(cell: Cell) -> bool:
    """Return whether a cell is a name; what stands where a number failed is none."""
    text = trimmed(cell).lower() if isinstance(cell, str) else ""
    return any(map(str.isalpha, text)) and not text[0].isnumeric() and text[0] not in "+-.,#" and text not in _NO_NAMES


def _numbers(cells: Cells, rows: int, columns: int) -> list[list[float]]:
    """Return the numbers below and right of the headings, or say which cell is none."""
    result: list[list[float]] = []
    separator = ""
    for r, row in enumerate(cells[rows:], start=rows + 1):
        numbers = []
        for c, cell in enumerate(row[columns:], start=columns + 1):
            place = f"row {r}, column {c} of what is pasted"
            numbers.append(_number(cell, place))
            own = _decimal_separator(cell)
            if own and separator and own != separator:
                expected = f"a decimal {'comma' if separator == ',' else 'point'}, as in the cells before it"
                raise DocumentError(place, described(cell), expected)
            separator = own or separator
        if result and len(numbers) != len(result[0]):
            lengths = f"{len(numbers)} cells long", f"{len(result[0])} cells, as the rows above"
            raise DocumentError(f"row {r} of what is pasted", *lengths)
        result.append(numbers)
    if not result or not result[0]:
        raise DocumentError("what is pasted", "without a number", "a block of numbers")
    return result


def _number(cell: Cell, place: str) -> float:
    value = cell if isinstance(cell, float) else typed_number(cell)
    if not isinstance(value, float):
        raise DocumentError(place, described(value), "a number, as 0.35 or 0,35")
    return value


def _decimal_separator(cell: Cell) -> str:
    return next((sign for sign in ",." if sign in cell), "") if isinstance(cell, str) else ""
