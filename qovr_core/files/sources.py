"""Reading a document from wherever the user points."""

from __future__ import annotations

import os
import re
from pathlib import Path
from urllib.parse import unquote_to_bytes

from qovr_core.document import Document
from qovr_core.errors import SourceError
from qovr_core.files.formats import DOCUMENT_SUFFIX, FORMATS
from qovr_core.files.reading import check_readable
from qovr_core.presets import preset
from qovr_core.shapes import shape

PRESET_PREFIX = "paper:"

SHAPE_PREFIX = "shape:"

MADE_HERE = (PRESET_PREFIX, SHAPE_PREFIX)
"""What sources that are no files begin with."""

_ADDRESS = re.compile(r"file:(?://(?P<host>[^/]*))?(?=/)", re.IGNORECASE)


def readable_suffixes() -> tuple[str, ...]:
    """Return the suffixes of the files that carry a whole document, the document's own first."""
    readable = [suffix for suffix, entry in FORMATS.items() if entry.reader is not None]
    return tuple(sorted(readable, key=lambda suffix: suffix != DOCUMENT_SUFFIX))


def source_suffixes() -> tuple[str, ...]:
    """Return the suffixes of all files that can be opened: the readable ones, and what is only read."""
    readable = [FORMATS[suffix] for suffix in readable_suffixes()]
    return (
        *readable_suffixes(),
        *(other for entry in readable for other in (*entry.other_suffixes, *entry.suffixes_read)),
    )


def local_path(source: str) -> str:
    """Return the path that a ``file://`` address means; any other source as it is.

    In an address, ``%20`` stands for a space; ``#``, ``?`` and ``&`` are letters of the name, written out or not.

    Raises
    ------
    SourceError : the address is one on another machine

    Examples
    --------
    >>> local_path("file:///home/me/a%20b&c%23.qovr"), local_path("a%20b.qovr")
    ('/home/me/a b&c#.qovr', 'a%20b.qovr')
    """
    found = _ADDRESS.match(source)
    if found is None or os.path.lexists(source):
        return source
    host = (found["host"] or "").lower()
    if host not in ("", "localhost"):
        raise SourceError(f"{source}: is an address on {host}; expected a file of this machine, as file:///folder/name")
    path = source[found.end() :]
    if os.name != "nt":
        return os.fsdecode(unquote_to_bytes(os.fsencode(path)))
    from urllib.request import url2pathname

    return url2pathname(path)


def read_source(source: str) -> Document:
    """Return the document of a file that carries one, of ``paper:NAME`` or of ``shape:NAME``.

    Raises
    ------
    SourceError : there is no such preset or shape, or the file is of another kind
    FileError : the file cannot be read or does not hold a valid document
    """
    if source.startswith(PRESET_PREFIX):
        return preset(source.removeprefix(PRESET_PREFIX)).document
    if source.startswith(SHAPE_PREFIX):
        return shape(source.removeprefix(SHAPE_PREFIX)).document()
    path = Path(local_path(source))
    suffix = path.suffix.lower()
    for entry in FORMATS.values():
        if entry.reader is not None and suffix in (entry.suffix, *entry.other_suffixes, *entry.suffixes_read):
            check_readable(path)
            return entry.reader(path)
    expected = f"a file of {', '.join(source_suffixes())}, {PRESET_PREFIX}NAME or {SHAPE_PREFIX}NAME"
    raise SourceError(f"{source or 'an empty name'}: is no source; expected {expected}")
