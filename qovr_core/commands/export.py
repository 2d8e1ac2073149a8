"""``qovr export``: evaluate a document and write files."""

from __future__ import annotations

import argparse
import math
import re
import sys
from dataclasses import replace
from pathlib import Path
from typing import Any

from qovr_core.commands.common import DONE, SOURCE_HELP, add_window, number, path, progress_bar
from qovr_core.document import Document
from qovr_core.edits import extract_window
from qovr_core.errors import DocumentError, QovrError
from qovr_core.files import FORMATS, ExportOptions, export, format_for, read_source
from qovr_core.files.atomic import check_target
from qovr_core.files.conventions import CsvDialect, Unit, Up
from qovr_core.formulations import FORMULATIONS
from qovr_core.layer import Layer


def add_command(commands: Any) -> None:
    command = commands.add_parser("export", help="evaluate and write files", epilog=SOURCE_HELP)
    command.add_argument("source", metavar="SOURCE")
    command.add_argument("outs", metavar="OUT", nargs="+", type=path, help=f"ends in {', '.join(FORMATS)}")
    command.add_argument("--formulation", choices=list(FORMULATIONS))
    command.add_argument("--samples", type=_samples, metavar="N|NxM", help="samples along u and v, 2 to 4096")
    add_window(command, "write one window of a larger net as a document of its own")
    command.add_argument(
        "--layer",
        choices=[str(layer) for layer in Layer],
        help=f"which surface {_suffixes('holds_one_layer')} get (default: transformed; raw for interpolating)",
    )
    command.add_argument(
        "--tolerance",
        type=_tolerance,
        metavar="DISTANCE",
        help=f"largest distance between surface and mesh; {_suffixes('is_mesh')} then choose their own samples",
    )
    command.add_argument(
        "--units",
        choices=[str(unit) for unit in Unit],
        default=str(Unit.MILLIMETRE),
        help=f"what the document's numbers count (default: mm): {_suffixes('has_unit')} heed it, others keep "
        "the numbers",
    )
    usual = ", ".join(f"{suffix} {entry.usual_up}" for suffix, entry in FORMATS.items() if entry.usual_up)
    command.add_argument(
        "--up", choices=[str(up) for up in Up], help=f"the axis of the file that points up (default: {usual})"
    )
    command.add_argument(
        "--csv-dialect",
        choices=[str(dialect) for dialect in CsvDialect],
        help="how .csv is spelt (default: comma): " + "; ".join(f"{d} has {d.wording}" for d in CsvDialect),
    )
    command.add_argument(
        "--single-face",
        action="store_true",
        help=f"keep the surface of {_suffixes('has_parts')} in one face across sharp joints (default: a face for each "
        "smooth part)",
    )
    command.set_defaults(command=_export)


def _export(arguments: argparse.Namespace) -> int:
    document = _changed(read_source(arguments.source), arguments)
    formats = [format_for(out) for out in arguments.outs]
    options = ExportOptions(
        arguments.layer,
        arguments.tolerance,
        Unit(arguments.units),
        arguments.up,
        CsvDialect(arguments.csv_dialect or CsvDialect.COMMA),
        arguments.single_face,
    )
    for option, value, what, concerned in (
        ("--tolerance", arguments.tolerance, "a mesh", "is_mesh"),
        ("--up", arguments.up, "a mesh without an axis of its own", "usual_up"),
        ("--csv-dialect", arguments.csv_dialect, "a table of text", "is_text_table"),
        ("--single-face", arguments.single_face or None, "an exact surface", "has_parts"),
    ):
        if value is not None and not any(getattr(target, concerned) for target in formats):
            raise QovrError(f"{option} is for {what}; expected an OUT that ends in {_suffixes(concerned)}")
    for out, target in zip(arguments.outs, formats, strict=True):
        target.check(document, out)
        check_target(out)
        _announce(target.announce(document), out)
    for out in arguments.outs:
        with progress_bar(out.name) as progress:
            export(document, out, options, progress)
    return DONE


def _suffixes(concerned: str) -> str:
    """Return the suffixes of the formats that a choice concerns, which their records tell in a field."""
    return ", ".join(suffix for suffix, entry in FORMATS.items() if getattr(entry, concerned))


def _changed(document: Document, arguments: argparse.Namespace) -> Document:
    """Return the document with what the call's options say; samples are those of what is written."""
    if arguments.window is not None:
        document = extract_window(document, arguments.window)
    if arguments.formulation is not None:
        document = replace(document, formulation=FORMULATIONS[arguments.formulation])
    if arguments.samples is not None:
        document = replace(document, samples=arguments.samples)
    return document


def _announce(announcement: str, out: Path) -> None:
    if announcement and sys.stderr.isatty():
        print(f"qovr: {out}: {announcement}", file=sys.stderr)


def _samples(text: str) -> tuple[int, int]:
    match = re.fullmatch(r"([0-9]{1,9})(?:[xX]([0-9]{1,9}))?", text)
    if not match:
        raise argparse.ArgumentTypeError(f"'{text}' is no sample count; expected N or NxM, as 101 or 101x51")
    n, m = int(match[1]), int(match[2] or match[1])
    from qovr_core.checks import checked_samples

    try:
        return checked_samples(n, "samples along u"), checked_samples(m, "samples along v")
    except DocumentError as error:
        raise argparse.ArgumentTypeError(str(error)) from None


def _tolerance(text: str) -> float:
    value = number(text)
    if not 0 < value < math.inf:
        raise argparse.ArgumentTypeError(f"'{text}' is no tolerance; expected a positive distance, as 0.01")
    return value
