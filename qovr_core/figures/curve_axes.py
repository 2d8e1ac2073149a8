"""The axes in which a curve is drawn: frame, scales, legend, and names that lie clear of lines."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from qovr_core.figures.style import halo
from qovr_core.laboratory.curve_names import FLATTEST, name_centres, named_places, seen_points
from qovr_core.laboratory.one_curve import PARABOLA_LETTERS, OneCurve
from qovr_core.laboratory.planes import Plane
from qovr_core.number_texts import MINUS

SERIES = ("#c9392b", "#be7000", "#148458", "#1c64d8", "#803eb2")
"""The colours of P_0..P_4; Q_p, w_p and its parameter take that of the point P_{p+1} at their knot."""

PARTS = SERIES[1:4]
INK, QUIET, WARN = "#20242a", "#70767f", "#b06800"

FONT, SMALL = 9, 8
_GAP_POINTS = 5.0
ROOM = 0.16
"""Kept free around the curve for labels, as a part of its extent."""


def frame_curve(axes: Any, plane: Plane, curve: OneCurve) -> None:
    """Give the drawing its range: what lies between the points, with room for labels."""
    seen = seen_points(curve, plane)
    low, high = seen.min(axis=0), seen.max(axis=0)
    extent = np.maximum(high - low, FLATTEST * max(*(high - low), np.finfo(float).tiny))
    middle = (low + high) / 2
    for limit, centre, length in zip((axes.set_xlim, axes.set_ylim), middle, extent * (0.5 + ROOM), strict=True):
        limit(centre - length, centre + length)
    style_axes(axes, plane)


def settle(figure: Any, axes: Any, *, equal_scales: bool) -> None:
    """Lay the figure out for good; for equal scales the drawing shows more in one direction, and keeps its size."""
    for _ in range(2):  # other limits have other numbers, which take other room
        figure.draw_without_rendering()
        if equal_scales:
            _equalise(axes)
    figure.draw_without_rendering()
    figure.set_layout_engine("none")
    if equal_scales:
        _equalise(axes)


def _equalise(axes: Any) -> None:
    limits = np.array([axes.get_xlim(), axes.get_ylim()])
    lengths, pixels = np.ptp(limits, axis=1), axes.bbox.size
    wanted = pixels * (lengths / pixels).max()
    low, high = limits.mean(axis=1) - wanted / 2, limits.mean(axis=1) + wanted / 2
    axes.set_xlim(low[0], high[0])
    axes.set_ylim(low[1], high[1])


def style_axes(axes: Any, plane: Plane, *, outer_only: bool = False) -> None:
    across, up = plane.labels
    axes.set_xlabel(f"${across}$".replace(MINUS, "-"), fontsize=SMALL)
    axes.set_ylabel(f"${up}$".replace(MINUS, "-"), fontsize=SMALL)
    axes.tick_params(labelsize=SMALL, colors=QUIET, length=3)
    for side in ("top", "right"):
        axes.spines[side].set_visible(False)
    for side in ("left", "bottom"):
        axes.spines[side].set_color(QUIET)
    if outer_only:
        axes.label_outer()


def add_legend(figure: Any, axes: Any) -> None:
    """Say once, below the drawing, what each kind of line is; in grey where there is one of every colour."""
    from matplotlib.lines import Line2D

    handles: dict[str, Any] = {}
    for line in axes.lines:
        if not line.get_label().startswith("_"):
            handle = Line2D([], [])
            handle.update_from(line)
            handle.set_color(line.get_color() if line.get_color() not in PARTS else QUIET)
            handles.setdefault(line.get_label(), handle)
    write_legend(figure, list(handles.values()), list(handles), handlelength=2.6)


def write_legend(figure: Any, handles: Sequence[Any], labels: Sequence[str], **style: Any) -> None:
    figure.legend(
        handles, labels, loc="outside lower center", ncols=len(labels), fontsize=SMALL, frameon=False, **style
    )


def add_names(axes: Any, plane: Plane, curve: OneCurve, names: Sequence[str]) -> None:
    """Write the names of parabolas and points where they cover least."""
    centre = {"ha": "center", "va": "center", "fontsize": FONT, "zorder": 6, "linespacing": 1.25}
    to_pixels = axes.transData.transform
    places = named_places(curve, plane, to_pixels)
    texts = [*names, *(f"$Q_{p}({PARABOLA_LETTERS[p]})$" for p in range(3))]
    colours = [INK] * 5 + list(PARTS)
    labels = [
        axes.annotate(text, place, (0, 0), textcoords="offset points", path_effects=halo(2), color=colour, **centre)
        for text, place, colour in zip(texts, places, colours, strict=True)
    ]
    sizes = np.array([label.get_window_extent().size for label in labels])
    per_point = axes.figure.dpi / 72
    gap, box = _GAP_POINTS * per_point, axes.bbox.get_points()
    centres = name_centres(curve, plane, places, to_pixels, sizes, gap=gap, box=box)
    for label, offset in zip(labels, (centres - to_pixels(places)) / per_point, strict=True):
        label.set_position(tuple(offset))
