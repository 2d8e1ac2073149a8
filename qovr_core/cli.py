"""The headless commands of ``qovr``; nothing here loads Qt."""

from __future__ import annotations

import argparse
import json
import math
import os
import re
import signal
import sys
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path
from typing import Any, NoReturn

from qovr_core.document import Document, Formulation
from qovr_core.errors import DocumentError, FileError, QovrError
from qovr_core.files import FORMATS, ExportOptions, Layer, format_for, read_source
from qovr_core.files.progress import Progress
from qovr_core.pipeline import configure
from qovr_core.presets import presets
from qovr_core.version import VERSION

DONE, ANSWER_IS_NO, WRONG = 0, 1, 2
_INTERRUPTED = 130

_OF_ONE_LAYER = ", ".join(entry.suffix for entry in FORMATS.values() if entry.holds_one_layer)
_MESHES = ", ".join(entry.suffix for entry in FORMATS.values() if entry.is_mesh)

Command = Callable[[argparse.Namespace], int]


class _Parser(argparse.ArgumentParser):
    """A parser whose errors are one line."""

    def error(self, message: str) -> NoReturn:
        raise QovrError(f"{message} (see '{self.prog} --help')")


def main(argv: Sequence[str] | None = None) -> int:
    """Run one headless command and return its exit code."""
    return run(build_parser()[0], argv)


def run(parser: argparse.ArgumentParser, argv: Sequence[str] | None) -> int:
    """Run one of a parser's commands and return its exit code.

    0 done, 1 the answer is no, 2 the call or its input is wrong; errors are one line on stderr.
    """
    _make_streams_robust()
    signal.signal(signal.SIGTERM, _interrupt)
    try:
        arguments = parser.parse_args(argv)
        command: Command = arguments.command
        code = command(arguments)
        sys.stdout.flush()
        return code
    except QovrError as error:
        return _complain(str(error))
    except MemoryError:
        return _complain("there is not enough memory for this; ask for fewer samples")
    except KeyboardInterrupt:
        _complain("interrupted; no unfinished file is left")
        return _INTERRUPTED
    except BrokenPipeError:
        # The reader has gone, as in "qovr info ... | head": not an error, and nothing may be flushed any more.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return DONE


def build_parser() -> tuple[argparse.ArgumentParser, Any]:
    """Return the parser of all headless commands, and the place where others add theirs."""
    parser = _Parser(prog="qovr", description="Quartic Overhauser (QOVR) surfaces.", epilog=_EPILOG)
    parser.add_argument("--version", action="version", version=f"QOVR Studio {VERSION}")
    commands = parser.add_subparsers(title="commands", metavar="COMMAND", required=True)
    _add_export(commands)
    _add_figures(commands)
    _add_reproduce(commands)
    _add_presets(commands)
    _add_info(commands)
    return parser, commands


_EPILOG = (
    "SOURCE is a .qovr file, a workbook in the published layout (.xlsx), an exported .npz, .mat or .3dm, "
    "or paper:NAME, such as paper:fig6b."
)


def _add_export(commands: Any) -> None:
    command = commands.add_parser("export", help="evaluate and write files", epilog=_EPILOG)
    command.add_argument("source", metavar="SOURCE")
    command.add_argument("outs", metavar="OUT", nargs="+", type=Path, help=f"ends in {', '.join(FORMATS)}")
    command.add_argument("--formulation", choices=[str(name) for name in Formulation])
    command.add_argument("--samples", type=_samples, metavar="N|NxM", help="samples along u and v, 2 to 4096")
    command.add_argument(
        "--layer",
        choices=[str(layer) for layer in Layer],
        help=f"which surface {_OF_ONE_LAYER} get (default: transformed; raw for interpolating)",
    )
    command.add_argument(
        "--tolerance",
        type=_tolerance,
        metavar="DISTANCE",
        help=f"largest distance between surface and mesh; {_MESHES} then choose their own samples",
    )
    command.set_defaults(command=_export)


def _add_figures(commands: Any) -> None:
    command = commands.add_parser("figures", help="draw the paper's Figures 5a to 8b")
    command.add_argument("outdir", metavar="OUTDIR", type=Path)
    command.add_argument(
        "--only", action="append", default=[], metavar="NAME", help="as fig6b, or fig6 for all its parts"
    )
    command.add_argument("--formats", default="png,svg,pdf", help="any of png,svg,pdf (default: all)")
    command.add_argument("--dpi", type=_dpi, default=300, help="resolution of the PNG files (default: 300)")
    command.set_defaults(command=_figures)


def _add_reproduce(commands: Any) -> None:
    command = commands.add_parser("reproduce", help="compute published workbooks again and compare")
    command.add_argument("workbooks", metavar="WORKBOOK", nargs="+", type=Path)
    command.add_argument("--json", action="store_true")
    command.set_defaults(command=_reproduce)


def _add_presets(commands: Any) -> None:
    commands.add_parser("presets", help="list the paper's cases").set_defaults(command=_presets)


def _add_info(commands: Any) -> None:
    command = commands.add_parser("info", help="boxes, matrix, degree, knots out of range", epilog=_EPILOG)
    command.add_argument("source", metavar="SOURCE")
    command.add_argument("--json", action="store_true")
    command.set_defaults(command=_info)


def _export(arguments: argparse.Namespace) -> int:
    document = _changed(read_source(arguments.source), arguments)
    formats = [format_for(out) for out in arguments.outs]
    options = ExportOptions(arguments.layer, arguments.tolerance)
    if options.tolerance is not None and not any(target.is_mesh for target in formats):
        raise QovrError(f"--tolerance is for a mesh; expected an OUT that ends in {_MESHES}")
    for out, target in zip(arguments.outs, formats, strict=True):
        target.check(document, out)
        _check_folder(out)
        _announce(target.announce(document), out)
    surface = configure(document)
    for out, target in zip(arguments.outs, formats, strict=True):
        with _progress_bar(out.name) as progress:
            target.write(surface, out, progress, options)
    return DONE


def _figures(arguments: argparse.Namespace) -> int:
    from qovr_core.figures import FIGURE_FORMATS, find_figures, save_figure

    kinds = _listed(arguments.formats)
    for kind in kinds:
        if kind not in FIGURE_FORMATS:
            raise QovrError(f"there is no figure format '{kind}'; expected any of {', '.join(FIGURE_FORMATS)}")
    cases = find_figures([name for entry in arguments.only for name in _listed(entry)])
    try:
        arguments.outdir.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise FileError(f"{arguments.outdir}: cannot be made: {error.strerror or error}") from error
    files = [(case, arguments.outdir / f"{case.name}.{kind}") for case in cases for kind in kinds]
    with _progress_bar("figures") as progress:
        for done, (case, path) in enumerate(files):
            save_figure(case, path, dpi=arguments.dpi)
            progress((done + 1) / len(files))
    return DONE


def _reproduce(arguments: argparse.Namespace) -> int:
    from qovr_core.reproduce import RAW_TOLERANCE, TRANSFORMED_TOLERANCE, reproduce

    results = [reproduce(path) for path in arguments.workbooks]
    all_met = all(result.met_by for result in results)
    if arguments.json:
        workbooks = [
            {
                "workbook": str(result.path),
                "samples": list(result.samples),
                "met_by": [str(name) for name in result.met_by],
                "differences": {
                    str(name): {key: _finite(value) for key, value in vars(difference).items()}
                    for name, difference in result.differences.items()
                },
            }
            for result in results
        ]
        tolerances = {"raw": RAW_TOLERANCE, "transformed": TRANSFORMED_TOLERANCE}
        _print_json({"reproduced": all_met, "tolerances": tolerances, "workbooks": workbooks})
    else:
        for result in results:
            print(f"{result.path}: {result.samples[0]} x {result.samples[1]} points, largest differences")
            print(f"  {'formulation':<15}{'raw':>11}{'box':>11}{'matrix':>11}{'transformed':>13}")
            for name, d in result.differences.items():
                verdict = "  meets the workbook" if d.meets else ""
                print(f"  {name:<15}{d.raw:>11.2e}{d.box:>11.2e}{d.matrix:>11.2e}{d.transformed:>13.2e}{verdict}")
            if not result.met_by:
                limits = f"raw within {RAW_TOLERANCE:g}, transformed within {TRANSFORMED_TOLERANCE:g}"
                print(f"  none meets it: expected {limits}")
    return DONE if all_met else ANSWER_IS_NO


def _presets(_arguments: argparse.Namespace) -> int:
    for entry in presets().values():
        print(f"paper:{entry.name:<8}{entry.title}")
    return DONE


def _info(arguments: argparse.Namespace) -> int:
    from qovr_core.report import facts_text, surface_facts

    facts = surface_facts(configure(read_source(arguments.source)))
    if arguments.json:
        _print_json(facts)
    else:
        print(facts_text(facts))
    return DONE


def _changed(document: Document, arguments: argparse.Namespace) -> Document:
    """Return the document with what the call's options say."""
    if arguments.formulation is not None:
        document = replace(document, formulation=Formulation(arguments.formulation))
    if arguments.samples is not None:
        document = replace(document, samples=arguments.samples)
    return document


def _check_folder(out: Path) -> None:
    if not out.parent.is_dir():
        raise FileError(f"{out}: cannot be written: the folder {out.parent} does not exist")


def _announce(announcement: str, out: Path) -> None:
    if announcement and sys.stderr.isatty():
        print(f"qovr: {out}: {announcement}", file=sys.stderr)


def _samples(text: str) -> tuple[int, int]:
    match = re.fullmatch(r"(\d{1,9})(?:[xX](\d{1,9}))?", text)
    if not match:
        raise argparse.ArgumentTypeError(f"'{text}' is no sample count; expected N or NxM, as 101 or 101x51")
    n, m = int(match[1]), int(match[2] or match[1])
    from qovr_core.checks import checked_samples

    try:
        return checked_samples(n, "samples along u"), checked_samples(m, "samples along v")
    except DocumentError as error:
        raise argparse.ArgumentTypeError(str(error)) from None


def _tolerance(text: str) -> float:
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if not 0 < value < math.inf:
        raise argparse.ArgumentTypeError(f"'{text}' is no tolerance; expected a positive distance, as 0.01")
    return value


def _dpi(text: str) -> int:
    if not (text.isascii() and text.isdigit() and 10 <= int(text) <= 2400):
        raise argparse.ArgumentTypeError(f"'{text}' is no resolution; expected a whole number from 10 to 2400")
    return int(text)


def _listed(text: str) -> list[str]:
    return [part.strip().lower() for part in text.split(",") if part.strip()]


def _finite(value: float) -> float | None:
    """Return a number that JSON can hold; None stands for no number at all."""
    return value if math.isfinite(value) else None


def _print_json(content: object) -> None:
    print(json.dumps(content, indent=2))


@contextmanager
def _progress_bar(name: str) -> Iterator[Progress]:
    """Yield a progress that draws a bar on a terminal and nothing on a pipe."""
    from tqdm import tqdm

    layout = "{desc}: {percentage:3.0f}% |{bar}| {elapsed}, {remaining} left"
    with tqdm(desc=name, total=1.0, disable=None, leave=False, bar_format=layout) as bar:
        yield lambda part: bar.update(part - bar.n) and None


def _interrupt(_signal: int, _frame: object) -> NoReturn:
    raise KeyboardInterrupt


def _make_streams_robust() -> None:
    """Let a file name that is no valid text be printed rather than raise."""
    for stream in (sys.stdout, sys.stderr):
        if hasattr(stream, "reconfigure"):
            stream.reconfigure(errors="backslashreplace")


def _complain(text: str) -> int:
    line = "".join(character if character.isprintable() else "?" for character in text)
    print(f"qovr: {line}", file=sys.stderr)
    return WRONG
