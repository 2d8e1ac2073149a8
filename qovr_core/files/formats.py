"""The one table of export formats."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from qovr_core.document import Document
from qovr_core.errors import SourceError
from qovr_core.evaluation import Evaluation
from qovr_core.files.csv_table import write_csv
from qovr_core.files.glb import write_glb
from qovr_core.files.iges import write_iges
from qovr_core.files.mat_arrays import write_mat
from qovr_core.files.npz_arrays import write_npz
from qovr_core.files.obj import write_obj
from qovr_core.files.options import DEFAULTS, ExportOptions
from qovr_core.files.ply import write_ply
from qovr_core.files.progress import Progress, silent
from qovr_core.files.qovr_document import write_document
from qovr_core.files.rhino import write_3dm
from qovr_core.files.step import write_step
from qovr_core.files.stl import write_stl
from qovr_core.files.workbook_write import check_workbook_size, workbook_announcement, write_workbook

Writer = Callable[[Evaluation, Path, Progress, ExportOptions], None]


def _any_size(_document: Document, _path: Path) -> None:
    """Accept every document."""


def _nothing_to_say(_document: Document) -> str:
    """Announce nothing."""
    return ""


def _write_document(evaluation: Evaluation, path: Path, progress: Progress) -> None:
    write_document(evaluation.document, path)
    progress(1.0)


def _of_everything(write: Callable[[Evaluation, Path, Progress], None]) -> Writer:
    """Return the writer of a format that holds both layers, and so has nothing to choose."""
    return lambda surface, path, progress, _options: write(surface, path, progress)


@dataclass(frozen=True)
class Format:
    """One way out.

    Parameters
    ----------
    suffix : of the file, with its dot
    name : what people call it
    keeps : what it holds, in one line
    loses : what it cannot hold, in one line; empty where it loses nothing
    writer : writes a surface to a path, whole or not at all, telling its progress
    check : refuses, before any work, a document that the format cannot hold
    holds_one_layer : whether ``ExportOptions.layer`` decides what is written
    is_mesh : whether ``ExportOptions.tolerance`` decides how fine
    announce : says of a document, before the work, how long and how large it will be; empty where that is little
    """

    suffix: str
    name: str
    keeps: str
    loses: str
    writer: Writer
    check: Callable[[Document, Path], None] = _any_size
    holds_one_layer: bool = False
    is_mesh: bool = False
    announce: Callable[[Document], str] = _nothing_to_say

    def write(self, evaluation: Evaluation, path: Path, progress: Progress, options: ExportOptions = DEFAULTS) -> None:
        """Write a surface to a path, whole or not at all; ``progress`` rises to 1, and what it raises cancels.

        Raises
        ------
        FileError : the format cannot hold the surface, or the file cannot be written
        """
        self.writer(evaluation, path, progress, options)


def _cad(suffix: str, name: str, keeps: str, loses: str, writer: Writer) -> Format:
    return Format(suffix, name, keeps, loses, writer, holds_one_layer=True)


def _mesh(suffix: str, name: str, keeps: str, loses: str, writer: Writer) -> Format:
    return Format(suffix, name, keeps, loses, writer, holds_one_layer=True, is_mesh=True)


_TABLE = (
    Format(
        ".xlsx",
        "Excel workbook",
        "the published layout, cell for cell; transformed coordinates rounded to 5 decimals",
        "the sixteenth digit of the points; more than 1,048,572 of them do not fit",
        _of_everything(write_workbook),
        check_workbook_size,
        announce=workbook_announcement,
    ),
    Format(
        ".csv",
        "CSV table",
        "all points at full precision, inputs, boxes and matrix in NAME.inputs.json beside it",
        "the surface between its samples, but for the inputs beside it",
        _of_everything(write_csv),
    ),
    Format(".npz", "NumPy arrays", "inputs, points, boxes and matrix at full precision", "", _of_everything(write_npz)),
    Format(
        ".mat",
        "MATLAB arrays",
        "inputs, points, boxes and matrix at full precision, for MATLAB and Octave",
        "",
        _of_everything(write_mat),
    ),
    _cad(
        ".step",
        "STEP AP214",
        "the exact surface, one B-spline face of its true degree, in millimetres",
        "nothing of the surface; control net, knots and samples, but for the document as an attribute",
        write_step,
    ),
    _cad(
        ".iges",
        "IGES 5.3",
        "the exact surface, one B-spline surface (entity 128) of its true degree, in millimetres",
        "nothing of the surface; control net, knots and samples, but for the document as text",
        write_iges,
    ),
    _cad(
        ".3dm",
        "Rhino model",
        "the exact surface of its true degree in millimetres, control net and points, the document as user text",
        "the samples and the other layer, which the document makes again",
        write_3dm,
    ),
    _mesh(
        ".obj",
        "Wavefront OBJ",
        "triangles at full precision, exact normals",
        "the surface between its vertices; colours",
        write_obj,
    ),
    _mesh(
        ".stl",
        "STL, binary",
        "triangles in 32 bits; moved to the origin, which the header tells, where they would lose digits",
        "the surface between its vertices; shared vertices, normals, colours, the unit",
        write_stl,
    ),
    _mesh(
        ".ply",
        "Stanford PLY, binary",
        "triangles at full precision, normals, colours by height",
        "the surface between its vertices",
        write_ply,
    ),
    _mesh(
        ".glb",
        "glTF 2.0, binary",
        "triangles in 32 bits about their centre, in metres and Y up, normals, colours by height",
        "the surface between its vertices; digits beyond the seventh of its size",
        write_glb,
    ),
    Format(
        ".qovr",
        "QOVR document",
        "the document, exactly",
        "the points, which the document makes again",
        _of_everything(_write_document),
    ),
)

FORMATS = {entry.suffix: entry for entry in _TABLE}


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


def export(
    document: Document, path: Path, options: ExportOptions = DEFAULTS, progress: Callable[[float], None] = silent
) -> None:
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
    entry = format_for(path)
    entry.check(document, path)
    evaluation = Evaluation(document)
    progress(0.0)
    entry.write(evaluation, path, progress, options)
