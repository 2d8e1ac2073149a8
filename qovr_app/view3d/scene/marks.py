"""What lies behind and over the surface, as values. OpenGL draws them in the view, the painter in figures and without.

Places and lengths are logical pixels, x to the right and y downward from the upper left corner of the viewport.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum
from typing import Any, NamedTuple, Protocol

from qovr_app.style.theme import Rgb
from qovr_core.arrays import Array

Place = tuple[float, float]

Runs = tuple[tuple[str, bool], ...]
"""Pieces of a text, each with whether it is a subscript."""

Alignment = tuple[float, float]
"""Where the anchor lies in the text's box: (0, 0) upper left, (0.5, 0.5) in the middle, (1, 1) lower right."""


MANY = 300
"""Discs above which each lies at whole pixels of the device, where very many are equal and fast to draw."""


class Cap(Enum):
    """How a line ends: at its ends, half its width beyond them, or rounded there."""

    FLAT = "flat"
    SQUARE = "square"
    ROUND = "round"


class Ink(NamedTuple):
    """A colour and how opaque it is."""

    colour: Rgb
    opacity: float = 1.0


class Pen(NamedTuple):
    """How lines look."""

    ink: Ink
    width: float
    cap: Cap = Cap.SQUARE
    is_dashed: bool = False


class Box(NamedTuple):
    """An upright rectangle."""

    left: float
    top: float
    width: float
    height: float


@dataclass(frozen=True, eq=False)
class Lines:
    """Lines (k, 2, 2)."""

    ends: Array
    pen: Pen


@dataclass(frozen=True, eq=False)
class Polyline:
    """A line through points (n, 2), n > 1, that is rounded where it bends."""

    points: Array
    pen: Pen


@dataclass(frozen=True, eq=False)
class Polygon:
    """A convex polygon with corners (k, 2), k = 3 or 4."""

    corners: Array
    pen: Pen
    fill: Ink | None


@dataclass(frozen=True, eq=False)
class Rectangle:
    """A rectangle whose corners are rounded by a radius."""

    box: Box
    radius: float
    pen: Pen
    fill: Ink


@dataclass(frozen=True, eq=False)
class Discs:
    """Equal discs about places (k, 2); the opacity is that of each as a whole."""

    places: Array
    radius: float
    pen: Pen | None
    fill: Ink | None
    opacity: float = 1.0


@dataclass(frozen=True, eq=False)
class Photo:
    """A picture from a file, laid by perspective onto four corners (4, 2): the upper left one first, then clockwise."""

    path: str
    corners: Array
    opacity: float


@dataclass(frozen=True)
class Lettering:
    """A text with everything that decides its pixels, but for the device's ratio.

    Parameters
    ----------
    pixels : size of the letters
    halo : what parts them from the ground; None for nothing
    upright : from below to above
    """

    runs: Runs
    colour: Rgb
    pixels: int
    halo: Rgb | None = None
    upright: bool = False


class Text(NamedTuple):
    """A lettering with its anchor at a place."""

    lettering: Lettering
    anchor: Place
    alignment: Alignment
    opacity: float = 1.0


class Drawing(Protocol):
    """What a painter knows to draw; two that are equal look alike."""

    def __hash__(self) -> int: ...

    def paint(self, painter: Any) -> None:
        """Paint it in units of its own, with Qt's painter."""


class Strip(NamedTuple):
    """A drawing, such as a colour bar, that changes more rarely than the picture around it.

    Parameters
    ----------
    box : which part of the drawing it shows, in the drawing's units
    larger : logical pixels a unit has; the strip lies at the box's place times this
    """

    drawing: Drawing
    box: Box
    larger: float


Mark = Lines | Polyline | Polygon | Rectangle | Discs | Photo | Text | Strip
"""What is drawn, each over those before it."""
