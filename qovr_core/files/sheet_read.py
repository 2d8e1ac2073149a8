"""Reading the cells of one sheet as they come."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from qovr_core.checks import Verbatim
from qovr_core.files import published_layout as layout
from qovr_core.files.plain_rows import without_plain_rows
from qovr_core.files.sheet_cells import SharedText, SheetCells
from qovr_core.files.xml_stream import XmlStream

_LONGEST_TEXT = 1_000_000

_NUMBER = re.compile(r"[-+]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][-+]?[0-9]+)?")
_ROW = re.compile(r"[0-9]{1,9}")
_REFERENCE = re.compile(r"([A-Z]{1,3})([0-9]{1,9})")


def read_cells(blocks: Iterable[bytes], last_row: int) -> SheetCells:
    """Return the cells of a sheet down to some row.

    Parameters
    ----------
    blocks : the sheet's XML; not read further than is needed

    Raises
    ------
    ValueError, expat.ExpatError : it is no sheet
    """
    sheet = SheetCells(last_row)
    stream = XmlStream(_CellReader(sheet))
    for block in _cut_at_rows(blocks):
        stream.feed(without_plain_rows(block, sheet))
        if sheet.last_row > last_row:
            return sheet
    stream.close()
    return sheet


def _cut_at_rows(blocks: Iterable[bytes]) -> Iterator[bytes]:
    """Yield the same content in blocks that end where a row does, as far as there are rows."""
    rest = b""
    for block in blocks:
        whole, end, rest_of_block = block.rpartition(b"</row>")
        if end:
            yield rest + whole + end
            rest = rest_of_block
        else:
            yield rest + block
            rest = b""
    yield rest


class _CellReader:
    """Tells a sheet's cells from its XML."""

    def __init__(self, sheet: SheetCells) -> None:
        self._sheet = sheet
        self._row = self._column = 0
        self._kind = ""
        self._text: list[str] = []
        self._length = 0
        self._is_value = self._is_spoken = False

    def start(self, name: str, attributes: dict[str, str]) -> None:
        if name == "c":
            self._begin_cell(attributes)
        elif name == "row":
            self._row = _row_number(attributes.get("r"), self._row + 1)
            self._column = -1
            self._sheet.last_row = max(self._sheet.last_row, self._row)
        elif name == "rPh":
            self._is_spoken = True
        self._is_value = name in ("v", "t") and not self._is_spoken

    def text(self, text: str) -> None:
        if self._is_value:
            self._length += len(text)
            if self._length > _LONGEST_TEXT:
                raise ValueError(f"a cell is longer than {_LONGEST_TEXT:,} characters")
            self._text.append(text)

    def end(self, name: str) -> None:
        self._is_value = False
        if name == "rPh":
            self._is_spoken = False
        elif name == "c" and (text := "".join(self._text)):
            self._sheet.put(self._column, self._row, _value(self._kind, text))

    def _begin_cell(self, attributes: dict[str, str]) -> None:
        self._kind = attributes.get("t", "n")
        self._text.clear()
        self._length = 0
        reference = attributes.get("r")
        if reference is None:
            self._column += 1
            return
        match = _REFERENCE.fullmatch(reference)
        if not match:
            raise ValueError(f"{reference!r} is no cell")
        self._column = layout.column_index(match[1])
        self._row = _row_number(match[2], self._row)


def _row_number(text: str | None, default: int) -> int:
    if text is None:
        return default
    if not _ROW.fullmatch(text) or int(text) > layout.LAST_ROW_OF_A_SHEET:
        raise ValueError(f"{text!r} is no row; expected a number up to {layout.LAST_ROW_OF_A_SHEET:,}")
    return int(text)


def _value(kind: str, text: str) -> object:
    if kind in ("str", "inlineStr", "d"):
        return text
    if kind == "b":
        return text.strip() == "1"
    if kind == "n" and _NUMBER.fullmatch(text.strip()):
        return float(text)
    if kind == "s" and _ROW.fullmatch(text.strip()):
        return SharedText(text)
    return Verbatim(text)
