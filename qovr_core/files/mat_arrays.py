"""``.mat`` (MATLAB 5): the arrays of ``.npz`` under the same names, and the document read back from them."""

from __future__ import annotations

from pathlib import Path

from qovr_core.document import Document
from qovr_core.evaluation import Evaluation
from qovr_core.files.array_document import INPUTS, NET_INPUTS, document_from_arrays
from qovr_core.files.atomic import replacing
from qovr_core.files.mat_read import read_arrays
from qovr_core.files.npz_arrays import surface_arrays
from qovr_core.files.options import DEFAULTS, ExportOptions
from qovr_core.files.progress import Progress
from qovr_core.files.provenance import PROGRAM, timestamp
from qovr_core.files.reading import reading

_TEXT_BYTES = 116
"""A header begins with so much text for people; version and byte order follow."""


def write_mat(evaluation: Evaluation, path: Path, progress: Progress, _options: ExportOptions = DEFAULTS) -> None:
    """Write all arrays of a surface, whole or not at all; ``u`` and ``v`` are columns, texts are char rows.

    Raises
    ------
    FileError : the file cannot be written
    """
    from scipy.io import savemat

    arrays = surface_arrays(evaluation)
    with replacing(path) as (draft,), draft.open("wb") as file:
        for done, (name, array) in enumerate(arrays.items(), 1):
            savemat(file, {name: array}, oned_as="column")
            progress(done / len(arrays))
        file.seek(0)
        file.write(_header())


def _header() -> bytes:
    """Return the header's text, which tells neither the system nor, unless it is given, the time."""
    made = timestamp()
    text = f"MATLAB 5.0 MAT-file, written by {PROGRAM}" + (f", created on {made.isoformat()}" if made else "")
    return text.encode("ascii").ljust(_TEXT_BYTES)


def read_mat(path: Path) -> Document:
    """Return the document whose inputs a ``.mat`` file of this program holds, to the last bit.

    Raises
    ------
    FileError : the file cannot be read, is no MATLAB file of version 5 to 7, or an array holds anything but what
        belongs there
    """
    with reading(path, "cannot be read:") as file:
        arrays = read_arrays(file, (*INPUTS, *NET_INPUTS))
    return document_from_arrays(arrays, path)
