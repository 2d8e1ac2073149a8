"""What can colour the surface: the fields of the core, and patterns that its normals and the camera make together.

A pattern is what a surface mirrors of a striped room, or how far its normals turn from the viewer. Here it is made for
the painter, per cell; the fragment shader of the surface does the same for every pixel, with these numbers.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from qovr_app.state.display import UNCOLOURED
from qovr_app.style.theme import Rgb
from qovr_core.arrays import Array, Flags
from qovr_core.fields import FIELDS, Field
from qovr_core.registry import Record, Registry

STRIPE = 15.0
"""Degrees of reflection from one dark stripe to the next: few enough to follow, enough to show a kink."""

BAND = 10.0
"""Degrees between isophotes: round, so that they can be counted."""

LARGEST_ANGLE = 90.0

LIGHT_STRIPE: Rgb = (244, 245, 247)
DARK_STRIPE: Rgb = (66, 72, 84)
BELOW: Rgb = (92, 70, 112)
BELOW_PART = 0.42
"""The colour that tints what is seen from below, and how much of it is seen."""

CLAY: Rgb = (206, 198, 186)


_BANDS = round(LARGEST_ANGLE / BAND)


@dataclass(frozen=True, eq=False)
class Pattern(Record):
    """What colours the surface without being a field of it.

    Parameters
    ----------
    name, title, text, tip : as of a ``Field``
    define : the part of the surface's fragment shader that draws it
    parts : called with unit normals (k, 3) and unit vectors toward the eye (k, 3), both in the camera's axes, it
        returns where in the colours the pattern lies, (k,) from 0 to 1
    bar : the parts of the colours that the colour bar shows in equal steps, from below; none where there is no bar
    ticks : the numbers beside the bar, from its lower end to its upper one; none for a pattern without numbers
    colours : its own colours from the lower to the upper end; none where it takes those of the settings
    """

    name: str
    title: str
    text: str
    tip: str
    define: str
    parts: Callable[[Array, Array], Array]
    bar: tuple[float, ...]
    ticks: tuple[float, ...] = ()
    colours: tuple[Rgb, ...] = ()

    table: ClassVar[Registry[Pattern]]


PATTERNS = Pattern.table = Registry[Pattern]("pattern")
"""All patterns, in the order in which they are offered after the fields."""


def colour_sources() -> dict[str, Field | Pattern]:
    """Return everything that can colour the surface by its name, in the order in which it is offered."""
    return {**FIELDS, **PATTERNS}


def zebra_is_light(normals: Array, toward: Array) -> Flags:
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
    is_light: Flags = np.abs(np.degrees(np.arccos(np.clip(up, -1, 1))) / STRIPE % 1 - 0.5) > 0.25
    return is_light


def isophote_parts(normals: Array, toward: Array) -> Array:
    """Return where in the colours the bands of equal angle between normal and line of sight lie, (k,), 0 to 1.

    Parameters are those of ``zebra_is_light``; a normal and its opposite are the same.
    """
    facing = np.clip(np.abs(np.einsum("kd,kd->k", normals, toward)), 0, 1)
    bands = np.floor(np.degrees(np.arccos(facing)) / BAND)
    last = _BANDS - 1
    parts: Array = np.minimum(bands, last) / last
    return parts


PATTERNS.register(
    Pattern(
        "zebra",
        "Zebra stripes",
        "&Zebra stripes",
        "What the shape as shown mirrors of a striped room; choose equal scales for the true shape",
        define="ZEBRA",
        parts=lambda normals, toward: zebra_is_light(normals, toward).astype(np.float64),
        bar=(0.0, 1.0, 0.0, 1.0, 0.0, 1.0, 0.0),
        colours=(DARK_STRIPE, LIGHT_STRIPE),
    )
)
PATTERNS.register(
    Pattern(
        "isophotes",
        "Normal to view, degrees",
        "&Isophotes",
        "Bands of equal angle between normal and line of sight, of the shape as shown; choose equal scales for the "
        "true shape",
        define="ISOPHOTES",
        parts=isophote_parts,
        bar=tuple(np.linspace(0.0, 1.0, _BANDS).tolist()),
        ticks=tuple((BAND * np.arange(_BANDS + 1)).tolist()),
    )
)
PATTERNS.register(
    Pattern(
        UNCOLOURED,
        "",
        "&None",
        "One colour, which says nothing: what is seen is shape",
        define="UNCOLOURED",
        parts=lambda normals, _toward: np.zeros(len(normals)),
        bar=(),
        colours=(CLAY,),
    )
)
PATTERNS.seal()
