"""Marks as rows of numbers, one a shape, that the vertex shader spreads over the viewport. NumPy alone.

A row has its kind and four by four numbers, in pixels of the device, as ``marks.vert`` reads them.
"""

from __future__ import annotations

import itertools
import math

import numpy as np
import numpy.typing as npt

from qovr_app.view3d.scene.marks import MANY, Cap, Discs, Ink, Lines, Pen, Photo, Polygon, Polyline, Rectangle
from qovr_core.arrays import Array

WIDTHS = (4, 4, 4, 4)
"""Numbers of each vertex attribute."""

BOX, DOT, POLYGON, SPRITE, PHOTO = range(5)
"""Kinds of shapes; a dot is a disc among very many, of one vertex."""

DEFINES = ("BOX", "DOT", "POLYGON", "SPRITE", "PHOTO")
"""What the shaders call them."""

Rows = npt.NDArray[np.float32]
Shape = Lines | Polyline | Polygon | Rectangle | Discs | Photo

_DASH, _GAP = 4.0, 2.0
"""Widths of a pen that its dashes and the gaps between them take, as Qt's painter has them."""

_SHARPEST = 0.1
"""Where two pieces of a line turn back on one another, what lies between them is no direction."""

_NOTHING = Ink((0, 0, 0), 0.0)


def shape_rows(mark: Shape, ratio: float) -> list[Rows]:
    """Return a mark as rows, the lowest first."""
    match mark:
        case Lines():
            return [_lines(mark.ends, mark.pen, ratio)]
        case Polyline():
            return [_polyline(mark.points, mark.pen, ratio)]
        case Discs():
            return [_discs(mark, ratio)]
        case Rectangle():
            return [_rectangle(mark, ratio)]
        case Photo():
            return [_cornered(PHOTO, mark.corners, Ink((0, 0, 0), mark.opacity), ratio)]
        case Polygon():
            outline = _lines(np.stack([mark.corners, np.roll(mark.corners, -1, axis=0)], axis=1), mark.pen, ratio)
            return [outline] if mark.fill is None else [_cornered(POLYGON, mark.corners, mark.fill, ratio), outline]


def sprite_rows(boxes: Array, corners: Array, opacities: Array) -> Rows:
    """Return images as rows.

    Parameters
    ----------
    boxes : (k, 4) left, top, right and bottom of where they go
    corners : (k, 2) where they begin in the atlas
    opacities : (k,)
    """
    rows = _rows(len(boxes))
    rows[:, :4], rows[:, 4], rows[:, 12:14], rows[:, 9] = boxes, SPRITE, corners, opacities
    return rows


def _rows(count: int) -> Rows:
    return np.zeros((count, sum(WIDTHS)), dtype=np.float32)


def _paint(rows: Rows, fill: Ink, rim: Ink = _NOTHING) -> None:
    rows[:, 8:12] = _number(fill), fill.opacity, _number(rim), rim.opacity


def _number(ink: Ink) -> int:
    """Return a colour as one number, which a float holds exactly."""
    red, green, blue = ink.colour
    return red | green << 8 | blue << 16


def _lines(ends: Array, pen: Pen, ratio: float) -> Rows:
    """Return lines (k, 2, 2) as rows."""
    if pen.is_dashed:
        ends = _dashes(ends, pen.width)
    start, way, width = ends[:, 0] * ratio, (ends[:, 1] - ends[:, 0]) * ratio, pen.width * ratio
    rows = _rows(len(ends))
    rows[:, :2], rows[:, 4], rows[:, 5] = start + way / 2, BOX, np.arctan2(way[:, 1], way[:, 0])
    rows[:, 2] = np.hypot(way[:, 0], way[:, 1]) / 2 + (0.0 if pen.cap is Cap.FLAT else width / 2)
    rows[:, 3], rows[:, 6] = width / 2, width / 2 if pen.cap is Cap.ROUND else 0.0
    _paint(rows, pen.ink)
    return rows


def _polyline(points: Array, pen: Pen, ratio: float) -> Rows:
    """Return the pieces of a line; each ends where the next one begins, for what is dim must not lie over itself."""
    rows = _lines(np.stack([points[:-1], points[1:]], axis=1), pen, ratio)
    angles = rows[:, 5].astype(np.float64)
    ways = np.stack([np.cos(angles), np.sin(angles)], axis=1)
    between = ways[:-1] + ways[1:]
    between[np.hypot(between[:, 0], between[:, 1]) < _SHARPEST] = 0.0
    rows[1:, 12:14], rows[:-1, 14:16] = _turned(between, ways[1:]), _turned(between, ways[:-1])
    return rows


def _turned(vectors: Array, ways: Array) -> Array:
    """Return vectors (k, 2) along and across the ways (k, 2)."""
    along = (vectors * ways).sum(axis=1)
    return np.stack([along, ways[:, 0] * vectors[:, 1] - ways[:, 1] * vectors[:, 0]], axis=1)


def _dashes(ends: Array, width: float) -> Array:
    """Return the dashes of lines (k, 2, 2), each of which goes on where the one before it ended."""
    found, gone = list[Array](), 0.0
    for start, end in ends:
        length = math.hypot(*(end - start))
        first, last = math.floor(gone / (_DASH + _GAP) / width), math.ceil((gone + length) / (_DASH + _GAP) / width)
        for k in range(first, last):
            begin = np.array([k * (_DASH + _GAP), k * (_DASH + _GAP) + _DASH]) * width - gone
            begin = begin.clip(0.0, length)
            if begin[1] > begin[0]:
                found.append(start + begin[:, None] / length * (end - start))
        gone += length
    return np.array(found).reshape(-1, 2, 2)


def _discs(discs: Discs, ratio: float) -> Rows:
    rows, radius, places = _rows(len(discs.places)), discs.radius * ratio, discs.places * ratio
    rows[:, 2:4], rows[:, 6] = radius, radius
    rows[:, :2], rows[:, 4] = (np.floor(places) + 0.5, DOT) if len(places) > MANY else (places, BOX)
    pen, fill = discs.pen or Pen(_NOTHING, 0.0), discs.fill or _NOTHING
    rows[:, 7] = pen.width * ratio
    _paint(rows, *(Ink(ink.colour, ink.opacity * discs.opacity) for ink in (fill, pen.ink)))
    return rows


def _rectangle(mark: Rectangle, ratio: float) -> Rows:
    rows, (left, top, width, height) = _rows(1), mark.box
    rows[0, :4] = np.array([left + width / 2, top + height / 2, width / 2, height / 2]) * ratio
    rows[0, 4:8] = BOX, 0.0, mark.radius * ratio, mark.pen.width * ratio
    _paint(rows, mark.fill, mark.pen.ink)
    return rows


def _cornered(kind: int, corners: Array, fill: Ink, ratio: float) -> Rows:
    rows = _rows(1)
    last = corners[-1] if len(corners) == 3 else corners[3]
    first = itertools.chain(corners[0], corners[1])
    rows[0, :4], rows[0, 4] = [at * ratio for at in first], kind
    rows[0, 12:14], rows[0, 14:16] = corners[2] * ratio, last * ratio
    _paint(rows, fill)
    return rows
