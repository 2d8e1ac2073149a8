"""Reading a document from wherever the user points."""

from __future__ import annotations

from pathlib import Path

from qovr_core.document import Document
from qovr_core.errors import SourceError
from qovr_core.files.formats import FORMATS
from qovr_core.files.qovr_document import QOVR
from qovr_core.files.reading import check_readable
from qovr_core.presets import preset

PRESET_PREFIX = "paper:"


def readable_suffixes() -> tuple[str, ...]:
    """Return the suffixes of the files that carry a whole document, the document's own first."""
    readable = [suffix for suffix, entry in FORMATS.items() if entry.reader is not None]
    return tuple(sorted(readable, key=lambda suffix: suffix != QOVR.suffix))


def source_suffixes() -> tuple[str, ...]:
    """Return the suffixes of all files that can be opened: the readable ones, and what is only read."""
    readable = [FORMATS[suffix] for suffix in readable_suffixes()]
    return (*readable_suffixes(), *(suffix for entry in readable for suffix in entry.suffixes_read))


def read_source(source: str) -> Document:
    """Return the document of a file that carries one, or of ``paper:NAME``.

    Raises
    ------
    SourceError : there is no such preset, or the file is of another kind
    FileError : the file cannot be read or does not hold a valid document
    """
    if source.startswith(PRESET_PREFIX):
        return preset(source.removeprefix(PRESET_PREFIX)).document
    path = Path(source)
    suffix = path.suffix.lower()
    for entry in FORMATS.values():
        if entry.reader is not None and suffix in (entry.suffix, *entry.other_suffixes, *entry.suffixes_read):
            check_readable(path)
            return entry.reader(path)
    expected = f"a file of {', '.join(readable_suffixes())}, or {PRESET_PREFIX}NAME"
    raise SourceError(f"{source or 'an empty name'}: is no source; expected {expected}")
