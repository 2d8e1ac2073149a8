"""Reading XML as it comes, in memory that no content can make grow: only what a handler keeps stays."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Protocol
from xml.parsers import expat

_MOST_PENDING = 4_000_000
"""Bytes; a longer tag, comment or attribute is refused. Those of workbooks are some hundred bytes long."""

_MOST_NAMES, _MOST_LEVELS = 10_000, 200
"""Names of tags and attributes, which the parser keeps, and tags inside one another. Workbooks have far fewer."""


class Handler(Protocol):
    """What is told of the elements, by their names without prefix."""

    def start(self, name: str, attributes: dict[str, str]) -> None:
        """An element begins."""

    def text(self, text: str) -> None:
        """A part of the text between two tags comes."""

    def end(self, name: str) -> None:
        """An element ends."""


class XmlStream:
    """A parser that is fed block by block.

    Parameters
    ----------
    handler : told of what comes; what it raises ends the reading
    """

    def __init__(self, handler: Handler) -> None:
        self._names: dict[str, str] = {}
        self._level = 0
        self._fed = 0
        self._handler = handler
        self._parser = expat.ParserCreate(intern=self._names)
        self._parser.buffer_text = True
        self._parser.StartElementHandler = self._start
        self._parser.EndElementHandler = self._end
        self._parser.CharacterDataHandler = handler.text
        self._parser.StartDoctypeDeclHandler = _refuse_doctype

    def feed(self, block: bytes) -> None:
        """Take the next part of the document.

        Raises
        ------
        ValueError : it is larger in some way than what workbooks hold, or declares entities
        expat.ExpatError : it is no XML
        """
        self._parser.Parse(block)
        self._fed += len(block)
        if self._fed - max(self._parser.CurrentByteIndex, 0) > _MOST_PENDING:
            raise ValueError(f"its XML has a tag of more than {_MOST_PENDING:,} bytes")
        if len(self._names) > _MOST_NAMES:
            raise ValueError(f"its XML has more than {_MOST_NAMES:,} names of tags")

    def close(self) -> None:
        """Say that all has come; raises ExpatError where something is missing."""
        self._parser.Parse(b"", True)

    def _start(self, name: str, attributes: dict[str, str]) -> None:
        self._level += 1
        if self._level > _MOST_LEVELS:
            raise ValueError(f"its XML has more than {_MOST_LEVELS} tags inside one another")
        self._handler.start(_local(name), attributes)

    def _end(self, name: str) -> None:
        self._level -= 1
        self._handler.end(_local(name))


def read_elements(blocks: Iterable[bytes], on_start: Callable[[str, dict[str, str]], None]) -> None:
    """Tell of each element of a whole document as it begins.

    Raises
    ------
    ValueError, expat.ExpatError : as ``XmlStream`` does
    """
    stream = XmlStream(_Starts(on_start))
    for block in blocks:
        stream.feed(block)
    stream.close()


class _Starts:
    def __init__(self, on_start: Callable[[str, dict[str, str]], None]) -> None:
        self.start = on_start

    def text(self, text: str) -> None:
        """Nobody asks for it."""

    def end(self, name: str) -> None:
        """Nobody asks for it."""


def _local(name: str) -> str:
    return name.rpartition(":")[2]


def _refuse_doctype(*_declaration: object) -> None:
    raise ValueError("its XML declares entities; expected none, as in every workbook")
