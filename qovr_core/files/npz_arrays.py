"""``.npz``: every array of a surface under its own name, and the document read back from them."""

from __future__ import annotations

import io
import math
import warnings
import zipfile
from pathlib import Path
from typing import Any

import numpy as np

from qovr_core.document import Document
from qovr_core.evaluation import Evaluation
from qovr_core.files.archive import content, has, opened_archive
from qovr_core.files.array_document import INPUTS, LARGEST_INPUT, NET_INPUTS, document_from_arrays
from qovr_core.files.atomic import replacing
from qovr_core.files.options import DEFAULTS, ExportOptions
from qovr_core.files.progress import Progress
from qovr_core.files.provenance import NO_DATE, PROGRAM
from qovr_core.files.reading import reading
from qovr_core.geometry.knots import Direction


def surface_arrays(evaluation: Evaluation) -> dict[str, Any]:
    """Return the arrays of a surface by their public names.

    Knots are (5, 4), or of a net (curves, windows, 4), in the order r s u t and r s v t. A net of more than one window
    has the windows' lengths besides, which of its joints are smooth, and whether it is closed along u and along v.
    """
    document = evaluation.document
    is_net = not document.is_one_window
    return {
        "control_points": document.control_points,
        "row_knots": document.row_knots.array if is_net else document.row_knots.array[:, 0],
        "column_knots": document.column_knots.array if is_net else document.column_knots.array[:, 0],
        "u": evaluation.u,
        "v": evaluation.v,
        "raw": evaluation.raw,
        "transformed": evaluation.transformed,
        "control_box": evaluation.control_box,
        "raw_box": evaluation.raw_box,
        "matrix": evaluation.matrix,
        "formulation": str(document.formulation),
        "program": PROGRAM,
        **(_of_net(evaluation) if is_net else {}),
    }


def _of_net(evaluation: Evaluation) -> dict[str, Any]:
    document = evaluation.document
    lengths_u, lengths_v = (np.diff(breakpoints) for breakpoints in evaluation.patch.breakpoints)
    smooth_u, smooth_v = (document.joints.smooth(direction) for direction in Direction)
    return {
        "lengths_u": lengths_u,
        "lengths_v": lengths_v,
        "smooth_u": smooth_u,
        "smooth_v": smooth_v,
        "closed": np.array([document.is_closed(direction) for direction in Direction]),
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
    with reading(path, "is no whole NumPy archive:") as file, opened_archive(file) as archive:
        arrays = {name: _array(archive, name) for name in (*INPUTS, *NET_INPUTS) if has(archive, f"{name}.npy")}
    return document_from_arrays(arrays, path)


def _array(archive: zipfile.ZipFile, name: str) -> np.ndarray:
    """Return an array of an input; what its header promises is believed only where that many bytes are there."""
    stored = content(archive, f"{name}.npy", LARGEST_INPUT)
    file = io.BytesIO(stored)
    version = np.lib.format.read_magic(file)
    if version not in _HEADERS:
        raise ValueError(f"{name} is of version {version}")
    with warnings.catch_warnings(action="ignore"):  # a damaged header may look like one of an older NumPy
        shape, is_fortran, dtype = _HEADERS[version](file)
    if dtype.hasobject:
        raise ValueError("Object arrays cannot be loaded")
    values = stored[file.tell() :]
    if min(shape, default=0) < 0 or math.prod(shape) * dtype.itemsize != len(values):
        raise ValueError(f"{name} holds {len(values):,} bytes, other than its shape says")
    return np.frombuffer(values, dtype).reshape(shape, order="F" if is_fortran else "C")


_HEADERS = {
    (1, 0): np.lib.format.read_array_header_1_0,
    (2, 0): np.lib.format.read_array_header_2_0,
}
