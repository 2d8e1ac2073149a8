"""The one table of export formats."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from qovr_core.document import Document
from qovr_core.errors import SourceError
from qovr_core.files.csv_table import write_csv
from qovr_core.files.npz_arrays import write_npz
from qovr_core.files.progress import Progress
from qovr_core.files.qovr_document import write_document
from qovr_core.files.workbook_write import check_workbook_size, write_workbook
from qovr_core.pipeline import Surface


def _any_size(_document: Document, _path: Path) -> None:
    """Accept every document."""


def _write_document(surface: Surface, path: Path, progress: Progress) -> None:
    write_document(surface.document, path)
    progress(1.0)


@dataclass(frozen=True)
class Format:
    """One way out.

    Parameters
    ----------
    suffix : of the file, with its dot
    name : what people call it
    keeps : what it holds, in one line
    write : writes a surface to a path, whole or not at all, telling its progress
    check : refuses, before any work, a document that the format cannot hold
    """

    suffix: str
    name: str
    keeps: str
    write: Callable[[Surface, Path, Progress], None]
    check: Callable[[Document, Path], None] = _any_size


FORMATS = {
    entry.suffix: entry
    for entry in (
        Format(
            ".xlsx",
            "Excel workbook",
            "the published layout, cell for cell; transformed coordinates rounded to 5 decimals",
            write_workbook,
            check_workbook_size,
        ),
        Format(
            ".csv",
            "CSV table",
            "all points at full precision, inputs, boxes and matrix in NAME.inputs.json beside it",
            write_csv,
        ),
        Format(".npz", "NumPy arrays", "inputs, points, boxes and matrix at full precision", write_npz),
        Format(".qovr", "QOVR document", "the document, exactly; no points", _write_document),
    )
}


def format_for(path: Path) -> Format:
    """Return the format that a path's suffix names.

    Raises
    ------
    SourceError : no format has this suffix
    """
    try:
        return FORMATS[path.suffix.lower()]
    except KeyError:
        suffix = f"the suffix '{path.suffix}'" if path.suffix else "no suffix"
        raise SourceError(f"{path}: has {suffix}; expected one of {', '.join(FORMATS)}") from None
