"""Colours from low to high: MATLAB's jet."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from qovr_core.arrays import Array

Colours = npt.NDArray[np.float32]
"""Colours end in 8 or 16 bits."""

_PLATEAU = np.float32(1.5)
_PEAKS = np.array([3, 2, 1], dtype=np.float32)
"""Four times the parts at which red, green and blue are in the middle of their plateaus."""

_SRGB_LINEAR_END = 0.04045


def height_colours(heights: Array, low: float, high: float) -> Colours:
    """Return the colours of heights (k,) between two ends as sRGB, (k, 3) from 0 to 1; a flat surface is green."""
    extent = high - low
    return jet((heights - low) * (1 / extent) if extent > 0 else np.full(heights.shape, 0.5))


def jet(parts: Array) -> Colours:
    """Return the colours at parts (k,) of the way from low to high as sRGB, (k, 3) from 0 to 1."""
    colours = np.subtract.outer((4 * parts).astype(np.float32), _PEAKS)
    np.abs(colours, out=colours)
    np.subtract(_PLATEAU, colours, out=colours)
    return np.clip(colours, 0, 1, out=colours)


def linear(colours: Colours) -> Colours:
    """Return sRGB colours as linear light, IEC 61966-2-1."""
    result: Colours = np.where(colours <= _SRGB_LINEAR_END, colours / 12.92, ((colours + 0.055) / 1.055) ** 2.4)
    return result
