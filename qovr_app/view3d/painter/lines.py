"""The lines over the surface: boxes, control net, curves, and the lines of another surface."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np

from qovr_app.style.theme import Rgb
from qovr_app.view3d.scene.camera import Size
from qovr_app.view3d.scene.combs import combs_along
from qovr_app.view3d.scene.curve_lines import FEW
from qovr_app.view3d.scene.frame import Frame
from qovr_app.view3d.scene.joints import has_windows, joint_lines, outline
from qovr_app.view3d.scene.marks import Cap, Ink, Lines, Mark, Pen, Polyline
from qovr_app.view3d.scene.net_marks import gaps, shown_part
from qovr_app.view3d.scene.picture import Picture
from qovr_app.view3d.scene.sections import section_lines
from qovr_core.arrays import Array, Flags

_PIECES, _LINE_PIECES = 8, 48
"""Pieces of a net or box edge, and of a whole line of the net: where the surface hides one is found to a piece."""

_LEAST_GAP, _LEAST_LINES = 8.0, 32
"""Pixels between lines of a net, which are fewer where more would be a grey ground; but never fewer than so many."""

_NET_WIDTH, _CURVE_WIDTH, _BOX_WIDTH, _COMPARISON_WIDTH = 1.0, 1.8, 1.0, 1.2
_SMOOTH_WIDTH, _SHARP_WIDTH, _FOCUS_WIDTH = 1.2, 2.4, 2.4
_TOOTH_WIDTH, _TIPS_WIDTH, _SECTION_WIDTH = 0.7, 1.3, 2.4
_GONE = 2
"""What a piece of a line is that cannot be drawn, beside dim, 1, and not, 0."""

_NET = "Control net"
_HIDDEN = 0.3
"""Opacity of what the surface hides."""


@dataclass(frozen=True, eq=False)
class Family:
    """Polylines (k, n, 3) of the unit space that look alike; every ``straight`` pieces lie on one line.

    ``name`` says in a legend what they are; the letters after ``_`` are a subscript.
    """

    points: Array
    colour: Rgb
    width: float
    straight: int = 1
    name: str = ""

    @property
    def needs_name(self) -> bool:
        """Whether nobody who sees them knows what they are, as of the control net."""
        return self.name not in ("", _NET)


def lines_of(picture: Picture, size: Size) -> list[Family]:
    """Return the lines to draw, lowest first."""
    settings, scene, theme = picture.settings, picture.scene, picture.theme
    found = []
    if settings.control_box:
        edges = _box_edges(scene.frame, scene.control_box)
        found.append(Family(edges, theme.series[4], _BOX_WIDTH, _PIECES, "Box of the points"))
    if settings.surface_box:
        edges = _box_edges(scene.frame, scene.surface_box)
        found.append(Family(edges, theme.axis, _BOX_WIDTH, _PIECES, "Box of the surface"))
    if settings.control_net:
        for net in _net_lines(picture, size):
            straight = max(1, min(_PIECES, _LINE_PIECES // (max(scene.net_shape) - 1)))
            found.append(Family(_divided(net, straight), theme.net, _NET_WIDTH, straight, _NET))
    if settings.row_curves:
        curves = _curves(picture, size, scene.row_curves, picture.net_points)
        found.append(Family(curves, theme.row_curve, _CURVE_WIDTH, name="C_i(u)"))
    if settings.column_curves:
        curves = _curves(picture, size, scene.column_curves, picture.net_points.transpose(1, 0, 2))
        found.append(Family(curves, theme.column_curve, _CURVE_WIDTH, name="K_j(v)"))
    found += _joints(picture, size) + _combs(picture)
    if settings.section is not None:
        name, pieces = section_lines(scene, settings.section)
        found += [Family(piece[None], theme.section, _SECTION_WIDTH, name=name) for piece in pieces]
    if len(scene.lines):
        found.append(Family(scene.lines, theme.comparison, _COMPARISON_WIDTH, name=scene.lines_name))
    return found


def _curves(picture: Picture, size: Size, curves: Array, net: Array) -> Array:
    """Return the curves of the lines of a net (k, l, 3) of which some point is shown, fewer where they crowd."""
    curves = curves[np.isfinite(net[..., 0]).any(axis=1)]
    if len(curves) <= _LEAST_LINES:
        return curves
    return _some(curves, gaps(picture.camera.project(net, size))[1])[:, :: FEW if picture.moving else 1]


def _joints(picture: Picture, size: Size) -> list[Family]:
    """Return the joints of a net's windows and the outline of the one in focus; of small ones only what is rare."""
    scene, theme, found = picture.scene, picture.theme, list[Family]()
    if not picture.settings.joints or not has_windows(scene):
        return found
    corners, joints = scene.window_corners, joint_lines(scene)
    gap = min(gaps(picture.camera.project(corners, size)))
    if gap >= _LEAST_GAP:
        found += [Family(each, theme.smooth_joint, _SMOOTH_WIDTH, name="Smooth joint") for each in joints.smooth]
    if picture.window is not None:
        found.append(Family(outline(scene, picture.window), theme.selected, _FOCUS_WIDTH, name="Window in focus"))
    for each in joints.sharp:  # over the outline, as in the map: else a crease beside the window would not be seen
        found.append(Family(_some(each, gap), theme.sharp_joint, _SHARP_WIDTH, name="Sharp joint"))
    if gap < FEW * _LEAST_GAP:  # one piece is then enough for so many
        found = [replace(lines, points=lines.points[:, ::FEW]) for lines in found]
    return found


def _combs(picture: Picture) -> list[Family]:
    """Return the teeth of curvature combs and the lines along their tips."""
    settings, theme = picture.settings, picture.theme
    found = []
    for is_shown, is_u, colour in (
        (settings.combs_u, True, theme.comparison),
        (settings.combs_v, False, theme.series[2]),
    ):
        if is_shown:
            combs, name = combs_along(picture.scene, is_u=is_u, scale=settings.comb_scale), f"Comb along {'vu'[is_u]}"
            found += [Family(combs.teeth, colour, _TOOTH_WIDTH), Family(combs.tips, colour, _TIPS_WIDTH, name=name)]
    return found


def line_marks(lines: Family, seen: Array, hidden: Flags) -> Iterator[Mark]:
    """Yield polylines at pixels (k, n, 2), dim where both ends of a piece are hidden, (k, n).

    Pieces of which an end is no number are left out.
    """
    is_there: Flags = np.isfinite(seen[..., 0])
    kinds = np.where(is_there[:, :-1] & is_there[:, 1:], hidden[:, :-1] & hidden[:, 1:], _GONE)
    ends = np.ones((len(kinds), kinds.shape[1] + 1), dtype=bool)
    ends[:, 1:-1] = kinds[:, 1:] != kinds[:, :-1]
    if lines.straight > 1:
        ends[:, :: lines.straight] = True
    for is_dim in (True, False):
        pen = Pen(Ink(lines.colour, _HIDDEN if is_dim else 1.0), lines.width, Cap.ROUND)
        straight = []
        for line, stops, kind in zip(seen, ends, kinds.tolist(), strict=True):
            for start, stop in itertools.pairwise(np.flatnonzero(stops).tolist()):
                if kind[start] != is_dim:
                    continue
                if lines.straight > 1:
                    straight.append(line[[start, stop]])
                else:
                    yield Polyline(line[start : stop + 1], pen)
        if straight:
            yield Lines(np.array(straight), pen)


def _divided(corners: Array, count: int = _PIECES) -> Array:
    """Return polylines (k, n, 3) with every straight piece cut into so many."""
    part = np.arange(count)[:, None] / count
    starts, ends = corners[:, :-1, None], corners[:, 1:, None]
    pieces = starts + (ends - starts) * part
    pieces[:, :, :1] = starts  # also where the end is not shown, and no number
    return np.concatenate([pieces.reshape(len(corners), -1, 3), corners[:, -1:]], axis=1)


def _net_lines(picture: Picture, size: Size) -> list[Array]:
    """Return rows and columns of the net (k, l, 3) as polylines: in one array where they are equally long."""
    part = shown_part(picture)
    points = part.of(picture.net_points)
    rows, columns = points, points.transpose(1, 0, 2)
    if max(points.shape) > _LEAST_LINES:
        across, along = gaps(picture.camera.project(points, size))
        rows, columns = _some(rows, along), _some(columns, across)
    return [np.concatenate([rows, columns])] if rows.shape[1:] == columns.shape[1:] else [rows, columns]


def _some(lines: Array, gap: float) -> Array:
    """Return every 2nd, 4th, ... line and the last one where they are seen so many pixels apart."""
    wanted = _LEAST_GAP / max(gap, _LEAST_GAP / len(lines))
    step = 2 ** min(math.ceil(math.log2(max(1.0, wanted))), (len(lines) // _LEAST_LINES).bit_length() - 1)
    return lines[np.unique(np.append(np.arange(0, len(lines), step), len(lines) - 1))] if step > 1 else lines


def _box_edges(frame: Frame, box: Array) -> Array:
    corners = np.array(list(itertools.product(*frame.to_unit(box.T).T)))
    pairs = [(a, a | bit) for a in range(8) for bit in (1, 2, 4) if not a & bit]
    return _divided(corners[np.array(pairs)])
