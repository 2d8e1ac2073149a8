"""The one table of file formats, and the one function that exports."""

from __future__ import annotations

from operator import attrgetter
from pathlib import Path

from qovr_core.document import Document
from qovr_core.errors import SourceError
from qovr_core.evaluation import Evaluation
from qovr_core.files.conventions import USUAL_UP
from qovr_core.files.format import Format
from qovr_core.files.options import DEFAULTS, ExportOptions
from qovr_core.files.progress import Progress, silent
from qovr_core.files.published_layout import MOST_POINTS, TRANSFORMED_DECIMALS
from qovr_core.later import later
from qovr_core.registry import Registry

DOCUMENT_SUFFIX = ".qovr"

FORMATS: Registry[Format] = Registry("format", key=attrgetter("suffix"))
"""All formats by suffix, in the order in which they are offered; the module of one is imported when it is used."""

for _record in (
    Format(
        suffix=".xlsx",
        name="Excel workbook",
        keeps="the published layout, cell for cell; "
        f"transformed coordinates rounded to {TRANSFORMED_DECIMALS} decimals, more where these are too coarse",
        loses=f"the sixteenth digit of the points; more than {MOST_POINTS:,} of them do not fit",
        writer=later("qovr_core.files.workbook_write", "write_workbook"),
        reader=later("qovr_core.files.workbook_read", "read_workbook"),
        check=later("qovr_core.files.workbook_write", "check_workbook_size"),
        suffixes_read=(".xlsm",),
        announce=later("qovr_core.files.workbook_write", "workbook_announcement"),
    ),
    Format(
        suffix=".csv",
        name="CSV table",
        keeps="all points at full precision, inputs, boxes and matrix in NAME.inputs.json beside it",
        loses="the surface between its samples, but for the inputs beside it",
        writer=later("qovr_core.files.csv_table", "write_csv"),
        is_text_table=True,
    ),
    Format(
        suffix=".npz",
        name="NumPy arrays",
        keeps="inputs, points, boxes and matrix at full precision",
        loses="",
        writer=later("qovr_core.files.npz_arrays", "write_npz"),
        reader=later("qovr_core.files.npz_arrays", "read_npz"),
    ),
    Format(
        suffix=".mat",
        name="MATLAB arrays",
        keeps="inputs, points, boxes and matrix at full precision, for MATLAB and Octave",
        loses="",
        writer=later("qovr_core.files.mat_arrays", "write_mat"),
        reader=later("qovr_core.files.mat_arrays", "read_mat"),
    ),
    Format(
        suffix=".step",
        name="STEP AP214",
        keeps="the exact surface, a B-spline face of true degree for each smooth part, in the unit of its numbers",
        loses="nothing of the surface; control net, knots and samples, but for the document as an attribute",
        writer=later("qovr_core.files.step", "write_step"),
        holds_one_layer=True,
        has_unit=True,
        has_parts=True,
        other_suffixes=(".stp",),
    ),
    Format(
        suffix=".iges",
        name="IGES 5.3",
        keeps="the exact surface, a B-spline surface (entity 128) of true degree for each smooth part, in the unit "
        "of its numbers",
        loses="nothing of the surface; control net, knots and samples, but for the document as text",
        writer=later("qovr_core.files.iges", "write_iges"),
        holds_one_layer=True,
        has_unit=True,
        has_parts=True,
        other_suffixes=(".igs",),
    ),
    Format(
        suffix=".3dm",
        name="Rhino model",
        keeps="the exact surface, one of true degree for each smooth part, in the unit of its numbers, control net and "
        "points, the document as user text",
        loses="the samples and the other layer, which the document makes again",
        writer=later("qovr_core.files.rhino", "write_3dm"),
        reader=later("qovr_core.files.rhino", "read_3dm"),
        holds_one_layer=True,
        has_unit=True,
        has_parts=True,
    ),
    Format(
        suffix=".obj",
        name="Wavefront OBJ",
        keeps="triangles at full precision, exact normals",
        loses="the surface between its vertices; colours",
        writer=later("qovr_core.files.obj", "write_obj"),
        holds_one_layer=True,
        is_mesh=True,
        usual_up=USUAL_UP[".obj"],
    ),
    Format(
        suffix=".stl",
        name="STL, binary",
        keeps="triangles in 32 bits; moved to the origin, which the header tells, where they would lose digits",
        loses="the surface between its vertices; shared vertices, normals, colours, the unit",
        writer=later("qovr_core.files.stl", "write_stl"),
        holds_one_layer=True,
        is_mesh=True,
        usual_up=USUAL_UP[".stl"],
    ),
    Format(
        suffix=".ply",
        name="Stanford PLY, binary",
        keeps="triangles at full precision, normals, colours by height",
        loses="the surface between its vertices",
        writer=later("qovr_core.files.ply", "write_ply"),
        holds_one_layer=True,
        is_mesh=True,
        usual_up=USUAL_UP[".ply"],
    ),
    Format(
        suffix=".glb",
        name="glTF 2.0, binary",
        keeps="triangles in 32 bits about their centre, in metres and Y up, normals, colours by height",
        loses="the surface between its vertices; digits beyond the seventh of its size",
        writer=later("qovr_core.files.glb", "write_glb"),
        holds_one_layer=True,
        is_mesh=True,
        has_unit=True,
    ),
    Format(
        suffix=DOCUMENT_SUFFIX,
        name="QOVR document",
        keeps="the document, exactly",
        loses="the points, which the document makes again",
        writer=later("qovr_core.files.qovr_document", "write_qovr"),
        reader=later("qovr_core.files.qovr_document", "read_document"),
    ),
):
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
