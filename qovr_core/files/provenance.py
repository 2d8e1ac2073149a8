"""What every file says of where it comes from."""

from __future__ import annotations

from datetime import UTC, datetime

from qovr_core.evaluation import Evaluation
from qovr_core.files.options import ExportOptions
from qovr_core.files.qovr_document import document_to_json
from qovr_core.version import VERSION

PROGRAM = f"QOVR Studio {VERSION}"


def origin(evaluation: Evaluation, options: ExportOptions) -> str:
    """Return one line of ASCII: program and version, formulation, layer."""
    document = evaluation.document
    return f"{PROGRAM}, formulation {document.formulation}, {options.chosen_layer(document)} surface"


def timestamp() -> datetime:
    """Return the time that a file says it was made at, to the second, UTC."""
    return datetime.now(UTC).replace(microsecond=0, tzinfo=None)


def mesh_comments(evaluation: Evaluation, options: ExportOptions, deviation: float | None) -> list[str]:
    """Return the comment lines of a mesh: its origin, how close it is, and the document's own text."""
    lines = [origin(evaluation, options)]
    if deviation is not None:
        lines.append(f"largest distance from the surface {deviation:.3g}, asked for {options.tolerance:g}")
    return [*lines, "the document:", *document_to_json(evaluation.document).splitlines()]
