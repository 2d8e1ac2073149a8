"""Colours as tables of 256 entries, shared by the surface and its colour bar."""

from __future__ import annotations

from functools import cache

import numpy as np
import numpy.typing as npt

from qovr_app.state.display import ColourMap
from qovr_core.arrays import Array, read_only
from qovr_core.colours import jet

ENTRIES = 256

DIVERGING = "RdBu_r"
"""For fields whose zero means something: white there, with lines around it on a light ground; signs at a glance."""


@cache
def colour_table(colour_map: str) -> npt.NDArray[np.uint8]:
    """Return red, green and blue of a ColourMap or of ``DIVERGING`` from low to high, (256, 3) uint8, read-only."""
    if colour_map == ColourMap.JET:
        return read_only(np.rint(255 * jet(np.arange(1, ENTRIES + 1) / ENTRIES)).astype(np.uint8))
    from matplotlib import colormaps

    table = colormaps[str(colour_map)](np.arange(ENTRIES), bytes=True)
    return read_only(np.ascontiguousarray(table[:, :3]))


def colours_of(values: Array, low: float, high: float, colour_map: str) -> npt.NDArray[np.uint8]:
    """Return the colours of values (...), (..., 3) uint8; without extent everything has the middle colour."""
    extent = high - low
    part = (values - low) / extent if extent > 0 else np.full(np.shape(values), 0.5)
    return colour_table(colour_map)[np.clip(part * ENTRIES, 0, ENTRIES - 1).astype(np.intp)]
