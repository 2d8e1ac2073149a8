"""What every file says of where it comes from."""

from __future__ import annotations

import os
from datetime import UTC, datetime
from textwrap import wrap

from qovr_core.checks import described
from qovr_core.errors import DocumentError
from qovr_core.evaluation import Evaluation
from qovr_core.files.options import ExportOptions
from qovr_core.files.qovr_document import document_to_json
from qovr_core.version import VERSION

PROGRAM = f"QOVR Studio {VERSION}"

NO_DATE = datetime(1980, 1, 1)
"""The first day that a ZIP archive can tell, which nobody takes for the day on which a file was made."""

_LONGEST_COMMENT = 900
"""Characters of a line in a mesh; some readers of PLY hold no more than a thousand."""

_EPOCH = "SOURCE_DATE_EPOCH"
"""The variable by which builds that are to be reproduced say what time it is."""


def origin(evaluation: Evaluation, options: ExportOptions) -> str:
    """Return one line of ASCII: program and version, formulation, layer."""
    document = evaluation.document
    return f"{PROGRAM}, formulation {document.formulation}, {options.chosen_layer(document)} surface"


def timestamp() -> datetime | None:
    """Return the time that a file says it was made at, to the second, UTC: that of ``SOURCE_DATE_EPOCH``, else none.

    So the same document always gives the same bytes.

    Raises
    ------
    DocumentError : the variable holds no second that a calendar has
    """
    text = os.environ.get(_EPOCH, "")
    if not text:
        return None
    try:
        return datetime.fromtimestamp(int(text), UTC).replace(tzinfo=None)
    except (ValueError, OverflowError, OSError):
        raise DocumentError(_EPOCH, described(text), "a whole number of seconds since 1970") from None


def timestamp_insisted_on() -> datetime:
    """Return what ``timestamp`` returns, or the date that stands where a format cannot do without one."""
    return timestamp() or NO_DATE


def mesh_comments(evaluation: Evaluation, options: ExportOptions, deviation: float | None) -> list[str]:
    """Return the comment lines of a mesh: its origin, how close it is, and the document's own text."""
    lines = [origin(evaluation, options)]
    if deviation is not None:
        lines.append(f"largest distance from the surface {deviation:.3g}, asked for {options.tolerance:g}")
    text = document_to_json(evaluation.document).splitlines()
    return [*lines, "the document:", *(part for line in text for part in _short(line))]


def _short(line: str) -> list[str]:
    """Return a line of JSON, of which only spaces part the numbers, as lines that every reader holds."""
    return [line] if len(line) <= _LONGEST_COMMENT else wrap(line, _LONGEST_COMMENT, break_long_words=False)
