"""What all headless commands share: exit codes, JSON, progress, the words about SOURCE."""

from __future__ import annotations

import argparse
import math
import re
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from qovr_core.document import Window
from qovr_core.files.progress import Progress, silent

DONE, ANSWER_IS_NO, WRONG = 0, 1, 2
"""Exit codes: done; the answer is no; the call or its input is wrong."""

SOURCE_HELP = (
    "SOURCE is a .qovr file, a workbook in the published layout (.xlsx), an exported .npz, .mat or .3dm, "
    "or paper:NAME or shape:NAME, such as paper:fig6b; 'qovr presets' lists them."
)


_NUMBER = re.compile(r"[-+]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][-+]?[0-9]+)?")
"""Numbers as every program writes them: no other digits than 0 to 9, no groups, no words."""


def number(text: str) -> float:
    """Return the number that an option's value is; not a number (NaN) where it is none."""
    return float(text) if _NUMBER.fullmatch(text) else math.nan


def words(text: str) -> list[str]:
    """Return the words of a list with commas, each once.

    Raises
    ------
    argparse.ArgumentTypeError : there is no word
    """
    found = [part.strip().lower() for part in text.split(",") if part.strip()]
    if not found:
        raise argparse.ArgumentTypeError(f"'{text}' holds no word; expected words with commas between them")
    return list(dict.fromkeys(found))


def add_window(command: Any, use: str, first: Window | None = None) -> None:
    """Add ``--window``, which names one window of a net, to a command; ``use`` says what for."""
    command.add_argument(
        "--window",
        type=_window,
        metavar="A,B",
        default=first,
        help=f"{use}; A counts along v and B along u, from 0",
    )


def _window(text: str) -> Window:
    match = re.fullmatch(r"([0-9]{1,3})\s*,\s*([0-9]{1,3})", text.strip())
    if not match:
        raise argparse.ArgumentTypeError(f"'{text}' is no window; expected A,B, each counted from 0, as 1,0")
    return int(match[1]), int(match[2])


def path(text: str) -> Path:
    """Return the path that an argument names.

    Raises
    ------
    argparse.ArgumentTypeError : the name is empty, as that of a variable nobody has set
    """
    if not text:
        raise argparse.ArgumentTypeError("the name is empty; expected that of a file or folder")
    return Path(text)


def finite(value: float) -> float | None:
    """Return a number that JSON can hold; None stands for no number at all."""
    return value if math.isfinite(value) else None


def print_json(content: object) -> None:
    """Print what a program reads."""
    import json

    print(json.dumps(content, indent=2))


@contextmanager
def progress_bar(name: str) -> Iterator[Progress]:
    """Yield a progress that draws a bar on a terminal and nothing on a pipe."""
    if not sys.stderr.isatty():
        yield silent
        return
    from tqdm import tqdm

    layout = "{desc}: {percentage:3.0f}% |{bar}| {elapsed}, {remaining} left"
    with tqdm(desc=name, total=1.0, leave=False, bar_format=layout) as bar:
        yield lambda part: bar.update(part - bar.n) and None
