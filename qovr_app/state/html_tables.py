"""Tables in HTML, as spreadsheets and web pages put them on the clipboard and take them from it.

A number stands there twice: as people read it, and as it is. LibreOffice has it in ``sdval``, whose language is in
``sdnum`` (1033 is English: a decimal point); Excel in ``x:num``, empty where the text says it all.
"""

from __future__ import annotations

import html
from collections.abc import Sequence
from html.parser import HTMLParser
from math import isfinite
from typing import NamedTuple

from qovr_app.state.typed import Cell
from qovr_app.state.typed_numbers import trimmed, typed_number
from qovr_core.number_texts import number_text

_HEAD = '<meta charset="utf-8"><table xmlns:x="urn:schemas-microsoft-com:office:excel">'
_EXACT = ("sdval", "x:num")
"""The attributes that hold a cell's number in full."""


class Shown(NamedTuple):
    """A number as a table shows it, rounded and with its unit, and in full."""

    text: str
    value: float


def html_table(rows: Sequence[Sequence[Cell | Shown]]) -> str:
    """Return rows as a table whose numbers any spreadsheet takes for numbers, whatever its decimal separator is."""
    lines = ("".join(map(_written, row)) for row in rows)
    return _HEAD + "".join(f"<tr>{line}</tr>" for line in lines) + "</table>"


def _written(cell: Cell | Shown) -> str:
    text, value = (cell.text, cell.value) if isinstance(cell, Shown) else (cell, cell)
    number = typed_number(value) if isinstance(value, str) else value
    if not isinstance(number, float) or not isfinite(number):
        return f"<td>{html.escape(str(text))}</td>"
    full = number_text(number)
    shown = html.escape(text) if isinstance(text, str) else full
    return f'<td align="right" sdval="{full}" sdnum="1033;" x:num="{full}">{shown}</td>'


def html_cells(text: str) -> list[list[Cell]]:
    """Return the cells of the first table in a page; none where it has none."""
    reader = _TableReader()
    try:
        reader.feed(text)
        reader.close()
    except AssertionError:  # so Python's reader says that a declaration is none
        return []
    return [row for row in reader.rows if row]


class _TableReader(HTMLParser):
    """Collects the cells of the first table; tables inside its cells are text of those cells."""

    def __init__(self) -> None:
        super().__init__(convert_charrefs=True)
        self.rows: list[list[Cell]] = []
        self._depth = 0
        self._is_done = False
        self._text: list[str] | None = None
        self._exact: float | None = None

    def handle_starttag(self, tag: str, attributes: list[tuple[str, str | None]]) -> None:
        if self._is_done:
            return
        if tag == "table":
            self._depth += 1
        elif self._depth == 1 and tag == "tr":
            self._end_cell()
            self.rows.append([])
        elif self._depth == 1 and tag in ("td", "th"):
            self._end_cell()
            self._text, self._exact = [], _exact(dict(attributes))

    def handle_endtag(self, tag: str) -> None:
        if self._is_done:
            return
        if tag == "table" and self._depth:
            if self._depth == 1:
                self._end_cell()
                self._is_done = True
            self._depth -= 1
        elif self._depth == 1 and tag in ("td", "th", "tr"):
            self._end_cell()

    def handle_data(self, data: str) -> None:
        if self._text is not None:
            self._text.append(data)

    def close(self) -> None:
        super().close()
        self._end_cell()

    def _end_cell(self) -> None:
        if self._text is None:
            return
        cell: Cell = trimmed("".join(self._text)) if self._exact is None else self._exact
        if not self.rows:
            self.rows.append([])
        self.rows[-1].append(cell)
        self._text = self._exact = None


def _exact(attributes: dict[str, str | None]) -> float | None:
    """Return the number behind a cell where its attributes say it."""
    for name in _EXACT:
        value = typed_number(attributes.get(name) or "")
        if isinstance(value, float):
            return value
    return None
