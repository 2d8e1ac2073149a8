"""The one table of file formats, and the one function that exports."""

from __future__ import annotations

from operator import attrgetter
from pathlib import Path

from qovr_core.document import Document
from qovr_core.errors import SourceError
from qovr_core.evaluation import Evaluation
from qovr_core.files.csv_table import CSV
from qovr_core.files.format import Format
from qovr_core.files.glb import GLB
from qovr_core.files.iges import IGES
from qovr_core.files.mat_arrays import MAT
from qovr_core.files.npz_arrays import NPZ
from qovr_core.files.obj import OBJ
from qovr_core.files.options import DEFAULTS, ExportOptions
from qovr_core.files.ply import PLY
from qovr_core.files.progress import Progress, silent
from qovr_core.files.qovr_document import QOVR
from qovr_core.files.rhino import RHINO
from qovr_core.files.step import STEP
from qovr_core.files.stl import STL
from qovr_core.files.workbook_write import WORKBOOK
from qovr_core.registry import Registry

FORMATS: Registry[Format] = Registry("format", key=attrgetter("suffix"))
"""All formats by suffix, in the order in which they are offered."""

for _record in (WORKBOOK, CSV, NPZ, MAT, STEP, IGES, RHINO, OBJ, STL, PLY, GLB, QOVR):
    FORMATS.register(_record)
FORMATS.seal()


def find_format(path: Path) -> Format | None:
    """Return the format whose suffix, or another name of it, a path ends in; None where there is none."""
    suffix = path.suffix.lower()
    others = (entry for entry in FORMATS.values() if suffix in entry.other_suffixes)
    return FORMATS.get(suffix) or next(others, None)


def format_for(path: Path) -> Format:
    """Return the format in which a path is written.

    Raises
    ------
    SourceError : no format has this suffix, or it is that of files which are only read
    """
    if found := find_format(path):
        return found
    for entry in FORMATS.values():
        if path.suffix.lower() in entry.suffixes_read:
            raise SourceError(f"{path}: '{path.suffix}' is only read, not written; expected {entry.suffix}")
    suffix = f"the suffix '{path.suffix}'" if path.suffix else "no suffix"
    raise SourceError(f"{path}: has {suffix}; expected one of {', '.join(FORMATS)}")


def export(document: Document, path: Path, options: ExportOptions = DEFAULTS, progress: Progress = silent) -> None:
    """Evaluate a document and write it in the format that the path's suffix names, whole or not at all.

    Parameters
    ----------
    progress : told the part done, rising from 0, when the surface is known, to 1; what it raises cancels

    Raises
    ------
    EvaluationError : the document has no finite surface
    FileError : the format cannot hold the surface, or the file cannot be written
    SourceError : no format has this suffix
    """
    target = format_for(path)
    target.check(document, path)
    evaluation = Evaluation(document)
    progress(0.0)
    target.write(evaluation, path, progress, options)
