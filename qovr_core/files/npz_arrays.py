"""``.npz``: every array of a surface under its own name, and the document read back from them."""

from __future__ import annotations

import zipfile
from pathlib import Path
from typing import Any

import numpy as np

from qovr_core.document import Document
from qovr_core.errors import FileError
from qovr_core.evaluation import Evaluation
from qovr_core.files.array_document import INPUTS, LARGEST_INPUT, document_from_arrays
from qovr_core.files.atomic import replacing
from qovr_core.files.format import Format
from qovr_core.files.options import DEFAULTS, ExportOptions
from qovr_core.files.progress import Progress
from qovr_core.files.provenance import NO_DATE, PROGRAM
from qovr_core.geometry.knots import knot_array


def surface_arrays(evaluation: Evaluation) -> dict[str, Any]:
    """Return the arrays of a surface by their public names; knots (5, 4) in the order r s u t and r s v t."""
    document = evaluation.document
    return {
        "control_points": document.control_points,
        "row_knots": knot_array(document.row_knots),
        "column_knots": knot_array(document.column_knots),
        "u": evaluation.u,
        "v": evaluation.v,
        "raw": evaluation.raw,
        "transformed": evaluation.transformed,
        "control_box": evaluation.control_box,
        "raw_box": evaluation.raw_box,
        "matrix": evaluation.matrix,
        "formulation": str(document.formulation),
        "program": PROGRAM,
    }


def write_npz(evaluation: Evaluation, path: Path, progress: Progress, _options: ExportOptions = DEFAULTS) -> None:
    """Write all arrays of a surface, whole or not at all.

    Raises
    ------
    FileError : the file cannot be written
    """
    arrays = surface_arrays(evaluation)
    with replacing(path) as (draft,), zipfile.ZipFile(draft, "w") as archive:
        for done, (name, array) in enumerate(arrays.items(), 1):
            entry = zipfile.ZipInfo(f"{name}.npy", NO_DATE.timetuple()[:6])
            with archive.open(entry, "w", force_zip64=True) as member:
                np.lib.format.write_array(member, np.asanyarray(array), allow_pickle=False)
            progress(done / len(arrays))


def read_npz(path: Path) -> Document:
    """Return the document whose inputs an ``.npz`` file of this program holds, to the last bit.

    Raises
    ------
    FileError : the file cannot be read, is no NumPy archive, or an array holds anything but what belongs there
    """
    try:
        with zipfile.ZipFile(path) as archive:
            arrays = {name: _member(archive, name) for name in INPUTS if f"{name}.npy" in archive.namelist()}
    except OSError as error:
        raise FileError(f"{path}: cannot be read: {error.strerror or error}") from error
    except Exception as error:  # a damaged archive fails in as many ways as there are decoders
        reason = " ".join(str(error).split()) or type(error).__name__
        raise FileError(f"{path}: is no whole NumPy archive: {reason}") from error
    return document_from_arrays(arrays, path)


NPZ = Format(
    suffix=".npz",
    name="NumPy arrays",
    keeps="inputs, points, boxes and matrix at full precision",
    loses="",
    writer=write_npz,
    reader=read_npz,
)


def _member(archive: zipfile.ZipFile, name: str) -> Any:
    info = archive.getinfo(f"{name}.npy")
    if info.file_size > LARGEST_INPUT:
        raise ValueError(f"{name} is {info.file_size:,} bytes long; expected at most {LARGEST_INPUT:,}")
    with archive.open(info) as member:
        return np.lib.format.read_array(member, allow_pickle=False)
