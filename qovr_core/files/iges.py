"""Writing ``.iges`` (IGES 5.3): the exact surface, a rational B-spline surface (entity 128) for each smooth part."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

import numpy as np

from qovr_core.evaluation import Evaluation
from qovr_core.files import bspline, parts, step_entities
from qovr_core.files.atomic import replacing
from qovr_core.files.bspline import SplineSurface
from qovr_core.files.conventions import Unit
from qovr_core.files.options import DEFAULTS, ExportOptions
from qovr_core.files.parts import Sheet
from qovr_core.files.progress import Progress
from qovr_core.files.provenance import PROGRAM, origin, timestamp, timestamp_insisted_on
from qovr_core.files.qovr_document import document_to_json

ENTITY = 128
UNITS = {Unit.INCH: (1, "IN"), Unit.MILLIMETRE: (2, "MM"), Unit.METRE: (6, "M"), Unit.CENTIMETRE: (10, "CM")}
"""Number and name of each unit in fields 14 and 15 of the global section."""

IGES_5_3 = 11

_TEXT_COLUMNS = 72
_PARAMETER_COLUMNS = 64
"""Columns 65 to 72 of a parameter line point to its directory entry."""

_LABEL = "QOVR"


def write_iges(evaluation: Evaluation, path: Path, progress: Progress, options: ExportOptions = DEFAULTS) -> None:
    """Write the exact surface in the unit of its numbers, an entity of its true degree for each smooth part.

    Raises
    ------
    FileError : the surface has no area, or the file cannot be written
    """
    sheets = parts.sheets(evaluation, options, path)
    progress(0.0)
    within = parts.uncertainty(sheets)
    entities = [_parameters(surface, within) for surface in parts.surfaces(sheets)]
    text = _file(_start(evaluation, options), _global_fields(sheets, path, options.unit), entities)
    with replacing(path) as (draft,):
        draft.write_text(text, encoding="ascii", newline="\n")
        progress(1.0)


def real(value: float) -> str:
    """Return the shortest decimal that reads back as the number, as IGES spells double precision: ``1.D-5``."""
    return step_entities.real(value).replace("E", "D")


def hollerith(text: str) -> str:
    """Return a text as an IGES string constant; a character that IGES lacks becomes a question mark."""
    plain = re.sub(r"[^ -~]", "?", text)
    return f"{len(plain)}H{plain}" if plain else ""


def _start(evaluation: Evaluation, options: ExportOptions) -> list[str]:
    """Return the lines for people: the origin, and the document's text cut into columns."""
    text = " ".join(document_to_json(evaluation.document).split())
    document = [text[k : k + _TEXT_COLUMNS] for k in range(0, len(text), _TEXT_COLUMNS)]
    return [origin(evaluation, options)[:_TEXT_COLUMNS], "The document:", *document]


def _global_fields(sheets: tuple[Sheet, ...], path: Path, unit: Unit) -> list[str]:
    made = hollerith(f"{timestamp_insisted_on():%Y%m%d.%H%M%S}")
    changed = made if timestamp() else ""
    names = [hollerith(text) for text in (path.stem, path.name, PROGRAM, PROGRAM)]
    precision = ["32", "38", "6", "308", "15"]  # bits of an integer, then exponents and digits of both reals
    flag, name = UNITS[unit]
    largest = real(max(float(np.abs(surface.points).max()) for surface in parts.surfaces(sheets)))
    return [
        *("1H,", "1H;", *names, *precision, hollerith(path.stem)),
        *("1.0", str(flag), hollerith(name), "1", "0.0", made, real(parts.uncertainty(sheets)), largest),
        *("", "", str(IGES_5_3), "0", changed),
    ]


def _parameters(surface: SplineSurface, within: float) -> list[str]:
    """Return the fields of entity 128; here u runs fastest through the control points."""
    outline = bspline.outline(surface.points, within)
    knots = [real(knot) for vector in (surface.u, surface.v) for knot in vector.repeated]
    is_polynomial, is_periodic = "1", "0"
    flags = [str(int(outline.closed_u)), str(int(outline.closed_v)), is_polynomial, is_periodic, is_periodic]
    count_u, count_v = surface.points.shape[:2]
    weights = ["1.0"] * (count_u * count_v)
    coordinates = [real(x) for x in surface.points.transpose(1, 0, 2).ravel().tolist()]
    domain = [real(vector.values[end]) for vector in (surface.u, surface.v) for end in (0, -1)]
    sizes = [str(number) for number in (ENTITY, count_u - 1, count_v - 1, surface.u.degree, surface.v.degree)]
    return [*sizes, *flags, *knots, *weights, *coordinates, *domain]


def _wrapped(fields: list[str], columns: int) -> Iterator[str]:
    """Yield lines of delimited fields; a number stays on its line, a string may go on in the next."""
    line = ""
    for k, field in enumerate(fields):
        text = field + (";" if k == len(fields) - 1 else ",")
        if "H" not in text and len(line) + len(text) > columns:
            yield line
            line = ""
        line += text
        while len(line) > columns:
            yield line[:columns]
            line = line[columns:]
    yield line


def _file(start: list[str], global_fields: list[str], entities: list[list[str]]) -> str:
    directory: list[str] = []
    parameters: list[str] = []
    for fields in entities:
        entry, first = len(directory) + 1, len(parameters) + 1
        lines = list(_wrapped(fields, _PARAMETER_COLUMNS))
        parameters += [f"{line:<{_PARAMETER_COLUMNS}}{entry:>8}" for line in lines]
        directory += [
            "".join(f"{value:>8}" for value in (ENTITY, first, 0, 0, 0, 0, 0, 0, "00000000")),
            "".join(f"{value:>8}" for value in (ENTITY, 0, 0, len(lines), 0, "", "", _LABEL, 0)),
        ]
    sections = {"S": start, "G": list(_wrapped(global_fields, _TEXT_COLUMNS)), "D": directory, "P": parameters}
    counts = "".join(f"{letter}{len(lines):>7}" for letter, lines in sections.items())
    sections["T"] = [counts]
    return "".join(
        f"{line:<{_TEXT_COLUMNS}}{letter}{number:>7}\n"
        for letter, lines in sections.items()
        for number, line in enumerate(lines, 1)
    )
