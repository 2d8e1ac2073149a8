"""What lies under a pixel, found by projection on the CPU. NumPy alone."""

from __future__ import annotations

import numpy as np

from qovr_app.view3d.scene.camera import Size
from qovr_app.view3d.scene.gizmo import gizmo_at
from qovr_app.view3d.scene.grip import Freedom
from qovr_app.view3d.scene.hand import MenuPlace, MenuWish
from qovr_app.view3d.scene.net_marks import Numbers, flags_of
from qovr_app.view3d.scene.occlusion import hidden_by
from qovr_app.view3d.scene.picture import Picture, is_in_colour_bar
from qovr_core.arrays import Array, Flags
from qovr_core.document import NetIndex

PICK_RADIUS = 10.0
"""Logical pixels around a point that belong to it: twice the disc, an easy target also for a trackpad."""

_SAME_PLACE = 0.5
"""Points closer than this many pixels lie on one another; the nearer to the viewer is meant."""

_LINE_REACH = 5.0
"""Logical pixels beside a line of the net that belong to it."""


def points_under(picture: Picture, size: Size, x: float, y: float) -> list[NetIndex]:
    """Return the control points under a pixel: the nearest on the screen first, then the nearest to the viewer.

    What the surface hides is picked only where one looks through it, or where it is selected already.
    """
    if not picture.settings.control_points:
        return []
    points = picture.scene.points
    seen = picture.camera.project(points.reshape(-1, 3), size)
    away = np.hypot(seen[:, 0] - x, seen[:, 1] - y)
    near = np.flatnonzero(away <= PICK_RADIUS)  # points behind the eye are NaN, and near to nothing
    near = near[np.lexsort((seen[near, 2], np.floor(away[near] / _SAME_PLACE)))]
    selected = flags_of(picture.selected, picture.scene.net_shape).ravel()[near]
    return _indices(picture, near[selected | ~_hidden(picture, size, near)])


def points_within(
    picture: Picture, size: Size, corner: tuple[float, float], other: tuple[float, float]
) -> list[NetIndex]:
    """Return the control points in a rectangle between two corners, without those that the surface hides."""
    if not picture.settings.control_points:
        return []
    (left, right), (top, bottom) = (sorted(ends) for ends in zip(corner, other, strict=True))
    x, y, _ = picture.camera.project(picture.scene.points.reshape(-1, 3), size).T
    within = np.flatnonzero((x >= left) & (x <= right) & (y >= top) & (y <= bottom))
    return _indices(picture, within[~_hidden(picture, size, within)])


def net_line_under(picture: Picture, size: Size, x: float, y: float) -> list[NetIndex]:
    """Return the control points of the row or column of the net whose line is under a pixel; none beside the net."""
    if not (picture.settings.control_net and picture.settings.control_points):
        return []
    rows, columns = picture.scene.net_shape
    seen = picture.camera.project(picture.scene.points, size)[..., :2]
    at = np.array([x, y])
    row_away, column_away = (_away(at, lines[:, :-1], lines[:, 1:]) for lines in (seen, seen.transpose(1, 0, 2)))
    row, column = int(np.argmin(row_away.min(axis=1))), int(np.argmin(column_away.min(axis=1)))
    if min(row_away.min(), column_away.min()) > _LINE_REACH:
        return []
    if row_away.min() <= column_away.min():
        return [(row, j) for j in range(columns)]
    return [(i, column) for i in range(rows)]


def gizmo_under(picture: Picture, size: Size, x: float, y: float) -> Freedom | None:
    """Return what a hand that takes the gizmo at a pixel may change; None where there is none."""
    if not picture.has_gizmo or picture.last_selected is None:
        return None
    gizmo = gizmo_at(picture.scene.points[picture.last_selected], picture.camera, size)
    return None if gizmo is None else gizmo.freedom_under(x, y)


def menu_wish(picture: Picture, size: Size, x: float, y: float) -> MenuWish:
    """Return for what a click with the right button at a pixel asks a menu."""
    if is_in_colour_bar(picture.settings, size, x):
        return MenuWish(MenuPlace.COLOUR_BAR, (x, y))
    points, line = points_under(picture, size, x, y), net_line_under(picture, size, x, y)
    if points:
        return MenuWish(MenuPlace.POINT, (x, y), tuple(points))
    return MenuWish(MenuPlace.NET_LINE, (x, y), tuple(line)) if line else MenuWish(MenuPlace.VIEW, (x, y))


def _hidden(picture: Picture, size: Size, numbers: Numbers) -> Flags:
    """Return which points, counted through the net, the surface keeps from the hand."""
    if picture.tools.xray or not len(numbers):
        return np.zeros(len(numbers), dtype=bool)
    return hidden_by(picture, picture.scene.points.reshape(-1, 3)[numbers], size)


def _indices(picture: Picture, numbers: Numbers) -> list[NetIndex]:
    """Return the indices of points that are counted through the net."""
    rows, columns = np.unravel_index(numbers, picture.scene.net_shape)
    return list(zip(rows.tolist(), columns.tolist(), strict=True))


def _away(at: Array, starts: Array, ends: Array) -> Array:
    """Return how far a pixel is from pieces of lines, (k, n); infinite where a piece is not before the eye."""
    ways = ends - starts
    lengths = np.maximum((ways**2).sum(axis=-1), np.finfo(np.float64).tiny)
    part = np.clip(((at - starts) * ways).sum(axis=-1) / lengths, 0.0, 1.0)
    gap = at - starts - part[..., None] * ways
    away = np.hypot(gap[..., 0], gap[..., 1])
    return np.where(np.isfinite(away), away, np.inf)
