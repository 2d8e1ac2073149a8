"""Writing ``.csv``: one row a point, with the inputs in a JSON file beside it."""

from __future__ import annotations

import csv
import json
from collections.abc import Iterable
from pathlib import Path

import numpy as np

from qovr_core.evaluation import Evaluation
from qovr_core.files.atomic import replacing
from qovr_core.files.conventions import CsvDialect
from qovr_core.files.options import DEFAULTS, ExportOptions
from qovr_core.files.progress import Progress
from qovr_core.files.provenance import PROGRAM
from qovr_core.files.qovr_document import document_to_json

HEADER = ("i", "j", "u", "v", "raw_x", "raw_y", "raw_z", "transformed_x", "transformed_y", "transformed_z")


def inputs_path(path: Path) -> Path:
    """Return the path of the file beside a ``.csv`` that holds inputs, boxes and matrix."""
    return path.with_suffix(".inputs.json")


def write_csv(evaluation: Evaluation, path: Path, progress: Progress, options: ExportOptions = DEFAULTS) -> None:
    """Write all points at full precision, u-major, and the inputs beside them; both files or neither.

    Raises
    ------
    FileError : a file cannot be written
    """
    with replacing(path, inputs_path(path)) as (points, inputs):
        inputs.write_text(_inputs_text(evaluation), encoding="utf-8", newline="\n")
        with points.open("w", encoding="utf-8", newline="") as file:
            table = csv.writer(file, delimiter=options.csv_dialect.separator, lineterminator="\n")
            table.writerow(HEADER)
            j, v = list(range(len(evaluation.v))), evaluation.v.tolist()
            for i, u in enumerate(evaluation.u.tolist()):
                coordinates = np.hstack([evaluation.raw[i], evaluation.transformed[i]]).tolist()
                rows = ((i, j[k], u, v[k], *row) for k, row in enumerate(coordinates))
                table.writerows(_spelt(rows, options.csv_dialect))
                progress((i + 1) / len(evaluation.u))


def _spelt(rows: Iterable[tuple[float, ...]], dialect: CsvDialect) -> Iterable[tuple[float | str, ...]]:
    """Return rows with their numbers spelt as a dialect has it; shortest decimals that read back either way."""
    if dialect.decimal_sign == ".":
        return rows
    return (tuple(repr(value).replace(".", dialect.decimal_sign) for value in row) for row in rows)


def _inputs_text(evaluation: Evaluation) -> str:
    content = {
        "program": PROGRAM,
        "document": json.loads(document_to_json(evaluation.document)),
        "control_box": evaluation.control_box.tolist(),
        "raw_box": evaluation.raw_box.tolist(),
        "matrix": evaluation.matrix.tolist(),
        "flat_axes": list(evaluation.flat_axes),
    }
    return json.dumps(content, indent=2) + "\n"
