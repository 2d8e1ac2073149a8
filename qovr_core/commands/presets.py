"""``qovr presets``: the paper's cases and the shapes to begin with, by name."""

from __future__ import annotations

import argparse
from typing import Any

from qovr_core.commands.common import DONE
from qovr_core.presets import presets
from qovr_core.shapes import SHAPES


def add_command(commands: Any) -> None:
    commands.add_parser("presets", help="list the paper's cases, and shapes to begin with").set_defaults(
        command=_presets
    )


def _presets(_arguments: argparse.Namespace) -> int:
    for entry in presets().values():
        print(f"paper:{entry.name:<8}{entry.title}")
    for name, shape in SHAPES.items():
        print(f"shape:{name:<16}{shape.title}")
    return DONE
