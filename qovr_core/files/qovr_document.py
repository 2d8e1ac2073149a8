"""The document file, ``NAME.qovr``: JSON that says everything and nothing else."""

from __future__ import annotations

import json
from itertools import chain
from operator import itemgetter
from pathlib import Path
from typing import Any, BinaryIO

from qovr_core.arrays import Array
from qovr_core.checks import Verbatim, checked_knot, described, entries, plain_numbers
from qovr_core.document import Document
from qovr_core.edits import knots_of
from qovr_core.errors import DocumentError, quoted
from qovr_core.evaluation import Evaluation
from qovr_core.files.atomic import replacing
from qovr_core.files.options import ExportOptions
from qovr_core.files.progress import Progress
from qovr_core.files.reading import reading
from qovr_core.geometry.knots import Direction, Knots, KnotTable
from qovr_core.geometry.windows import NET_SIZE
from qovr_core.joints import Joints

FORMAT = "qovr-document"
VERSION = 2
"""The newest version; a document of one window is written as version 1, which older programs read."""

LARGEST_FILE = 40_000_000
"""Bytes; the largest net takes half of it, so a larger file is something else."""

_MOST_DIGITS = 4000
"""Digits of a whole number that are read at all: more take Python long, and it refuses them."""

_KEYS = ("format", "version", "formulation", "samples", "control_points", "row_knots", "column_knots")
_NET_KEYS = (*_KEYS, "joints")


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


def write_qovr(evaluation: Evaluation, path: Path, progress: Progress, _options: ExportOptions) -> None:
    """Write the document of a surface as a ``.qovr`` file.

    Raises
    ------
    FileError : the file cannot be written
    """
    write_document(evaluation.document, path)
    progress(1.0)


def document_to_json(document: Document) -> str:
    """Return the text of a ``.qovr`` file; every number reads back as itself."""
    is_net = not document.is_one_window
    rows, columns = (_knot_lines(knots_of(document, direction), direction, is_net) for direction in Direction)
    texts = {
        "format": json.dumps(FORMAT),
        "version": json.dumps(VERSION if is_net else 1),
        "formulation": json.dumps(str(document.formulation)),
        "samples": json.dumps(list(document.samples)),
        "control_points": _lines([json.dumps(row) for row in document.control_points.tolist()]),
        "row_knots": rows,
        "column_knots": columns,
    }
    if is_net:
        texts["joints"] = json.dumps({"u": document.joints.u, "v": document.joints.v})
    if document.closed:
        texts["closed"] = json.dumps(document.closed)
    body = ",\n".join(f"  {json.dumps(key)}: {text}" for key, text in texts.items())
    return f"{{\n{body}\n}}\n"


def _knot_lines(knots: KnotTable, direction: Direction, is_net: bool) -> str:
    curves = [
        [dict(zip(direction.knot_letters, each, strict=True)) for each in curve] for curve in knots.array.tolist()
    ]
    return _lines([json.dumps(curve if is_net else curve[0]) for curve in curves])


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
    return _of_net(data) if _checked_version(data.get("version")) > 1 else _of_one_window(data)


def _of_one_window(data: dict[str, Any]) -> Document:
    """Return the document of version 1."""
    _check_keys(data, _KEYS, "")
    entries(data["control_points"], "control_points", NET_SIZE)
    return Document(
        control_points=data["control_points"],
        row_knots=_curves(data["row_knots"], Direction.ROWS),
        column_knots=_curves(data["column_knots"], Direction.COLUMNS),
        formulation=data["formulation"],
        samples=data["samples"],
    )


def _of_net(data: dict[str, Any]) -> Document:
    """Return the document of version 2."""
    _check_keys(data, _NET_KEYS, "", may=("closed",))
    joints = data["joints"]
    if not isinstance(joints, dict):
        raise DocumentError("joints", described(joints), "an object with the keys u, v")
    _check_keys(joints, ("u", "v"), "joints.")
    along_u, along_v = (tuple(entries(joints[name], f"joints.{name}")) for name in ("u", "v"))
    return Document(
        control_points=data["control_points"],
        row_knots=_windows(data["row_knots"], Direction.ROWS),
        column_knots=_windows(data["column_knots"], Direction.COLUMNS),
        formulation=data["formulation"],
        samples=data["samples"],
        joints=Joints(along_u, along_v),
        closed=data.get("closed", ()),
    )


def _checked_version(version: object) -> int:
    if isinstance(version, bool) or not isinstance(version, int) or version < 1:
        raise DocumentError("version", described(version), f"1 or {VERSION}")
    if version > VERSION:
        raise DocumentError("version", described(version), f"1 or {VERSION}; a newer program wrote this file")
    return version


def _check_keys(found: dict[str, Any], keys: tuple[str, ...], place: str, may: tuple[str, ...] = ()) -> None:
    for key in found:
        if key not in keys + may:
            raise DocumentError(f"{place}{quoted(key)}", "no key of a document", "only " + ", ".join(keys + may))
    for key in keys:
        if key not in found:
            raise DocumentError(f"{place}{key}", "missing", "all of " + ", ".join(keys))


def _curves(value: object, direction: Direction) -> list[Knots]:
    if not isinstance(value, list) or len(value) != NET_SIZE:
        raise DocumentError(direction, described(value), f"a list of {NET_SIZE} entries")
    return [_knots(entry, f"{direction}[{k}]", direction.knot_letters) for k, entry in enumerate(value)]


def _windows(value: object, direction: Direction) -> Array | list[list[Knots]]:
    if (array := _plain_knots(value, direction.knot_letters)) is not None:
        return array
    return [
        [
            _knots(each, f"{direction}[{k}][{window}]", direction.knot_letters)
            for window, each in enumerate(entries(curve, f"{direction}[{k}]"))
        ]
        for k, curve in enumerate(entries(value, direction))
    ]


def _plain_knots(value: object, names: tuple[str, ...]) -> Array | None:
    """Return the knots of a net, (curves, windows, 4), all at once; None where anything is to be looked at singly."""
    if not isinstance(value, list) or {*map(type, value)} != {list} or len({*map(len, value)}) != 1:
        return None
    knots = list(chain.from_iterable(value))
    if {*map(type, knots)} != {dict} or {*map(len, knots)} != {len(names)}:
        return None
    try:
        numbers = plain_numbers(list(chain.from_iterable(map(itemgetter(*names), knots))))
    except KeyError:
        return None
    if numbers is None or not ((numbers > 0) & (numbers < 1)).all():
        return None
    return numbers.reshape(len(value), -1, len(names))


def _knots(value: object, place: str, names: tuple[str, ...]) -> Knots:
    if not isinstance(value, dict):
        raise DocumentError(place, described(value), "an object with the keys " + ", ".join(names))
    _check_keys(value, names, f"{place}.")
    return Knots(*(checked_knot(value[name], f"{place}.{name}") for name in names))


def _text(file: BinaryIO) -> str:
    content = file.read(LARGEST_FILE + 1)
    if len(content) > LARGEST_FILE:
        raise ValueError(f"is larger than {LARGEST_FILE // 1000} kB; expected a document")
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
