"""``qovr figures``: the paper's figures as files."""

from __future__ import annotations

import argparse
from typing import Any

from qovr_core.commands.common import DONE, path, progress_bar, words
from qovr_core.errors import QovrError
from qovr_core.files.atomic import made_folder


def add_command(commands: Any) -> None:
    command = commands.add_parser("figures", help="draw the paper's Figures 1, 2 and 5 to 8")
    command.add_argument("outdir", metavar="OUTDIR", type=path)
    command.add_argument(
        "--only",
        action="append",
        default=[],
        type=words,
        metavar="NAME",
        help="as fig6b, or fig6 for all its parts",
    )
    command.add_argument("--formats", default="png,svg,pdf", type=words, help="any of png,svg,pdf (default: all)")
    command.add_argument("--dpi", type=_dpi, default=300, help="resolution of the PNG files (default: 300)")
    command.set_defaults(command=_figures)


def _figures(arguments: argparse.Namespace) -> int:
    from qovr_core.figures import FIGURE_FORMATS, find_figures, save_figure

    kinds = arguments.formats
    for kind in kinds:
        if kind not in FIGURE_FORMATS:
            raise QovrError(f"there is no figure format '{kind}'; expected any of {', '.join(FIGURE_FORMATS)}")
    names = find_figures([name for entry in arguments.only for name in entry])
    folder = made_folder(arguments.outdir)
    files = [(name, folder / f"{name}.{kind}") for name in names for kind in kinds]
    with progress_bar("figures") as progress:
        for done, (name, path) in enumerate(files):
            save_figure(name, path, dpi=arguments.dpi)
            progress((done + 1) / len(files))
    return DONE


def _dpi(text: str) -> int:
    if not (text.isascii() and text.isdigit() and 10 <= int(text) <= 2400):
        raise argparse.ArgumentTypeError(f"'{text}' is no resolution; expected a whole number from 10 to 2400")
    return int(text)
