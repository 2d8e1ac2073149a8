"""Colours as tables of 256 entries, shared by the surface and its colour bar."""

from __future__ import annotations

from functools import cache

import numpy as np
import numpy.typing as npt

from qovr_app.state.display import ColourMap
from qovr_core.arrays import Array, read_only

ENTRIES = 256

DIVERGING = "RdBu_r"
"""For fields whose zero means something: white there, with lines around it on a light ground; signs at a glance."""


@cache
def colour_table(colour_map: str) -> npt.NDArray[np.uint8]:
    """Return red, green and blue of a ColourMap or of ``DIVERGING`` from low to high, (256, 3) uint8, read-only."""
    if colour_map == ColourMap.JET:
        return read_only(np.rint(255 * _matlab_jet(ENTRIES)).astype(np.uint8))
    from matplotlib import colormaps

    table = colormaps[str(colour_map)](np.arange(ENTRIES), bytes=True)
    return read_only(np.ascontiguousarray(table[:, :3]))


def _matlab_jet(count: int) -> Array:
    """Return MATLAB's ``jet(count)``: three trapezoids of unit slope over a quarter of the table."""
    quarter = count // 4
    rise = np.arange(1, quarter + 1) / quarter
    trapezoid = np.concatenate([rise, np.ones(quarter - 1), rise[::-1]])
    table = np.zeros((count, 3))
    first_green = (quarter + 1) // 2 - (count % 4 == 1)
    for channel, shift in ((0, quarter), (1, 0), (2, -quarter)):
        rows = first_green + shift + np.arange(trapezoid.size)
        kept = (rows >= 0) & (rows < count)
        table[rows[kept], channel] = trapezoid[kept]
    return table


def colours_of(values: Array, low: float, high: float, colour_map: str) -> npt.NDArray[np.uint8]:
    """Return the colours of values (...), (..., 3) uint8; without extent everything has the middle colour."""
    extent = high - low
    part = (values - low) / extent if extent > 0 else np.full(np.shape(values), 0.5)
    return colour_table(colour_map)[np.clip(part * ENTRIES, 0, ENTRIES - 1).astype(np.intp)]
