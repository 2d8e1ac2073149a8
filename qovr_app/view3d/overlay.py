"""What lies over the surface: boxes, control net, curves, points, labels, colour bar.

One function draws it on the screen, in the painter's fallback and in figures. What the surface hides is
drawn dim, so that it can still be seen and picked.
"""

from __future__ import annotations

import itertools

import numpy as np
import numpy.typing as npt
from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QColor, QPainter, QPen, QPolygonF

from qovr_app.view3d.camera import Size
from qovr_app.view3d.colourbar import draw_colour_bar
from qovr_app.view3d.frame import Frame
from qovr_app.view3d.occlusion import Occluder
from qovr_app.view3d.picture import Picture, has_colour_bar
from qovr_app.view3d.text import draw_text
from qovr_app.view3d.theme import Rgb
from qovr_core.arrays import Array
from qovr_core.document import NET_SIZE

POINT_RADIUS = 4.5
_MARKED_RADIUS = 6.5
_LABEL_OFFSET = (6.0, -4.0)
_NET_PIECES = 8
"""Pieces of a net or box edge: where the surface hides it is found to an eighth of its length."""

_NET_WIDTH, _CURVE_WIDTH, _BOX_WIDTH = 1.2, 1.8, 1.0
_HIDDEN = 0.3
"""Opacity of what the surface hides."""

_HIDDEN_LABEL = 0.45


def draw_overlay(painter: QPainter, picture: Picture, size: Size) -> None:
    """Draw everything that lies over the surface; the painter's units are logical pixels."""
    if picture.scene is None:
        return
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    settings, theme = picture.settings, picture.theme
    lines = _lines(picture)
    points = picture.scene.points.reshape(-1, 3)
    hidden = _hidden(picture, size, [*(curve for curves, _, _ in lines for curve in curves), points])
    for curves, colour, width in lines:
        for curve in curves:
            seen = picture.camera.project(curve, size)[:, :2]
            _draw_line(painter, seen, next(hidden), colour, width)
    seen = picture.camera.project(points, size)[:, :2]
    hidden_points = next(hidden)
    if settings.control_points:
        _draw_points(painter, picture, seen, hidden_points)
    if settings.labels:
        for k, (place, dim) in enumerate(zip(seen.tolist(), hidden_points.tolist(), strict=True)):
            if np.isfinite(place).all():
                at = (place[0] + _LABEL_OFFSET[0], place[1] + _LABEL_OFFSET[1])
                runs = (("P", False), (f"{k // NET_SIZE},{k % NET_SIZE}", True))
                opacity = _HIDDEN_LABEL if dim else 1.0
                draw_text(painter, runs, at, (0, 0.75), theme.ink, halo=theme.rim, opacity=opacity)
    if has_colour_bar(settings, size):
        draw_colour_bar(painter, picture, size)


def _lines(picture: Picture) -> list[tuple[Array, Rgb, float]]:
    """Return the polylines (k, n, 3) of the unit space to draw, with colour and width, lowest first."""
    settings, scene, theme = picture.settings, picture.scene, picture.theme
    lines = []
    if settings.control_box:
        lines.append((_box_edges(scene.frame, scene.control_box), theme.accent, _BOX_WIDTH))
    if settings.surface_box:
        lines.append((_box_edges(scene.frame, scene.surface_box), theme.axis, _BOX_WIDTH))
    if settings.control_net:
        lines.append((_net_lines(scene.points), theme.net, _NET_WIDTH))
    if settings.row_curves:
        lines.append((scene.row_curves, theme.row_curve, _CURVE_WIDTH))
    if settings.column_curves:
        lines.append((scene.column_curves, theme.column_curve, _CURVE_WIDTH))
    return lines


def _divided(corners: Array) -> Array:
    """Return polylines (k, n, 3) with every straight piece cut into ``_NET_PIECES``."""
    part = np.arange(_NET_PIECES)[:, None] / _NET_PIECES
    starts, ends = corners[:, :-1, None], corners[:, 1:, None]
    pieces = (starts + (ends - starts) * part).reshape(len(corners), -1, 3)
    return np.concatenate([pieces, corners[:, -1:]], axis=1)


def _net_lines(points: Array) -> Array:
    return _divided(np.concatenate([points, points.transpose(1, 0, 2)]))


def _box_edges(frame: Frame, box: Array) -> Array:
    corners = np.array(list(itertools.product(*frame.to_unit(box.T).T)))
    pairs = [(a, a | bit) for a in range(8) for bit in (1, 2, 4) if not a & bit]
    return _divided(corners[np.array(pairs)])


def _hidden(picture: Picture, size: Size, marks: list[Array]) -> itertools.chain[npt.NDArray[np.bool_]]:
    """Return for each array (n, 3) of marks which of them the surface hides, in one query."""
    if not picture.settings.surface:
        return iter([np.zeros(len(part), dtype=bool) for part in marks])
    occluder = Occluder(picture.scene.patch, picture.camera, size)
    hidden = occluder.hidden(np.concatenate(marks))
    return iter(np.split(hidden, np.cumsum([len(part) for part in marks])[:-1]))


def _draw_line(
    painter: QPainter, seen: Array, hidden: npt.NDArray[np.bool_], colour: Rgb, width: float
) -> None:
    """Draw a polyline (n, 2) in runs, dim where both ends of a piece are hidden."""
    if not np.isfinite(seen).all():
        return
    dim = hidden[:-1] & hidden[1:]
    turns = [0, *(np.flatnonzero(dim[1:] != dim[:-1]) + 1).tolist(), len(dim)]
    points = [QPointF(x, y) for x, y in seen.tolist()]
    for start, stop in itertools.pairwise(turns):
        ink = QColor(*colour)
        ink.setAlphaF(_HIDDEN if dim[start] else 1.0)
        pen = QPen(ink, width, Qt.PenStyle.SolidLine, Qt.PenCapStyle.FlatCap, Qt.PenJoinStyle.RoundJoin)
        painter.setPen(pen)
        painter.drawPolyline(QPolygonF(points[start : stop + 1]))


def _draw_points(painter: QPainter, picture: Picture, seen: Array, hidden: npt.NDArray[np.bool_]) -> None:
    theme = picture.theme
    for k, (x, y) in enumerate(seen.tolist()):
        if not np.isfinite(x):
            continue
        index = divmod(k, NET_SIZE)
        marked = index in (picture.selected, picture.hovered)
        centre = QPointF(x, y)
        painter.setOpacity(_HIDDEN_LABEL if hidden[k] and not marked else 1.0)
        if index == picture.selected:
            painter.setPen(QPen(QColor(*theme.accent), 2.0))
            painter.setBrush(QColor(*theme.rim))
            painter.drawEllipse(centre, _MARKED_RADIUS + 2, _MARKED_RADIUS + 2)
        painter.setPen(QPen(QColor(*theme.rim), 1.4))
        painter.setBrush(QColor(*theme.accent))
        radius = _MARKED_RADIUS if marked else POINT_RADIUS
        painter.drawEllipse(centre, radius, radius)
    painter.setOpacity(1.0)
