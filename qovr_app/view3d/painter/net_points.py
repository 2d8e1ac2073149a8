"""The control points over the surface, and their names."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from qovr_app.style.theme import Rgb
from qovr_app.view3d.painter.colour_bar import bar_room
from qovr_app.view3d.painter.legend import Room
from qovr_app.view3d.painter.text import SMALL, lettered, text_size
from qovr_app.view3d.scene.camera import Size
from qovr_app.view3d.scene.marks import Discs, Ink, Mark, Pen, Runs
from qovr_app.view3d.scene.net_flags import flags_of
from qovr_app.view3d.scene.net_marks import LAST, MANY, OTHER, NetPart, covers, is_within, levels, ranks, with_room
from qovr_app.view3d.scene.picture import Picture, emphasis, has_colour_bar
from qovr_app.view3d.scene.triad import REACH, has_triad, triad_centre
from qovr_core.arrays import Array, Flags
from qovr_core.document import NetIndex

POINT_RADIUS = 4.5
_LEAST_RADIUS, _PART_OF_GAP = 1.0, 0.22
"""Where the points of a net crowd their discs are smaller, so that the surface is seen between them."""

_MARKED_RADIUS, _HALO_RADIUS, _RING_RADIUS = 6.0, 8.5, 10.0
_RING_WIDTH, _RIM = 2.4, 1.4

_LABEL_OFFSET = (6.0, -4.0)
_LABEL_RISE = 0.75
"""Part of a name's height that lies above its anchor."""

_CROWDED, _MOST_ROOM = 1.5, 3.0
"""Names need this many times their width between points, or they take up to so many times their room."""

_HIDDEN, _SEEN_THROUGH = 0.45, 0.75
"""Opacity of points that the surface hides: as a rule, and where one looks through it."""


@dataclass(frozen=True, eq=False)
class SeenNet:
    """The control points as they are seen.

    Parameters
    ----------
    shape : of the net, rows and columns
    part : which of its points they are
    at : (k, l, 2) their pixels
    hidden : (k, l) whether the surface hides them
    """

    shape: tuple[int, int]
    part: NetPart
    at: Array
    hidden: Flags

    @cached_property
    def gap(self) -> float:
        """Pixels between neighbours of the whole net, in the direction in which there are more."""
        return max(self.part.gaps(self.at))

    @property
    def is_thinned(self) -> bool:
        """Whether the net has points that are not among them."""
        return self.hidden.shape != self.shape

    def flags(self, points: frozenset[NetIndex]) -> Flags:
        """Return which of them are among some points of the net, (k, l)."""
        return self.part.of(flags_of(points, self.shape))


def net_points(picture: Picture, net: SeenNet, size: Size) -> Iterator[Mark]:
    """Yield the control points, dim where they are hidden."""
    theme, larger, seen, hidden = picture.theme, emphasis(size), net.at, net.hidden
    radius = larger * _radius(net.gap)
    selected, is_seen = net.flags(picture.selected), is_within(seen, size)
    dim = _SEEN_THROUGH if picture.tools.xray else _HIDDEN
    for points, halo in ((picture.pending, theme.pending), (picture.refused, theme.bad)):
        flags = net.flags(points) & is_seen
        yield from _discs(seen[flags], larger * _HALO_RADIUS, halo, theme.rim)
    for flags, opacity in ((hidden & ~selected, dim), (~hidden & ~selected, 1.0)):
        yield from _discs(seen[flags & is_seen], radius, theme.point, theme.rim, opacity)
    scale, chosen = max(radius, 2 * _LEAST_RADIUS) / POINT_RADIUS, seen[selected & is_seen]
    yield from _discs(chosen, _RING_RADIUS * scale, theme.rim, theme.selected)
    yield from _discs(chosen, _MARKED_RADIUS * scale, theme.selected, theme.rim)
    for index in (picture.last_selected, picture.hovered):
        if index is None:
            continue
        at = net.part.place(index)
        if not is_seen[at]:
            continue
        if index == picture.last_selected:
            pen = Pen(Ink(_ring_colour(picture, index)), _RING_WIDTH)
            yield Discs(seen[at][None], larger * _RING_RADIUS, pen, Ink(theme.rim))
        colour = theme.selected if selected[at] else theme.point
        yield from _discs(seen[at][None], larger * _MARKED_RADIUS, colour, theme.rim)


def _discs(places: Array, radius: float, fill: Rgb, rim: Rgb, opacity: float = 1.0) -> Iterator[Mark]:
    """Yield discs, where there are some, with a rim that is narrow where they are small."""
    if len(places):
        yield Discs(places, radius, Pen(Ink(rim), min(_RIM, radius / 2)), Ink(fill), opacity)


def _ring_colour(picture: Picture, index: NetIndex) -> Rgb:
    """Return the colour of the ring around the point picked last, which says what is typed over it."""
    theme = picture.theme
    if index in picture.refused:
        return theme.bad
    return theme.pending if index in picture.pending else theme.selected


def _radius(gap: float) -> float:
    return round(min(POINT_RADIUS, max(_LEAST_RADIUS, _PART_OF_GAP * gap)), 1)


def point_labels(picture: Picture, net: SeenNet, size: Size, legend: Room | None) -> Iterator[Mark]:
    """Yield the names of the points that are visible, hovered or selected, as far as they have room.

    Parameters
    ----------
    legend : where it lies
    """
    seen, hidden, part, (rows, columns) = net.at, net.hidden, net.part, net.shape
    theme, rank, level = picture.theme, part.of(ranks(picture)), part.of(levels((rows, columns)))
    wanted = (rank != OTHER) | ~hidden
    i, j = np.nonzero(wanted & is_within(seen, size))
    if not len(i):
        return
    order = np.lexsort((-level[i, j], rank[i, j]))
    i, j = i[order], j[order]
    larger, rank = emphasis(size), rank[i, j]
    pixels, offset = round(larger * SMALL), larger * np.array(_LABEL_OFFSET)
    width, height = text_size(_name(rows - 1, columns - 1), pixels)
    taken = np.array([*_taken(picture, size), *([legend] if legend else [])])
    discs = _disc_boxes(picture, net, size, larger)
    # The name of a selected point begins beside its ring, and is away from the arrows where it has some.
    beside = offset[0] + np.where(rank != OTHER, larger * _RING_RADIUS, 0.0)
    at = seen[i, j] + [0.0, offset[1] - _LABEL_RISE * height]
    corners = _beside(at, beside, (width, height), (rank == LAST) & picture.has_gizmo, (discs, taken))
    is_wanted = (rank != OTHER) | ~covers(corners, (width, height), discs)
    i, j, rank, corners = part.rows[i[is_wanted]], part.columns[j[is_wanted]], rank[is_wanted], corners[is_wanted]
    more = float(np.clip(_CROWDED * width / max(net.gap, _LEAST_RADIUS), 1.0, _MOST_ROOM))
    marked = int((rank != OTHER).sum())
    chosen, opacities = with_room(corners, (more * width, more * height), taken, marked)
    for number, opacity in zip(chosen.tolist(), opacities.tolist(), strict=True):
        is_marked = number < marked
        ink = theme.selected if is_marked and (i[number], j[number]) != picture.hovered else theme.ink
        at = tuple(corners[number].tolist())
        name = _name(i[number], j[number])
        yield lettered(name, at, (0, 0), ink, pixels=pixels, halo=theme.rim, opacity=opacity)


def _beside(at: Array, beside: Array, room: tuple[float, float], turns: Flags, ground: tuple[Array, Array]) -> Array:
    """Return the upper left corners of names: at the right of their points, or at the left where that helps.

    Parameters
    ----------
    at, beside : (k, 2) points, the height that of a name's upper side; (k,) how far from them names begin
    turns : which stand at the left in any case
    ground : what they should not cover, and what they cannot
    """
    discs, taken = ground
    right, left = at.copy(), at.copy()
    right[:, 0] += beside
    left[:, 0] -= room[0] + beside
    for in_the_way in (np.concatenate([discs, taken]), taken):
        turns = turns | (covers(right, room, in_the_way) & ~covers(left, room, in_the_way))
    corners: Array = np.where(turns[:, None], left, right)
    return corners


def _disc_boxes(picture: Picture, net: SeenNet, size: Size, larger: float) -> Array:
    """Return the boxes of the discs, which only the name of a marked point covers, (m, 4); none where they are many."""
    places = net.at[is_within(net.at, size)]
    if not picture.settings.control_points or len(places) > MANY or net.is_thinned:
        return np.empty((0, 4))
    reach = larger * _radius(net.gap)
    return np.concatenate([places - reach, places + reach], axis=1)


def _taken(picture: Picture, size: Size) -> list[Room]:
    """Return what no name may cover, by left, top, right and bottom: what is beside the viewport, colour bar, triad."""
    taken: list[Room] = [(size[0], 0.0, math.inf, size[1])]
    taken += [bar_room(size)] if has_colour_bar(picture.settings, size) else []
    if picture.hand is not None and has_triad(picture.settings, size):
        x, y = triad_centre(size)
        taken.append((x - REACH, y - REACH, x + REACH, y + REACH))
    return taken


def _name(i: int, j: int) -> Runs:
    return (("P", False), (f"{i},{j}", True))
