"""Reading a document from wherever the user points."""

from __future__ import annotations

from pathlib import Path

from qovr_core.document import Document
from qovr_core.errors import SourceError
from qovr_core.files.mat_arrays import read_mat
from qovr_core.files.npz_arrays import read_npz
from qovr_core.files.qovr_document import read_document
from qovr_core.files.rhino import read_3dm
from qovr_core.files.workbook_read import read_workbook
from qovr_core.presets import preset

PRESET_PREFIX = "paper:"

READERS = {
    ".qovr": read_document,
    ".xlsx": read_workbook,
    ".npz": read_npz,
    ".mat": read_mat,
    ".3dm": read_3dm,
}
"""The files that carry a whole document."""


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
    try:
        reader = READERS[path.suffix.lower()]
    except KeyError:
        raise SourceError(
            f"{source}: is no source; expected a file of {', '.join(READERS)}, or {PRESET_PREFIX}NAME"
        ) from None
    return reader(path)
