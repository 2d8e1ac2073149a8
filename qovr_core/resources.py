"""Where the files lie that are installed with the program."""

from __future__ import annotations

from pathlib import Path

import qovr_resources


def resource(*names: str) -> Path:
    """Return the path of an installed file, by the names of its folder and its own."""
    return Path(qovr_resources.__file__).parent.joinpath(*names)
