"""What the mouse does, over the picture: gizmo, handles, guide line, ghost, numbers of a drag, the rectangle."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from qovr_app.state.names import AXES
from qovr_app.style.theme import Rgb, Theme
from qovr_app.view3d.painter.beside import Words, beside
from qovr_app.view3d.painter.knot_handles import chords, knots
from qovr_app.view3d.painter.text import lettered, plain
from qovr_app.view3d.scene.camera import Size
from qovr_app.view3d.scene.gizmo import gizmo_at
from qovr_app.view3d.scene.grip import Freedom, across, along
from qovr_app.view3d.scene.hand import Band, DragMarks
from qovr_app.view3d.scene.marks import Cap, Discs, Ink, Lines, Mark, Pen, Polygon, Runs
from qovr_app.view3d.scene.picture import Picture
from qovr_core.arrays import Array
from qovr_core.number_texts import USUAL_DIGITS, rounded_text, signed_text, true_minus

_ARROW_WIDTH, _USED_WIDTH = 2.2, 3.6
_HEAD = 11.0
_SQUARE_OPACITY, _USED_OPACITY, _BAND_OPACITY = 0.35, 0.8, 0.12

_GUIDE_REACH = 1.6
"""Unit lengths of a guide line both ways: beyond the axes box wherever it begins."""

_GHOST_RADIUS = 5.0
_HELP = "type a value · Ctrl step · Shift fine · X Y Z lock · Esc back"


def axis_colours(theme: Theme) -> tuple[Rgb, Rgb, Rgb]:
    """Return the colours of the axes x, y and z."""
    red, _, green, blue, _ = theme.series
    return red, green, blue


def hand_marks(picture: Picture, size: Size) -> Iterator[Mark]:
    """Yield what is seen of the mouse, if anything is."""
    hand = picture.hand
    if hand is None:
        return
    yield from chords(picture, size)
    if hand.drag is not None:
        yield from _way(picture, hand.drag, size)
    if picture.has_gizmo and picture.last_selected is not None:
        at = picture.last_selected if hand.drag is None else hand.drag.indices[0]
        yield from _gizmo(picture, picture.scene.points[at], hand.freedom, size)
    yield from knots(picture, size)
    if hand.drag is not None:
        yield from _numbers(picture, hand.drag, size)
    if hand.band is not None:
        yield _band(hand.band, picture.theme)


def _gizmo(picture: Picture, point: Array, used: Freedom | None, size: Size) -> Iterator[Mark]:
    gizmo = gizmo_at(point, picture.camera, size)
    if gizmo is None:
        return
    colours = axis_colours(picture.theme)
    for axis, corners in gizmo.squares.items():
        ground = Ink(colours[axis], _USED_OPACITY if used == across(axis) else _SQUARE_OPACITY)
        yield Polygon(corners, Pen(Ink(colours[axis]), 1.0), ground)
    for axis, ends in gizmo.arrows.items():
        width = _USED_WIDTH if used == along(axis) else _ARROW_WIDTH
        way = ends[1] - ends[0]
        way = way / np.hypot(*way)
        neck, side = ends[1] - _HEAD * way, 0.4 * _HEAD * np.array([-way[1], way[0]])
        for colour, extra in ((picture.theme.rim, 2.0), (colours[axis], 0.0)):
            yield Lines(np.array([[ends[0], neck]]), Pen(Ink(colour), width + extra, Cap.ROUND))
        head = np.array([ends[1], neck + side, neck - side])
        yield Polygon(head, Pen(Ink(picture.theme.rim), 1.0), Ink(colours[axis]))
        x, y = (ends[1] + 9.0 * way).tolist()
        yield lettered(plain(AXES[axis].upper()), (x, y), (0.5, 0.5), colours[axis], halo=picture.theme.rim)


def _way(picture: Picture, drag: DragMarks, size: Size) -> Iterator[Mark]:
    """Yield the lines along which the point moves, and where the points were."""
    theme, frame = picture.theme, picture.scene.frame
    here, colours = picture.scene.points[drag.indices[0]], axis_colours(theme)
    for number, way in enumerate(drag.ways):
        parts = np.linspace(-_GUIDE_REACH, _GUIDE_REACH, 33)[:, None]
        seen = picture.camera.project(here + parts * way, size)[:, :2]
        seen = seen[np.isfinite(seen).all(axis=1)]
        if len(seen) > 1:
            colour = colours[drag.freedom.axes[number]] if drag.freedom.axes else theme.accent
            yield Lines(seen[None, [0, -1]], Pen(Ink(colour), 1.4, is_dashed=True))
    for at in picture.camera.project(frame.to_unit(drag.begun), size)[:, :2]:
        if np.isfinite(at[0]):
            for colour, width in ((theme.rim, 3.4), (theme.accent, 1.4)):
                yield Discs(at[None], _GHOST_RADIUS, Pen(Ink(colour), width), None)


def drag_text(picture: Picture, drag: DragMarks) -> tuple[Runs, str]:
    """Return the name of what is dragged, and the numbers that change, with how far they are from where they were."""
    (i, j), others = drag.indices[0], len(drag.indices) - 1
    name: Runs = (("P", False), (f"{i},{j}", True))
    if others:
        name = (*name, (f" and {others} more", False))
    now = picture.scene.document.control_points[i, j]
    moved = now - drag.begun[0]
    if drag.freedom.along_way:
        text = f"along the normal {signed_text(float(np.linalg.norm(moved)))}" if not drag.typed else ""
    else:
        text = "  ".join(
            f"{AXES[axis]} {rounded_text(now[axis], USUAL_DIGITS)} ({signed_text(moved[axis])})"
            for axis in drag.freedom.axes
        )
    if drag.typed:
        way = AXES[drag.freedom.axis] if drag.freedom.axis is not None else "along the normal"
        text = f"{way} {'by' if drag.is_difference else '='} {true_minus(drag.typed)}|"
    return name, text


def _numbers(picture: Picture, drag: DragMarks, size: Size) -> Iterator[Mark]:
    """Say beside the point where it is."""
    name, numbers = drag_text(picture, drag)
    point = picture.scene.points[drag.indices[0]]
    words = Words((*name, (f"   {numbers}", False)), _HELP if drag.is_new else "")
    return beside(picture, point, words, size)


def _band(band: Band, theme: Theme) -> Mark:
    left, top, right, bottom = band
    corners = np.array([[left, top], [right, top], [right, bottom], [left, bottom]])
    return Polygon(corners, Pen(Ink(theme.accent), 1.0, is_dashed=True), Ink(theme.accent, _BAND_OPACITY))
