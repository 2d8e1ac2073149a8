"""What lies under a pixel, found by projection on the CPU. NumPy alone."""

from __future__ import annotations

import numpy as np

from qovr_app.view3d.interaction.curve_picking import curve_under, points_of
from qovr_app.view3d.scene.camera import Size
from qovr_app.view3d.scene.gizmo import gizmo_at
from qovr_app.view3d.scene.grip import Freedom
from qovr_app.view3d.scene.hand import MenuPlace, MenuWish
from qovr_app.view3d.scene.joints import has_windows
from qovr_app.view3d.scene.knot_handles import KnotHandle, seen_handle
from qovr_app.view3d.scene.net_flags import flags_of
from qovr_app.view3d.scene.net_marks import Numbers
from qovr_app.view3d.scene.occlusion import hidden_by
from qovr_app.view3d.scene.picture import Picture, is_in_colour_bar
from qovr_app.view3d.scene.probing import parameters_under, window_at
from qovr_core.arrays import Flags
from qovr_core.document import NetIndex, Window

PICK_RADIUS = 10.0
"""Logical pixels around a point that belong to it: twice the disc, an easy target also for a trackpad."""

_HANDLE_REACH = 9.0
"""Logical pixels around the handle of a knot that belong to it."""

_SAME_PLACE = 0.5
"""Points closer than this many pixels lie on one another; the nearer to the viewer is meant."""


def points_under(picture: Picture, size: Size, x: float, y: float) -> list[NetIndex]:
    """Return the control points under a pixel: the nearest on the screen first, then the nearest to the viewer.

    What the surface hides is picked only where one looks through it, or where it is selected already.
    """
    if not picture.settings.control_points:
        return []
    seen = picture.camera.project(picture.net_points.reshape(-1, 3), size)
    away = np.hypot(seen[:, 0] - x, seen[:, 1] - y)
    near = np.flatnonzero(away <= PICK_RADIUS)  # points behind the eye or put away are NaN, and near to nothing
    near = near[np.lexsort((seen[near, 2], np.floor(away[near] / _SAME_PLACE)))]
    selected = flags_of(picture.selected, picture.scene.net_shape).ravel()[near]
    return _indices(picture, near[selected | ~_hidden(picture, size, near)])


def chosen_of(points: list[NetIndex], picture: Picture) -> NetIndex:
    """Return the point of several in one place that a press means: one that is selected, or else the first."""
    if picture.last_selected in points:
        return picture.last_selected
    return next((index for index in points if index in picture.selected), points[0])


def points_within(
    picture: Picture, size: Size, corner: tuple[float, float], other: tuple[float, float]
) -> list[NetIndex]:
    """Return the control points in a rectangle between two corners, without those that the surface hides."""
    if not picture.settings.control_points:
        return []
    (left, right), (top, bottom) = (sorted(ends) for ends in zip(corner, other, strict=True))
    x, y, _ = picture.camera.project(picture.net_points.reshape(-1, 3), size).T
    within = np.flatnonzero((x >= left) & (x <= right) & (y >= top) & (y <= bottom))
    return _indices(picture, within[~_hidden(picture, size, within)])


def gizmo_under(picture: Picture, size: Size, x: float, y: float) -> Freedom | None:
    """Return what a hand that takes the gizmo at a pixel may change; None where there is none."""
    if not picture.has_gizmo or picture.last_selected is None:
        return None
    gizmo = gizmo_at(picture.scene.points[picture.last_selected], picture.camera, size)
    return None if gizmo is None else gizmo.freedom_under(x, y)


def menu_wish(picture: Picture, size: Size, x: float, y: float) -> MenuWish:
    """Return for what a click with the right button at a pixel asks a menu."""
    if is_in_colour_bar(picture.settings, size, x):
        return MenuWish(MenuPlace.COLOUR_BAR)
    handle = handle_under(picture, size, x, y)
    if handle is not None:
        return MenuWish(MenuPlace.KNOT, knot=handle.knot.place)
    points, curve = points_under(picture, size, x, y), curve_under(picture, size, x, y)
    if points:
        return MenuWish(MenuPlace.POINT, tuple(points))
    if curve is not None:
        return MenuWish(MenuPlace.NET_LINE, points_of(picture, curve), curve)
    return MenuWish(MenuPlace.VIEW)


def window_under(picture: Picture, size: Size, x: float, y: float) -> Window | None:
    """Return the window of the net whose surface is seen at a pixel; None beside it, and where there is only one."""
    scene = picture.scene
    if not picture.settings.surface or not has_windows(scene):
        return None
    found = parameters_under(scene, picture.camera, size, x, y)
    return None if found is None else window_at(scene.surface, found)[0]


def handle_under(picture: Picture, size: Size, x: float, y: float) -> KnotHandle | None:
    """Return the handle of a knot under a pixel; None where there is none."""
    handles = picture.knot_handles
    if not handles:
        return None
    frame, camera = picture.scene.frame, picture.camera
    seen = np.stack([seen_handle(handle, frame, camera, size)[0] for handle in handles])
    away = np.nan_to_num(np.hypot(seen[:, 0] - x, seen[:, 1] - y), nan=np.inf)  # no number is behind the eye
    nearest = int(np.argmin(away))
    return handles[nearest] if away[nearest] <= _HANDLE_REACH else None


def _hidden(picture: Picture, size: Size, numbers: Numbers) -> Flags:
    """Return which points, counted through the net, the surface keeps from the hand."""
    if picture.tools.xray or not len(numbers):
        return np.zeros(len(numbers), dtype=bool)
    return hidden_by(picture, picture.scene.points.reshape(-1, 3)[numbers], size)


def _indices(picture: Picture, numbers: Numbers) -> list[NetIndex]:
    """Return the indices of points that are counted through the net."""
    rows, columns = np.unravel_index(numbers, picture.scene.net_shape)
    return list(zip(rows.tolist(), columns.tolist(), strict=True))
