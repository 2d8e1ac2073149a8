"""The chords of the curve in focus, and its knots as handles on them."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from qovr_app.style.theme import KNOT_SERIES, Rgb
from qovr_app.view3d.painter.beside import Words, beside
from qovr_app.view3d.painter.text import NORMAL, lettered
from qovr_app.view3d.scene.camera import Size
from qovr_app.view3d.scene.hand import KnotMarks
from qovr_app.view3d.scene.knot_handles import KnotHandle, seen_handle
from qovr_app.view3d.scene.marks import Cap, Ink, Lines, Mark, Pen, Polygon, Runs
from qovr_app.view3d.scene.picture import Picture
from qovr_core.arrays import Array
from qovr_core.number_texts import number_text, signed_text, true_minus

_CHORD_WIDTH, _RIM = 1.3, 2.0
_RADIUS, _USED_RADIUS, _SMALL_RADIUS = 6.0, 7.5, 4.5
"""From the middle of a handle to its corners; that of s is small, where it is another place than that of u."""

_END_GAP = 7.0
"""Pixels at either end of a chord that are left to the control point there."""

_LETTER_AWAY = 15.0
_GHOST = 0.55
"""Opacity of the handle where it was when the drag began."""

_HELP = "type a value · Ctrl step · Shift fine · Esc back"
_HELP_OF_BOTH = "Ctrl lets s stay · type a value · Shift fine · Esc back"
_IMPOSSIBLE = "a knot lies between 0 and 1, and is neither"


def chords(picture: Picture, size: Size) -> Iterator[Mark]:
    """Yield the chords, under everything that a hand takes."""
    for handle in picture.knot_handles:
        ends = _seen(picture, handle.ends, size)
        length = float(np.hypot(*(ends[1] - ends[0])))
        if length > 2 * _END_GAP:  # and so no end is behind the eye
            gap = _END_GAP / length * (ends[1] - ends[0])
            ends = ends + np.array([gap, -gap])
            for colour, width in ((picture.theme.rim, _CHORD_WIDTH + _RIM), (_colour(handle, picture), _CHORD_WIDTH)):
                yield Lines(ends[None], Pen(Ink(colour), width, Cap.ROUND))


def knots(picture: Picture, size: Size) -> Iterator[Mark]:
    """Yield the handles, and the numbers of the one in the hand."""
    marks = picture.hand.knot if picture.hand else None
    for handle in picture.knot_handles:
        yield from _handle(picture, handle, marks, size)
    if marks is not None and marks.begun is not None:
        handle = next((each for each in picture.knot_handles if each.knot.place == marks.place), marks.begun)
        line, below = knot_text(handle, marks), _HELP_OF_BOTH if marks.begun.knot.takes_s else _HELP
        below = below if marks.is_new else ""
        words = Words(line, below) if marks.is_possible else Words(line, _IMPOSSIBLE, picture.theme.bad)
        yield from beside(picture, picture.scene.frame.to_unit(handle.point), words, size)


def knot_text(handle: KnotHandle, marks: KnotMarks) -> Runs:
    """Return which knot is in the hand, what it is now, and how far that is from what it was."""
    name: Runs = ((f"{handle.knot.place.letter}", False), ("ip", True))
    if handle.knot.takes_s:
        name = (*name, (" = s", False), ("ip", True))
    if marks.typed:
        return (*name, (f"  = {true_minus(marks.typed)}|", False))
    moved = "" if marks.begun is None else f" ({signed_text(handle.knot.value - marks.begun.knot.value)})"
    return (*name, (f"  {number_text(handle.knot.value)}{moved}", False))


def _handle(picture: Picture, handle: KnotHandle, marks: KnotMarks | None, size: Size) -> Iterator[Mark]:
    is_used = marks is not None and marks.place == handle.knot.place
    theme, colour = picture.theme, _colour(handle, picture)
    radius = _USED_RADIUS if is_used else _SMALL_RADIUS if handle.knot.place.name == "s" else _RADIUS
    if is_used and marks is not None and marks.begun is not None:
        ghost, _ = seen_handle(marks.begun, picture.scene.frame, picture.camera, size)
        yield from _diamond(ghost, _RADIUS, (theme.rim, colour, theme.background), _GHOST)
    at, aside = seen_handle(handle, picture.scene.frame, picture.camera, size)
    yield from _diamond(at, radius, (theme.rim, colour, colour if is_used else theme.background))
    if not np.isfinite(at).all() or (marks is not None and marks.begun is not None):
        return
    text: Runs = ((handle.knot.place.letter, False),)
    if is_used and marks is not None:
        text = knot_text(handle, marks)
    x, y = (at + _LETTER_AWAY * aside).tolist()
    yield lettered(text, (x, y), (0.5, 0.5), colour, pixels=NORMAL, halo=theme.rim)


def _diamond(at: Array, radius: float, colours: tuple[Rgb, Rgb, Rgb], opacity: float = 1.0) -> Iterator[Mark]:
    """Yield a diamond at a pixel in three colours: its rim, its line, its ground."""
    if not np.isfinite(at).all():
        return
    corners = at + radius * np.array([[0, -1], [1, 0], [0, 1], [-1, 0]])
    rim, line, ground = colours
    for colour, width in ((rim, 4.0), (line, 2.0)):
        yield Polygon(corners, Pen(Ink(colour, opacity), width), Ink(ground, opacity))


def _colour(handle: KnotHandle, picture: Picture) -> Rgb:
    return picture.theme.series[KNOT_SERIES[handle.knot.place.name]]


def _seen(picture: Picture, points: Array, size: Size) -> Array:
    """Return the pixels of points (..., 3) of the document, (..., 2)."""
    pixels: Array = picture.camera.project(picture.scene.frame.to_unit(points), size)[..., :2]
    return pixels
