"""What all headless commands share: exit codes, JSON, progress, the words about SOURCE."""

from __future__ import annotations

import argparse
import json
import math
import re
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from qovr_core.files.progress import Progress

DONE, ANSWER_IS_NO, WRONG = 0, 1, 2
"""Exit codes: done; the answer is no; the call or its input is wrong."""

SOURCE_HELP = (
    "SOURCE is a .qovr file, a workbook in the published layout (.xlsx), an exported .npz, .mat or .3dm, "
    "or paper:NAME, such as paper:fig6b."
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
    print(json.dumps(content, indent=2))


@contextmanager
def progress_bar(name: str) -> Iterator[Progress]:
    """Yield a progress that draws a bar on a terminal and nothing on a pipe."""
    from tqdm import tqdm

    layout = "{desc}: {percentage:3.0f}% |{bar}| {elapsed}, {remaining} left"
    with tqdm(desc=name, total=1.0, disable=None, leave=False, bar_format=layout) as bar:
        yield lambda part: bar.update(part - bar.n) and None
