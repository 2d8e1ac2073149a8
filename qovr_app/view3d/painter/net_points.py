"""The control points over the surface, and their names."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import QPointF
from PySide6.QtGui import QColor, QPainter, QPen

from qovr_app.style.canvas import dimmed
from qovr_app.view3d.painter.text import draw_text
from qovr_app.view3d.scene.picture import Picture
from qovr_core.arrays import Array, Flags
from qovr_core.document import NetIndex

POINT_RADIUS = 4.5
_MARKED_RADIUS, _RING_RADIUS = 6.0, 10.0
_RING_WIDTH, _THIN_RING_WIDTH = 2.4, 1.2
"""Of the point that was selected last, and of the others with it."""

_LABEL_OFFSET = (6.0, -4.0)
_LABEL_ROOM = (24.0, 13.0)
"""Logical pixels across a label and down: one that begins within these of another would lie on it."""

_HIDDEN = 0.45
"""Opacity of points and names that the surface hides."""


def draw_points(painter: QPainter, picture: Picture, seen: Array, hidden: Flags) -> None:
    """Draw the control points at pixels (k, l, 2), dim where they are hidden, (k, l)."""
    theme, marked = picture.theme, set(_marked(picture))
    for index in np.ndindex(hidden.shape):
        x, y = seen[index].tolist()
        if not np.isfinite(x):
            continue
        centre = QPointF(x, y)
        with dimmed(painter, _HIDDEN if hidden[index] and index not in marked else 1.0):
            if index in picture.selected:
                width = _RING_WIDTH if index == picture.last_selected else _THIN_RING_WIDTH
                painter.setPen(QPen(QColor(*theme.accent), width))
                painter.setBrush(QColor(*theme.rim))
                painter.drawEllipse(centre, _RING_RADIUS, _RING_RADIUS)
            painter.setPen(QPen(QColor(*theme.rim), 1.4))
            painter.setBrush(QColor(*theme.accent))
            radius = _MARKED_RADIUS if index in marked else POINT_RADIUS
            painter.drawEllipse(centre, radius, radius)


def draw_labels(painter: QPainter, picture: Picture, seen: Array, hidden: Flags) -> None:
    """Name the points; where they crowd, those marked and then those in front have the right of way."""
    theme, marked, taken = picture.theme, _marked(picture), list[tuple[float, float]]()
    in_front, behind = ([(i, j) for i, j in np.argwhere(flags).tolist()] for flags in (~hidden, hidden))
    for i, j in dict.fromkeys([*marked, *in_front, *behind]):
        if not np.isfinite(seen[i, j]).all():
            continue
        x, y = (seen[i, j] + _LABEL_OFFSET).tolist()
        if any(abs(x - a) < _LABEL_ROOM[0] and abs(y - b) < _LABEL_ROOM[1] for a, b in taken):
            continue
        taken.append((x, y))
        is_marked = (i, j) in marked
        opacity = _HIDDEN if hidden[i, j] and not is_marked else 1.0
        ink = theme.accent if is_marked else theme.ink
        runs = (("P", False), (f"{i},{j}", True))
        draw_text(painter, runs, (x, y), (0, 0.75), ink, halo=theme.rim, opacity=opacity)


def _marked(picture: Picture) -> list[NetIndex]:
    """Return the points that stand out, the one that was selected last first."""
    marked = (picture.last_selected, picture.hovered, *sorted(picture.selected))
    return list(dict.fromkeys(index for index in marked if index is not None))
