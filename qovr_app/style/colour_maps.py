"""Colours as tables of 256 entries, shared by the surface and its colour bar."""

from __future__ import annotations

from functools import cache

import numpy as np
import numpy.typing as npt

from qovr_app.state.display import ColourMap
from qovr_core.arrays import Array, read_only
from qovr_core.colours import jet

ENTRIES = 256

_CIVIDIS = """
00224d 002655 00295e 002c67 003070 083370 16366f 1f3a6e 273d6d 2e416c 34446c 39486c 3f4b6b 444f6b 49526b 4e566c 52596c
575d6d 5b606e 60646e 64676f 686b71 6d6e72 717273 757575 797977 7e7d78 838078 878478 8c8878 918c77 968f77 9b9376 a09775
a59b73 aa9f72 afa370 b4a76f b9ab6d beb06a c4b468 c9b865 cebc62 d4c15e d9c55a dfca56 e4ce51 ead34c efd846 f5dc3f fbe136
fde737
"""
"""Every fifth of matplotlib's 256 colours: the first picture does not wait for that library to be loaded."""

DIVERGING = "RdBu_r"
"""For fields whose zero means something: white there, with lines around it on a light ground; signs at a glance."""


@cache
def colour_table(colour_map: str) -> npt.NDArray[np.uint8]:
    """Return red, green and blue of a ColourMap or of ``DIVERGING`` from low to high, (256, 3) uint8, read-only."""
    if colour_map == ColourMap.JET:
        return read_only(np.rint(255 * jet(np.arange(1, ENTRIES + 1) / ENTRIES)).astype(np.uint8))
    if colour_map == ColourMap.CIVIDIS:
        samples = np.array([list(bytes.fromhex(sample)) for sample in _CIVIDIS.split()])
        places = np.linspace(0, ENTRIES - 1, len(samples))
        channels = [np.interp(np.arange(ENTRIES), places, samples[:, channel]) for channel in range(3)]
        return read_only(np.rint(np.stack(channels, axis=1)).astype(np.uint8))
    from matplotlib import colormaps

    table = colormaps[str(colour_map)](np.arange(ENTRIES), bytes=True)
    return read_only(np.ascontiguousarray(table[:, :3]))


def colours_of(values: Array, low: float, high: float, colour_map: str) -> npt.NDArray[np.uint8]:
    """Return the colours of values (...), (..., 3) uint8; without extent everything has the middle colour."""
    extent = high - low
    part = (values - low) / extent if extent > 0 else np.full(np.shape(values), 0.5)
    return colour_table(colour_map)[np.clip(part * ENTRIES, 0, ENTRIES - 1).astype(np.intp)]
