"""What a workbook is packed of: its sheets by name, and the texts that its cells share."""

from __future__ import annotations

import posixpath
import zipfile
from collections.abc import Collection
from dataclasses import dataclass

from qovr_core.files import archive as zipped
from qovr_core.files.xml_stream import XmlStream, read_elements

LARGEST_SHEET = 2_500_000_000
"""Bytes unpacked; a sheet's million rows of thirty numbers each take less."""

_LARGEST_INDEX = 10_000_000
_LONGEST_TEXT = 1_000_000


@dataclass(frozen=True)
class SheetPart:
    """A worksheet: what it is called, and the member of the archive that holds its cells."""

    name: str
    member: str


def sheet_parts(archive: zipfile.ZipFile) -> list[SheetPart]:
    """Return the worksheets of a workbook in their order.

    Raises
    ------
    ValueError, expat.ExpatError, zipfile.BadZipFile : it is no workbook, or it is damaged
    """
    book = next((target for kind, target in _relations(archive, "").values() if kind == "officeDocument"), "")
    related = _relations(archive, book)
    parts: list[SheetPart] = []

    def on_start(name: str, attributes: dict[str, str]) -> None:
        if name == "sheet":
            key = next((value for key, value in attributes.items() if key.endswith(":id")), "")
            kind, target = related.get(key, ("", ""))
            if kind == "worksheet":
                parts.append(SheetPart(attributes.get("name", ""), target))

    read_elements(zipped.blocks(archive, book, _LARGEST_INDEX), on_start)
    if not parts:
        raise ValueError("it has no sheet")
    return parts


def shared_texts(archive: zipfile.ZipFile, wanted: Collection[int]) -> dict[int, str]:
    """Return those of the shared texts that are wanted, by their number; raises as ``sheet_parts`` does."""
    if not wanted:
        return {}
    book = next((target for kind, target in _relations(archive, "").values() if kind == "officeDocument"), "")
    table = next((target for kind, target in _relations(archive, book).values() if kind == "sharedStrings"), "")
    texts = _SharedTexts(wanted)
    stream = XmlStream(texts)
    for block in zipped.blocks(archive, table, LARGEST_SHEET):
        stream.feed(block)
        if texts.number > max(wanted):
            break
    return {number: "".join(parts) for number, parts in texts.found.items()}


class _SharedTexts:
    """Keeps the texts of some numbers; pronunciations beside them are no part of them."""

    def __init__(self, wanted: Collection[int]) -> None:
        self.number = -1
        self.found: dict[int, list[str]] = {number: [] for number in wanted}
        self._length = 0
        self._is_text = self._is_spoken = False

    def start(self, name: str, _attributes: dict[str, str]) -> None:
        self.number += name == "si"
        self._is_spoken |= name == "rPh"
        self._is_text = name == "t"

    def text(self, text: str) -> None:
        if self._is_text and not self._is_spoken and self.number in self.found:
            self._length += len(text)
            if self._length > _LONGEST_TEXT:
                raise ValueError(f"its texts are longer than {_LONGEST_TEXT:,} characters")
            self.found[self.number].append(text)

    def end(self, name: str) -> None:
        self._is_text = False
        self._is_spoken &= name != "rPh"


def _relations(archive: zipfile.ZipFile, part: str) -> dict[str, tuple[str, str]]:
    """Return what a part refers to: by its key there the kind, and the member of the archive."""
    folder, name = posixpath.split(part)
    found: dict[str, tuple[str, str]] = {}

    def on_start(element: str, attributes: dict[str, str]) -> None:
        if element == "Relationship":
            target = posixpath.normpath(posixpath.join("/", folder, attributes.get("Target", "")))
            kind = attributes.get("Type", "").rpartition("/")[2]
            found[attributes.get("Id", "")] = kind, target.lstrip("/")

    read_elements(zipped.blocks(archive, posixpath.join(folder, "_rels", f"{name}.rels"), _LARGEST_INDEX), on_start)
    return found
