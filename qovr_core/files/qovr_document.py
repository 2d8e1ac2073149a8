"""The document file, ``NAME.qovr``: JSON that says everything and nothing else."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any, BinaryIO

from qovr_core.checks import Verbatim, checked_knot, described
from qovr_core.document import NET_SIZE, Document
from qovr_core.edits import knots_of
from qovr_core.errors import DocumentError, quoted
from qovr_core.evaluation import Evaluation
from qovr_core.files.atomic import replacing
from qovr_core.files.format import Format
from qovr_core.files.options import ExportOptions
from qovr_core.files.progress import Progress
from qovr_core.files.reading import reading
from qovr_core.geometry.knots import Direction, Knots

FORMAT = "qovr-document"
VERSION = 1

LARGEST_FILE = 1_000_000
"""Bytes; a document is a few thousand, so a larger file is something else."""

_MOST_DIGITS = 4000
"""Digits of a whole number that are read at all: more take Python long, and it refuses them."""

_KEYS = ("format", "version", "formulation", "samples", "control_points", "row_knots", "column_knots")


def read_document(path: Path) -> Document:
    """Return the document in a ``.qovr`` file.

    Raises
    ------
    FileError : the file cannot be read, is no JSON, or holds anything but a valid document; the text names the
        place in it, what stands there and what is expected
    """
    with reading(path) as file:
        return document_from_json(_text(file))


def write_document(document: Document, path: Path) -> None:
    """Write a ``.qovr`` file, whole or not at all.

    Raises
    ------
    FileError : the file cannot be written
    """
    with replacing(path) as (draft,):
        draft.write_text(document_to_json(document), encoding="utf-8", newline="\n")


def _write(evaluation: Evaluation, path: Path, progress: Progress, _options: ExportOptions) -> None:
    write_document(evaluation.document, path)
    progress(1.0)


QOVR = Format(
    suffix=".qovr",
    name="QOVR document",
    keeps="the document, exactly",
    loses="the points, which the document makes again",
    writer=_write,
    reader=read_document,
)


def document_to_json(document: Document) -> str:
    """Return the text of a ``.qovr`` file; every number reads back as itself."""
    rows = [json.dumps(row) for row in document.control_points.tolist()]
    entries = {
        "format": json.dumps(FORMAT),
        "version": json.dumps(VERSION),
        "formulation": json.dumps(str(document.formulation)),
        "samples": json.dumps(list(document.samples)),
        "control_points": _lines(rows),
        "row_knots": _knot_lines(document, Direction.ROWS),
        "column_knots": _knot_lines(document, Direction.COLUMNS),
    }
    body = ",\n".join(f"  {json.dumps(key)}: {text}" for key, text in entries.items())
    return f"{{\n{body}\n}}\n"


def _knot_lines(document: Document, direction: Direction) -> str:
    curves = knots_of(document, direction)
    return _lines([json.dumps(dict(zip(direction.knot_letters, knots, strict=True))) for knots in curves])


def _lines(texts: list[str]) -> str:
    return "[\n    " + ",\n    ".join(texts) + "\n  ]"


def document_from_json(text: str) -> Document:
    """Return the document that a ``.qovr`` file's text holds.

    Raises
    ------
    DocumentError : a key or value is not what a document holds
    ValueError : the text is no JSON
    """
    data = _parsed(text)
    if not isinstance(data, dict):
        raise DocumentError("the file", described(data), "an object with the keys " + ", ".join(_KEYS))
    if data.get("format") != FORMAT:
        raise DocumentError("format", described(data.get("format")), repr(FORMAT))
    _check_version(data.get("version"))
    _check_keys(data, _KEYS, "")
    return Document(
        control_points=data["control_points"],
        row_knots=_curves(data["row_knots"], Direction.ROWS),
        column_knots=_curves(data["column_knots"], Direction.COLUMNS),
        formulation=data["formulation"],
        samples=data["samples"],
    )


def _check_version(version: object) -> None:
    if isinstance(version, bool) or not isinstance(version, int) or version < 1:
        raise DocumentError("version", described(version), str(VERSION))
    if version > VERSION:
        raise DocumentError("version", described(version), f"{VERSION}; a newer program wrote this file")


def _check_keys(entries: dict[str, Any], keys: tuple[str, ...], place: str) -> None:
    for key in entries:
        if key not in keys:
            raise DocumentError(f"{place}{quoted(key)}", "no key of a document", "only " + ", ".join(keys))
    for key in keys:
        if key not in entries:
            raise DocumentError(f"{place}{key}", "missing", "all of " + ", ".join(keys))


def _curves(value: object, direction: Direction) -> tuple[Knots, ...]:
    if not isinstance(value, list) or len(value) != NET_SIZE:
        raise DocumentError(direction, described(value), f"a list of {NET_SIZE} entries")
    return tuple(_knots(entry, f"{direction}[{k}]", direction.knot_letters) for k, entry in enumerate(value))


def _knots(value: object, place: str, names: tuple[str, ...]) -> Knots:
    if not isinstance(value, dict):
        raise DocumentError(place, described(value), "an object with the keys " + ", ".join(names))
    _check_keys(value, names, f"{place}.")
    return Knots(*(checked_knot(value[name], f"{place}.{name}") for name in names))


def _text(file: BinaryIO) -> str:
    content = file.read(LARGEST_FILE + 1)
    if len(content) > LARGEST_FILE:
        raise ValueError(f"is larger than {LARGEST_FILE // 1000} kB; expected a document of a few kB")
    try:
        return content.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise ValueError(f"byte {error.start} is no UTF-8; expected a JSON document") from error


def _parsed(text: str) -> object:
    try:
        return json.loads(text, object_pairs_hook=_without_repeats, parse_int=_whole_number)
    except json.JSONDecodeError as error:
        raise ValueError(f"line {error.lineno}, column {error.colno} is no JSON: {error.msg}") from error
    except RecursionError:
        raise ValueError("is nested too deeply; expected a JSON document") from None


def _without_repeats(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    entries: dict[str, Any] = {}
    for key, value in pairs:
        if key in entries:
            raise DocumentError(quoted(key), "given twice", "each key once")
        entries[key] = value
    return entries


def _whole_number(text: str) -> int | Verbatim:
    return int(text) if len(text) <= _MOST_DIGITS else Verbatim(text)
