"""Colours by height: MATLAB's jet."""

from __future__ import annotations

import numpy as np

from qovr_core.arrays import Array

_PEAKS = np.array([3.0, 2.0, 1.0])
"""Four times the heights at which red, green and blue are in the middle of their plateaus."""

_SRGB_LINEAR_END = 0.04045


def height_colours(heights: Array, low: float, high: float) -> Array:
    """Return the colours of heights (k,) between two ends as sRGB, (k, 3) from 0 to 1; a flat surface is green."""
    extent = high - low
    part = (heights - low) / extent if extent > 0 else np.full(heights.shape, 0.5)
    colours: Array = np.clip(1.5 - np.abs(4 * part[:, None] - _PEAKS), 0.0, 1.0)
    return colours


def linear(colours: Array) -> Array:
    """Return sRGB colours as linear light, IEC 61966-2-1."""
    result: Array = np.where(colours <= _SRGB_LINEAR_END, colours / 12.92, ((colours + 0.055) / 1.055) ** 2.4)
    return result
