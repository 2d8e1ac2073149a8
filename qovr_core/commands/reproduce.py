"""``qovr reproduce``: compute published workbooks again and compare."""

from __future__ import annotations

import argparse
from typing import Any

from qovr_core.commands.common import ANSWER_IS_NO, DONE, finite, path, print_json


def add_command(commands: Any) -> None:
    command = commands.add_parser("reproduce", help="compute published workbooks again and compare")
    command.add_argument("workbooks", metavar="WORKBOOK", nargs="+", type=path)
    command.add_argument("--json", action="store_true")
    command.set_defaults(command=_reproduce)


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
                    str(name): {key: finite(value) for key, value in vars(difference).items() if key != "meets"}
                    for name, difference in result.differences.items()
                },
            }
            for result in results
        ]
        tolerances = {"raw": RAW_TOLERANCE, "transformed": TRANSFORMED_TOLERANCE}
        print_json({"reproduced": all_met, "tolerances": tolerances, "workbooks": workbooks})
    else:
        for result in results:
            print(f"{result.path}: {result.samples[0]} x {result.samples[1]} points, largest differences")
            print(f"  {'formulation':<15}{'raw':>11}{'box':>11}{'matrix':>11}{'transformed':>13}")
            for name, d in result.differences.items():
                verdict = "  meets the workbook" if d.meets else ""
                print(f"  {name:<15}{d.raw:>11.2e}{d.box:>11.2e}{d.matrix:>11.2e}{d.transformed:>13.2e}{verdict}")
            if not result.met_by:
                raw = f"raw within {RAW_TOLERANCE:g} of its largest"
                limits = f"{raw}, transformed within {TRANSFORMED_TOLERANCE:g} of its last decimal"
                print(f"  none meets it: expected {limits}")
    return DONE if all_met else ANSWER_IS_NO
