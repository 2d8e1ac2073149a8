"""What all headless commands share: exit codes, JSON, progress, the words about SOURCE."""

from __future__ import annotations

import json
import math
from collections.abc import Iterator
from contextlib import contextmanager

from qovr_core.files.progress import Progress

DONE, ANSWER_IS_NO, WRONG = 0, 1, 2
"""Exit codes: done; the answer is no; the call or its input is wrong."""

SOURCE_HELP = (
    "SOURCE is a .qovr file, a workbook in the published layout (.xlsx), an exported .npz, .mat or .3dm, "
    "or paper:NAME, such as paper:fig6b."
)


def listed(text: str) -> list[str]:
    """Return the words of a list with commas."""
    return [part.strip().lower() for part in text.split(",") if part.strip()]


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
