"""Which curve lies under a pixel: by a line of the control net, or by the curve itself where it is drawn."""

from __future__ import annotations

import numpy as np

from qovr_app.view3d.scene.camera import Size
from qovr_app.view3d.scene.picture import Picture
from qovr_core.arrays import Array
from qovr_core.document import NetIndex
from qovr_core.edits import knots_of
from qovr_core.geometry.knots import Direction, KnotPlace
from qovr_core.geometry.windows import STEP

_LINE_REACH = 5.0
"""Logical pixels beside a line that belong to it."""

_FIRST_KNOT = "u"
"""The knot that is turned to with a curve: the one that every other of it has to do with."""


def curve_under(picture: Picture, size: Size, x: float, y: float) -> KnotPlace | None:
    """Return the curve under a pixel, by its knot u; None where there is none."""
    settings, scene, at = picture.settings, picture.scene, np.array([x, y])
    families: list[tuple[Direction, Array, bool]] = []
    if settings.control_net and settings.control_points:
        points = picture.net_points
        families += [(Direction.ROWS, points, True), (Direction.COLUMNS, points.transpose(1, 0, 2), True)]
    if settings.row_curves:
        families.append((Direction.ROWS, scene.row_curves, False))
    if settings.column_curves:
        families.append((Direction.COLUMNS, scene.column_curves, False))
    nearest, found = _LINE_REACH, None
    for direction, lines, is_net in families:
        seen = picture.camera.project(lines, size)[..., :2]
        away = _away(at, seen[:, :-1], seen[:, 1:])
        if away.min() < nearest:
            number, piece = np.unravel_index(int(np.argmin(away)), away.shape)
            windows = knots_of(scene.document, direction).windows
            window = _window_of_piece(int(piece), away.shape[1], windows, is_net=is_net)
            nearest, found = float(away.min()), KnotPlace(direction, int(number), _FIRST_KNOT, window)
    return found


def _window_of_piece(piece: int, pieces: int, windows: int, *, is_net: bool) -> int:
    """Return the window of a piece of a line: of the net's, which begins and ends a step beyond, or of a curve."""
    if is_net:
        return min(max((piece - 1) // STEP, 0), windows - 1)
    return piece * windows // pieces


def points_of(picture: Picture, curve: KnotPlace) -> tuple[NetIndex, ...]:
    """Return the control points of the line of the net that belongs to a curve."""
    rows, columns = picture.scene.net_shape
    if curve.direction is Direction.ROWS:
        return tuple((curve.curve, j) for j in range(columns))
    return tuple((i, curve.curve) for i in range(rows))


def _away(at: Array, starts: Array, ends: Array) -> Array:
    """Return how far a pixel is from pieces of lines, (k, n); infinite where a piece is not before the eye."""
    ways = ends - starts
    lengths = np.maximum((ways**2).sum(axis=-1), np.finfo(np.float64).tiny)
    part = np.clip(((at - starts) * ways).sum(axis=-1) / lengths, 0.0, 1.0)
    gap = at - starts - part[..., None] * ways
    away = np.hypot(gap[..., 0], gap[..., 1])
    return np.where(np.isfinite(away), away, np.inf)
