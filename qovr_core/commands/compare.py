"""``qovr compare``: the surface beside the classical surfaces of its net, in numbers."""

from __future__ import annotations

import argparse
import re
from itertools import count
from typing import Any

from qovr_core.checks import LARGEST_MAGNITUDE
from qovr_core.commands.common import DONE, SOURCE_HELP, add_window, number, print_json, progress_bar
from qovr_core.edits import extract_window
from qovr_core.files import read_source
from qovr_core.laboratory.comparison import DEFAULT_POINT, DEFAULT_WEIGHT, compare, compared_names
from qovr_core.laboratory.comparison_report import comparison_facts, comparison_text
from qovr_core.laboratory.comparison_surfaces import COMPARISON_SURFACES


def add_command(commands: Any) -> None:
    *titles, last = (surface.title for surface in COMPARISON_SURFACES.values())
    help_text = f"measure it beside {', '.join(titles)} and {last}"
    command = commands.add_parser("compare", help=help_text, epilog=SOURCE_HELP)
    command.add_argument("source", metavar="SOURCE")
    command.add_argument(
        "--point",
        type=_point,
        metavar="I,J",
        default=DEFAULT_POINT,
        help="the control point of the window that moves, I and J from 0 to 4 (default: {},{})".format(*DEFAULT_POINT),
    )
    command.add_argument(
        "--weight",
        type=_weight,
        metavar="W",
        default=DEFAULT_WEIGHT,
        help=f"its weight in the NURBS surface; all others have 1 (default: {DEFAULT_WEIGHT:g})",
    )
    add_window(command, "the window of a larger net that is measured (default: 0,0)", (0, 0))
    command.add_argument("--json", action="store_true")
    command.set_defaults(command=_compare)


def _compare(arguments: argparse.Namespace) -> int:
    net, names, known = read_source(arguments.source), compared_names(), count(1)
    document = extract_window(net, arguments.window)
    with progress_bar("compare") as progress:
        comparison = compare(
            document, arguments.point, arguments.weight, lambda _name, _measures: progress(next(known) / len(names))
        )
    is_part = not net.is_one_window
    if arguments.json:
        print_json({**({"window": list(arguments.window)} if is_part else {}), **comparison_facts(comparison)})
    else:
        if is_part:
            print("window {},{} of a net of {} x {} windows".format(*arguments.window, *net.windows))
        print(comparison_text(comparison))
    return DONE


def _point(text: str) -> tuple[int, int]:
    match = re.fullmatch(r"([0-4])\s*,\s*([0-4])", text.strip())
    if not match:
        raise argparse.ArgumentTypeError(f"'{text}' is no control point; expected I,J, each from 0 to 4, as 2,3")
    return int(match[1]), int(match[2])


def _weight(text: str) -> float:
    value = number(text)
    if not 0 < value <= LARGEST_MAGNITUDE:
        raise argparse.ArgumentTypeError(
            f"'{text}' is no weight; expected a positive number up to {LARGEST_MAGNITUDE:g}, as 4"
        )
    return value
