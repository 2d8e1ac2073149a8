"""What lies over the surface: boxes, control net, curves, points, labels, colour bar.

One function draws it on the screen, in the painter's fallback and in figures. What the surface hides is
drawn dim, so that it can still be seen and picked.
"""

from __future__ import annotations

import itertools
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
from PySide6.QtCore import QLineF, QPointF, Qt
from PySide6.QtGui import QColor, QPainter, QPen, QPolygonF

from qovr_app.state.display import Style
from qovr_app.style.theme import Rgb
from qovr_app.view3d.painter.colour_bar import draw_colour_bar
from qovr_app.view3d.painter.note import draw_note
from qovr_app.view3d.painter.readout import draw_readout
from qovr_app.view3d.painter.text import NORMAL, draw_text, plain, text_size
from qovr_app.view3d.scene.camera import Size
from qovr_app.view3d.scene.frame import Frame
from qovr_app.view3d.scene.occlusion import Occluder
from qovr_app.view3d.scene.picture import Picture, has_colour_bar
from qovr_core.arrays import Array
from qovr_core.document import NET_SIZE

POINT_RADIUS = 4.5
_MARKED_RADIUS, _RING_RADIUS = 6.0, 10.0
_LABEL_OFFSET = (6.0, -4.0)
_LABEL_ROOM = (24.0, 13.0)
"""Logical pixels across a label and down: one that begins within these of another would lie on it."""

_PIECES = 8
"""Pieces of a net or box edge: where the surface hides it is found to an eighth of its length."""

_NET_WIDTH, _CURVE_WIDTH, _BOX_WIDTH, _RIVAL_WIDTH = 1.0, 1.8, 1.0, 1.2
_LEGEND, _LEGEND_LINE, _LEGEND_GAP = (14.0, 20.0), 22.0, 20.0
"""Where the legend of a surface drawn over another begins without a caption, its line, and its distance from one."""
_HIDDEN = 0.3
"""Opacity of what the surface hides."""

_HIDDEN_LABEL = 0.45
_OPAQUE_STYLES = (Style.FACETS, Style.SMOOTH)


def draw_overlay(painter: QPainter, picture: Picture, size: Size) -> None:
    """Draw everything that lies over the surface; the painter's units are logical pixels."""
    if picture.scene is None:
        return
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    lines = _lines(picture)
    points = picture.scene.points.reshape(-1, 3)
    marks = np.concatenate([*(family.points.reshape(-1, 3) for family in lines), points])
    seen, hidden = picture.camera.project(marks, size)[:, :2], _hidden(picture, marks, size)
    start = 0
    for family in lines:
        shape = family.points.shape[:2]
        stop = start + shape[0] * shape[1]
        _draw_family(painter, family, seen[start:stop].reshape(*shape, 2), hidden[start:stop].reshape(shape))
        start = stop
    if picture.settings.control_points:
        _draw_points(painter, picture, seen[start:], hidden[start:])
    if picture.settings.labels:
        _draw_labels(painter, picture, seen[start:], hidden[start:])
    if picture.scene.rival_name:
        _draw_legend(painter, picture)
    if has_colour_bar(picture.settings, size):
        draw_colour_bar(painter, picture, size)
    if picture.settings.surface and picture.colouring.note:
        draw_note(painter, picture.colouring.note, picture.theme, size)
    if picture.probed is not None:
        draw_readout(painter, picture, size)


@dataclass(frozen=True, eq=False)
class _Family:
    """Polylines (k, n, 3) of the unit space that look alike; every ``straight`` pieces lie on one line."""

    points: Array
    colour: Rgb
    width: float
    straight: int = 1


def _lines(picture: Picture) -> list[_Family]:
    """Return the lines to draw, lowest first."""
    settings, scene, theme = picture.settings, picture.scene, picture.theme
    families = []
    if settings.control_box:
        edges = _box_edges(scene.frame, scene.control_box)
        families.append(_Family(edges, theme.accent, _BOX_WIDTH, _PIECES))
    if settings.surface_box:
        edges = _box_edges(scene.frame, scene.surface_box)
        families.append(_Family(edges, theme.axis, _BOX_WIDTH, _PIECES))
    if settings.control_net:
        families.append(_Family(_net_lines(scene.points), theme.net, _NET_WIDTH, _PIECES))
    if settings.row_curves:
        families.append(_Family(scene.row_curves, theme.row_curve, _CURVE_WIDTH))
    if settings.column_curves:
        families.append(_Family(scene.column_curves, theme.column_curve, _CURVE_WIDTH))
    if len(scene.rival_lines):
        families.append(_Family(scene.rival_lines, theme.comparison, _RIVAL_WIDTH))
    return families


def _divided(corners: Array) -> Array:
    """Return polylines (k, n, 3) with every straight piece cut into ``_PIECES``."""
    part = np.arange(_PIECES)[:, None] / _PIECES
    starts, ends = corners[:, :-1, None], corners[:, 1:, None]
    pieces = (starts + (ends - starts) * part).reshape(len(corners), -1, 3)
    return np.concatenate([pieces, corners[:, -1:]], axis=1)


def _net_lines(points: Array) -> Array:
    return _divided(np.concatenate([points, points.transpose(1, 0, 2)]))


def _box_edges(frame: Frame, box: Array) -> Array:
    corners = np.array(list(itertools.product(*frame.to_unit(box.T).T)))
    pairs = [(a, a | bit) for a in range(8) for bit in (1, 2, 4) if not a & bit]
    return _divided(corners[np.array(pairs)])


def _hidden(picture: Picture, marks: Array, size: Size) -> npt.NDArray[np.bool_]:
    """Return which marks (k, 3) the surface hides, in one query; nothing where one can look through it."""
    if not picture.settings.surface or picture.settings.style not in _OPAQUE_STYLES:
        return np.zeros(len(marks), dtype=bool)
    return Occluder(picture.scene.patch, picture.camera, size).hidden(marks)


def _draw_family(painter: QPainter, family: _Family, seen: Array, hidden: npt.NDArray[np.bool_]) -> None:
    """Draw polylines (k, n, 2), dim where both ends of a piece are hidden."""
    whole = np.isfinite(seen).all(axis=(1, 2))
    seen, dim = seen[whole], (hidden[:, :-1] & hidden[:, 1:])[whole]
    ends = np.ones((*dim.shape[:1], dim.shape[1] + 1), dtype=bool)
    ends[:, 1:-1] = dim[:, 1:] != dim[:, :-1]
    if family.straight > 1:
        ends[:, :: family.straight] = True
    for is_dim in (True, False):
        ink = QColor(*family.colour)
        ink.setAlphaF(_HIDDEN if is_dim else 1.0)
        painter.setPen(
            QPen(ink, family.width, Qt.PenStyle.SolidLine, Qt.PenCapStyle.RoundCap, Qt.PenJoinStyle.RoundJoin)
        )
        straight = []
        for line, stops, dims in zip(seen.tolist(), ends, dim.tolist(), strict=True):
            for start, stop in itertools.pairwise(np.flatnonzero(stops).tolist()):
                if dims[start] != is_dim:
                    continue
                if family.straight > 1:
                    straight.append(QLineF(*line[start], *line[stop]))
                else:
                    run = [QPointF(x, y) for x, y in line[start : stop + 1]]
                    painter.drawPolyline(QPolygonF(run))
        painter.drawLines(straight)


def _draw_legend(painter: QPainter, picture: Picture) -> None:
    """Say whose lines lie over the surface."""
    theme, (x, y) = picture.theme, _LEGEND
    if picture.caption:
        x += text_size(plain(picture.caption), NORMAL)[0] + _LEGEND_GAP
    painter.setPen(QPen(QColor(*theme.comparison), 2 * _RIVAL_WIDTH))
    painter.drawLine(QLineF(x, y, x + _LEGEND_LINE, y))
    text = plain(picture.scene.rival_name)
    draw_text(painter, text, (x + _LEGEND_LINE + 7, y), (0, 0.5), theme.ink, pixels=NORMAL, halo=theme.rim)


def _draw_labels(painter: QPainter, picture: Picture, seen: Array, hidden: npt.NDArray[np.bool_]) -> None:
    """Name the points; where they crowd, those marked and then those in front have the right of way."""
    theme, taken = picture.theme, []
    marked = [index for index in (picture.selected, picture.hovered) if index is not None]
    first = [i * NET_SIZE + j for i, j in marked]
    order = [*first, *np.flatnonzero(~hidden).tolist(), *np.flatnonzero(hidden).tolist()]
    for k in dict.fromkeys(order):
        if not np.isfinite(seen[k]).all():
            continue
        x, y = (seen[k] + _LABEL_OFFSET).tolist()
        if any(abs(x - a) < _LABEL_ROOM[0] and abs(y - b) < _LABEL_ROOM[1] for a, b in taken):
            continue
        taken.append((x, y))
        runs = (("P", False), (f"{k // NET_SIZE},{k % NET_SIZE}", True))
        opacity = _HIDDEN_LABEL if hidden[k] and k not in first else 1.0
        ink = theme.accent if k in first else theme.ink
        draw_text(painter, runs, (x, y), (0, 0.75), ink, halo=theme.rim, opacity=opacity)


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
            painter.setPen(QPen(QColor(*theme.accent), 2.4))
            painter.setBrush(QColor(*theme.rim))
            painter.drawEllipse(centre, _RING_RADIUS, _RING_RADIUS)
        painter.setPen(QPen(QColor(*theme.rim), 1.4))
        painter.setBrush(QColor(*theme.accent))
        radius = _MARKED_RADIUS if marked else POINT_RADIUS
        painter.drawEllipse(centre, radius, radius)
    painter.setOpacity(1.0)
