"""Where the files lie that are installed with the program."""

from __future__ import annotations

from importlib.util import find_spec
from pathlib import Path


def resource(*names: str) -> Path:
    """Return the path of an installed file, by the names of its folder and its own."""
    package = find_spec("qovr_resources")
    assert package  # the folder ``resources`` is installed by this name
    return Path(str(package.origin)).parent.joinpath(*names)
