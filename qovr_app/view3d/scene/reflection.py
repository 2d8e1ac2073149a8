"""Patterns of reflection: what a surface mirrors of a striped room, and how far its normals turn from the viewer.

Here for the painter, per cell; the fragment shader of the surface does the same for every pixel, with these numbers.
"""

from __future__ import annotations

import numpy as np

from qovr_app.style.theme import Rgb
from qovr_core.arrays import Array

STRIPE = 15.0
"""Degrees of reflection from one dark stripe to the next: few enough to follow, enough to show a kink."""

BAND = 10.0
"""Degrees between isophotes: round, so that they can be counted."""

LARGEST_ANGLE = 90.0

LIGHT_STRIPE: Rgb = (244, 245, 247)
DARK_STRIPE: Rgb = (66, 72, 84)


def zebra_is_light(normals: Array, toward: Array) -> Array:
    """Return whether the reflection of the line of sight falls into a light stripe.

    Parameters
    ----------
    normals : (k, 3) unit vectors in the camera's axes: right, up, toward the viewer
    toward : (k, 3) unit vectors toward the eye, in the same axes

    Returns
    -------
    (k,) bool
    """
    up = 2 * np.einsum("kd,kd->k", normals, toward) * normals[:, 1] - toward[:, 1]
    return np.abs(np.degrees(np.arccos(np.clip(up, -1, 1))) / STRIPE % 1 - 0.5) > 0.25


def isophote_parts(normals: Array, toward: Array) -> Array:
    """Return where in the colours the bands of equal angle between normal and line of sight lie, (k,), 0 to 1.

    Parameters are those of ``zebra_is_light``; a normal and its opposite are the same.
    """
    facing = np.clip(np.abs(np.einsum("kd,kd->k", normals, toward)), 0, 1)
    bands = np.floor(np.degrees(np.arccos(facing)) / BAND)
    last = LARGEST_ANGLE / BAND - 1
    return np.minimum(bands, last) / last
