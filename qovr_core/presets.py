"""The paper's cases and figures, read from the installed resources."""

from __future__ import annotations

import tomllib
from dataclasses import dataclass
from functools import cache
from typing import Any

import numpy as np

from qovr_core.arrays import Array, read_only
from qovr_core.document import Document
from qovr_core.errors import SourceError
from qovr_core.geometry.knots import Knots
from qovr_core.geometry.windows import NET_SIZE
from qovr_core.resources import resource


@dataclass(frozen=True)
class Preset:
    """One of the paper's cases: its name, a short title and its document."""

    name: str
    title: str
    document: Document


@dataclass(frozen=True)
class FigureCase:
    """One of the paper's surface figures: whose document, which layer of it, and which camera."""

    name: str
    preset: Preset
    layer: str
    camera: str


@cache
def _table() -> dict[str, Any]:
    return tomllib.loads(resource("presets.toml").read_text(encoding="utf-8"))


@cache
def presets() -> dict[str, Preset]:
    """Return every preset by name, in the paper's order."""
    return {name: preset(name) for name in _table()["presets"]}


@cache
def figure_cases() -> dict[str, FigureCase]:
    """Return every surface figure of the paper by name, in the paper's order."""
    return {
        name: FigureCase(name, preset(entry["preset"]), entry["layer"], entry["camera"])
        for name, entry in _table()["figures"].items()
    }


@cache
def curve_case() -> tuple[Array, Knots]:
    """Return the five points, (5, 3), and the knots of the curve of Figure 1."""
    entry = _table()["curve"]
    return read_only(np.array(entry["points"], dtype=np.float64)), Knots(**entry["knots"])


def network_case() -> Preset:
    """Return the preset whose curve network Figure 2 shows."""
    return preset(_table()["network"]["preset"])


@cache
def preset(name: str) -> Preset:
    """Return a preset by name.

    Raises
    ------
    SourceError : there is no such preset
    """
    table = _table()
    entry = table["presets"].get(name)
    if entry is None:
        known = ", ".join(table["presets"])
        raise SourceError(f"there is no preset '{name}'; expected one of {known}")
    x, y = np.meshgrid(np.arange(NET_SIZE), np.arange(NET_SIZE))
    curves = (Knots(**entry["knots"]),) * NET_SIZE
    net = np.stack([x, y, np.array(table["nets"][entry["net"]]["z"])], axis=-1)
    return Preset(name, entry["title"], Document(net, curves, curves))
