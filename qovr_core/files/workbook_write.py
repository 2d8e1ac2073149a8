"""Writing ``.xlsx`` in the published layout, cell for cell."""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import zip_longest
from math import prod
from pathlib import Path
from typing import Any

import numpy as np

from qovr_core.checks import LARGEST_MAGNITUDE
from qovr_core.document import Document
from qovr_core.errors import FileError
from qovr_core.evaluation import Evaluation
from qovr_core.files import published_layout as layout
from qovr_core.files.atomic import LOGGER, replacing, unwritable
from qovr_core.files.drafts import scratch_folder
from qovr_core.files.options import DEFAULTS, ExportOptions
from qovr_core.files.progress import Progress
from qovr_core.files.provenance import PROGRAM, timestamp_insisted_on
from qovr_core.files.qovr_document import document_to_json

LARGE_WORKBOOK = 100_000
"""Points beyond which people want to know beforehand what they wait for."""

_SECONDS_A_POINT = 5e-5
_BYTES_A_POINT = 75
"""Both as measured with 250,000 points on a desktop's processor."""

_ROWS_A_REPORT = 1024

_FEWEST_STEPS = 1000
"""An axis on which the layout's decimals make fewer steps is written with more of them..."""

_FINER_DIGITS = 6
"""...with so many digits of the axis's size after its first."""

_MOST_DECIMALS = 300
"""Beyond, the unit of a decimal is no number in double precision."""

Cells = list[tuple[int, Any]]
"""What stands in one row: pairs of zero-based column and value."""


def check_workbook_size(document: Document, path: Path) -> None:
    """Refuse, before any work, a net that the layout has no place for, and more points than a sheet has rows.

    Raises
    ------
    FileError : the net has more windows than one, or a sheet cannot hold the samples
    """
    if not document.is_one_window:
        windows_v, windows_u = document.windows
        raise FileError(
            f"{path}: the published layout holds a net of 5 x 5 points, and this one has {windows_v} x {windows_u} "
            f"windows; expected one of them, --window 0,0 to {windows_v - 1},{windows_u - 1}"
        )
    n, m = document.samples
    if n * m > layout.MOST_POINTS:
        raise FileError(
            f"{path}: {n} x {m} samples are {n * m:,} points; "
            f"expected at most {layout.MOST_POINTS:,}, the rows of one sheet"
        )


def workbook_announcement(document: Document) -> str:
    """Return how long and how large a large workbook will be, in words; empty for one that is soon done."""
    points = prod(document.samples)
    if points <= LARGE_WORKBOOK:
        return ""
    seconds, megabytes = points * _SECONDS_A_POINT, points * _BYTES_A_POINT / 1e6
    return f"{points:,} points will take about {seconds:.0f} s and {megabytes:.0f} MB"


def transformed_decimals(evaluation: Evaluation) -> tuple[int, ...]:
    """Return with how many decimals the transformed coordinates are written on each axis.

    The published layout's where they part an axis finely enough, else more.
    """
    decimals = []
    for low, high in evaluation.control_box.tolist():
        size = high - low or abs(high)
        is_fine = size == 0 or size >= _FEWEST_STEPS * 10.0**-layout.TRANSFORMED_DECIMALS
        decimals.append(layout.TRANSFORMED_DECIMALS if is_fine else _FINER_DIGITS - math.floor(math.log10(size)))
    return tuple(decimals)


def write_workbook(evaluation: Evaluation, path: Path, progress: Progress, _options: ExportOptions = DEFAULTS) -> None:
    """Write a surface in the published layout, whole or not at all.

    Raises
    ------
    FileError : the sheet has too few rows, or the file cannot be written
    """
    from xlsxwriter.exceptions import XlsxWriterException

    check_workbook_size(evaluation.document, path)
    _check_readable(evaluation, path)
    decimals = transformed_decimals(evaluation)
    # Rows go to disk one by one, so memory stays small: beside the target, where there must be room anyway.
    with replacing(path) as (draft,), scratch_folder(draft) as scratch:
        try:
            _write(evaluation, decimals, draft, scratch, progress)
        except XlsxWriterException as error:
            cause = error.args[0] if error.args else error
            raise unwritable(path, cause if isinstance(cause, OSError) else OSError(str(error))) from error
    if _is_finer(decimals):
        LOGGER.warning(
            "%s: the transformed x, y, z have %s decimals, for the layout's %d are too coarse for this surface",
            path,
            _listed(decimals),
            layout.TRANSFORMED_DECIMALS,
        )


def _check_readable(evaluation: Evaluation, path: Path) -> None:
    """Refuse numbers that this program would refuse to read again."""
    for name in ("raw", "transformed", "matrix"):
        largest = float(np.abs(getattr(evaluation, name)).max())
        if not largest <= LARGEST_MAGNITUDE:
            what = "entries of T" if name == "matrix" else f"{name} coordinates"
            raise FileError(
                f"{path}: the {what} reach {largest:.3g}; expected at most {LARGEST_MAGNITUDE:g}, to be read back"
            )


def _is_finer(decimals: tuple[int, ...]) -> bool:
    return max(decimals) > layout.TRANSFORMED_DECIMALS


def _listed(decimals: tuple[int, ...]) -> str:
    return ", ".join(map(str, decimals))


def _rounded(points: np.ndarray, decimals: tuple[int, ...]) -> np.ndarray:
    kept = [min(k, _MOST_DECIMALS) for k in decimals]
    return np.stack([points[..., axis].round(k) for axis, k in enumerate(kept)], axis=-1)


def _write(evaluation: Evaluation, decimals: tuple[int, ...], draft: Path, scratch: Path, progress: Progress) -> None:
    import xlsxwriter

    book = xlsxwriter.Workbook(str(draft), {"constant_memory": True, "tmpdir": str(scratch)})
    book.set_properties({"title": "QOVR surface", "comments": f"Made by {PROGRAM}", "created": timestamp_insisted_on()})
    sheet = book.add_worksheet("QOVR surface")
    count = len(evaluation.u) * len(evaluation.v)
    for row, cells in enumerate(_rows(evaluation, decimals), start=layout.TITLE_ROW - 1):
        for column, value in cells:
            sheet.write(row, column, value)
        if row % _ROWS_A_REPORT == 0:
            progress(row / (count + layout.FIRST_ROW))
    record = book.add_worksheet(layout.RECORD_SHEET)
    for row, (name, value) in enumerate(_record(evaluation.document, decimals)):
        record.write(row, 0, name)
        record.write(row, 1, value)
    book.close()
    progress(1.0)


def _record(document: Document, decimals: tuple[int, ...]) -> list[tuple[str, Any]]:
    n, m = document.samples
    return [
        ("program", PROGRAM),
        ("formulation", str(document.formulation)),
        ("samples_u", n),
        ("samples_v", m),
        (layout.RECORD_OF_DOCUMENT, document_to_json(document)),
        *([("transformed_decimals", _listed(decimals))] if _is_finer(decimals) else []),
    ]


def _rows(evaluation: Evaluation, decimals: tuple[int, ...]) -> Iterator[Cells]:
    """Yield the cells of every row from the title row on."""
    yield [(layout.column_index(letters), text) for letters, text in layout.TITLES.items()]
    yield []
    yield [(layout.column_index(letters), text) for letters, text in layout.HEADERS.items()]
    tables = (
        (layout.NET, _net_rows(evaluation)),
        (layout.CONTROL_BOX, _box_rows(evaluation.control_box)),
        (layout.RAW, _point_rows(evaluation.raw)),
        (layout.RAW_BOX, _box_rows(evaluation.raw_box)),
        (layout.MATRIX, iter(evaluation.matrix.tolist())),
        (layout.TRANSFORMED, _point_rows(_rounded(evaluation.transformed, decimals))),
        (layout.ROW_KNOTS, _row_knot_rows(evaluation.document)),
        (layout.COLUMN_KNOTS, _column_knot_rows(evaluation.document)),
    )
    starts = [layout.column_index(letters) for letters, _ in tables]
    for parts in zip_longest(*(rows for _, rows in tables), fillvalue=()):
        yield [
            cell
            for start, part in zip(starts, parts, strict=True)
            for cell in enumerate(part, start)
            if cell[1] is not None
        ]


def _net_rows(evaluation: Evaluation) -> Iterator[list[Any]]:
    net = evaluation.document.control_points
    for k, (i, j) in enumerate(np.ndindex(net.shape[:2])):
        yield [k, i, j, *net[i, j].tolist()]


def _box_rows(box: np.ndarray) -> Iterator[list[Any]]:
    for axis, bounds in zip("xyz", box.tolist(), strict=True):
        yield [axis, *bounds]


def _point_rows(points: np.ndarray) -> Iterator[list[Any]]:
    count = 0
    for row in points:  # one row of the grid at a time, so that a million points never become a million lists
        for point in row.tolist():
            yield [count, *point]
            count += 1


def _row_knot_rows(document: Document) -> Iterator[list[Any]]:
    knots = document.row_knots.array[::-1, 0].tolist()
    for name, values in zip(layout.ROW_CURVE_NAMES, knots, strict=True):
        yield [name, *values]


def _column_knot_rows(document: Document) -> Iterator[list[Any]]:
    downward = document.column_knots.array[:, 0].T[::-1].tolist()
    for name, values in zip(layout.COLUMN_KNOT_NAMES, downward, strict=True):
        yield [name, *values]
    yield [None, *layout.COLUMN_CURVE_NAMES]
