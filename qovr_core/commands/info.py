"""``qovr info``: windows and joints, boxes, matrix, degree, curves that fold back."""

from __future__ import annotations

import argparse
from typing import Any

from qovr_core.commands.common import DONE, SOURCE_HELP, print_json
from qovr_core.evaluation import Evaluation
from qovr_core.files import read_source


def add_command(commands: Any) -> None:
    command = commands.add_parser(
        "info", help="windows, boxes, matrix, degree, curves that fold back", epilog=SOURCE_HELP
    )
    command.add_argument("source", metavar="SOURCE")
    command.add_argument("--json", action="store_true")
    command.set_defaults(command=_info)


def _info(arguments: argparse.Namespace) -> int:
    from qovr_core.report import MOST_NAMED, facts_text, surface_facts

    facts = surface_facts(Evaluation(read_source(arguments.source)), None if arguments.json else MOST_NAMED)
    if arguments.json:
        print_json(facts)
    else:
        print(facts_text(facts))
    return DONE
