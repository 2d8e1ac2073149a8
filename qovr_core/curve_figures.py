"""The paper's Figure 1, one curve and its parts, drawn by matplotlib with no display."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from qovr_core.arrays import Array
from qovr_core.geometry.knots import KNOT_NAMES
from qovr_core.laboratory.curve_names import FLATTEST, name_centres, named_places, seen_points
from qovr_core.laboratory.labels import label_places
from qovr_core.laboratory.one_curve import PARABOLA_LETTERS, SAMPLES, OneCurve
from qovr_core.laboratory.planes import Plane, View, plane_of
from qovr_core.number_texts import MINUS

SERIES = ("#c9392b", "#be7000", "#148458", "#1c64d8", "#803eb2")
"""The colours of P_0..P_4; Q_p, w_p and its parameter take that of the point P_{p+1} at their knot."""

_PARTS = SERIES[1:4]
_INK, _QUIET, _WARN = "#20242a", "#70767f", "#b06800"

_FONT, _SMALL = 9, 8
_GAP_POINTS = 5.0
_ROOM = 0.16
"""Kept free around the curve for labels, as a part of its extent."""

_BLENDED = {"linewidth": 5.5, "alpha": 0.3, "solid_capstyle": "butt", "label": "blended segment"}
_WHOLE = {"linewidth": 1.0, "label": "parabola"}
_AUXILIARY = {"linewidth": 1.0, "dashes": (4, 2.5), "label": "auxiliary segment"}

_SENSITIVITY = (0.3, 0.4, 0.5, 0.6, 0.7)


@dataclass(frozen=True)
class Sheet:
    """How a curve is laid on paper.

    Parameters
    ----------
    view : in which plane
    size : width and height in inches
    equal_scales : whether both directions of the plane are drawn at one scale
    """

    view: View = View.BEST
    size: tuple[float, float] = (5.0, 3.7)
    equal_scales: bool = True


_PAPER, _FOUR_CURVES = Sheet(), Sheet(size=(6.4, 4.8))


def draw_parabolas(curve: OneCurve, sheet: Sheet = _PAPER) -> Any:
    """Return Figure 1a: the three parabolas, each by itself, and the segments of them that are blended."""
    figure, axes, plane = _drawing(curve, sheet)
    for p in range(3):
        _draw_part(axes, plane, curve, p, (0.0, 1.0), **_WHOLE)
        _draw_part(axes, plane, curve, p, curve.blended[p], **_BLENDED)
    _draw_points(axes, plane, curve)
    _add_legend(figure, axes)
    _settle(figure, axes, equal_scales=sheet.equal_scales)
    _add_names(axes, plane, curve, [f"$P_{k}$" for k in range(5)])
    return figure


def draw_knots(curve: OneCurve, sheet: Sheet = _PAPER) -> Any:
    """Return Figure 1b: the blended curve, the places of the internal knots, and the auxiliary segments."""
    figure, axes, plane = _drawing(curve, sheet)
    _draw_blend(axes, plane, curve)
    _add_legend(figure, axes)
    _settle(figure, axes, equal_scales=sheet.equal_scales)
    _add_names(axes, plane, curve, _knot_names(curve))
    return figure


def draw_sensitivity(curve: OneCurve, sheet: Sheet = _FOUR_CURVES) -> Any:
    """Return Figure 1c: the curve with several values of each of its four knots, the others as they are."""
    from matplotlib import colormaps
    from matplotlib.figure import Figure

    figure = Figure(figsize=sheet.size, layout="constrained")
    plane = plane_of(curve.points, sheet.view)
    colours = colormaps["viridis"](np.linspace(0, 0.9, len(_SENSITIVITY)))
    grid = figure.subplots(2, 2, sharex=True, sharey=True)
    for axes, name in zip(grid.flat, KNOT_NAMES, strict=True):
        for value, colour in zip(_SENSITIVITY, colours, strict=True):
            changed = replace(curve, knots=replace(curve.knots, **{name: value}))
            axes.plot(*plane.drawn(changed.at(SAMPLES)).T, color=colour, linewidth=1.4, label=f"{value:g}")
        _draw_points(axes, plane, curve)
        axes.set_title(f"${name}_{{ip}}$", fontsize=_FONT + 1)
        _style(axes, plane, outer_only=True)
        if sheet.equal_scales:
            axes.set_aspect("equal", adjustable="box")
        axes.margins(_ROOM)
    handles, labels = grid[0, 0].get_legend_handles_labels()
    _legend(figure, handles, labels, title="value of the knot", title_fontsize=_SMALL)
    return figure


def draw_curve(curve: OneCurve, sheet: Sheet) -> Any:
    """Return one curve with all its parts: the curve in a plane, its weights, and its transformations."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=sheet.size, layout="constrained")
    parts = figure.subplot_mosaic([["curve", "blends"], ["curve", "weights"], ["curve", "places"]], width_ratios=(5, 4))
    plane = plane_of(curve.points, sheet.view)
    axes = parts["curve"]
    _draw_blend(axes, plane, curve)
    _frame(axes, plane, curve)
    axes.set_title(f"${curve.name}({curve.parameter})$", fontsize=_FONT + 1)
    _draw_functions(parts["blends"], curve, curve.blends(SAMPLES), [f"$w_{p}$" for p in range(3)], _PARTS)
    _draw_functions(parts["weights"], curve, curve.weights(SAMPLES), [f"$b_{k}$" for k in range(5)], SERIES)
    _draw_transformations(parts["places"], curve)
    for name in ("blends", "weights"):
        parts[name].tick_params(labelbottom=False)
    _add_legend(figure, axes)
    parts["places"].set_xlabel(f"${curve.parameter}$", fontsize=_SMALL)
    _settle(figure, axes, equal_scales=sheet.equal_scales)
    _add_names(axes, plane, curve, _knot_names(curve))
    return figure


# The curve in its plane


def _drawing(curve: OneCurve, sheet: Sheet) -> tuple[Any, Any, Plane]:
    from matplotlib.figure import Figure

    figure = Figure(figsize=sheet.size, layout="constrained")
    axes = figure.add_subplot()
    plane = plane_of(curve.points, sheet.view)
    _frame(axes, plane, curve)
    return figure, axes, plane


def _frame(axes: Any, plane: Plane, curve: OneCurve) -> None:
    """Give the drawing its range: what lies between the points, with room for labels."""
    seen = seen_points(curve, plane)
    low, high = seen.min(axis=0), seen.max(axis=0)
    extent = np.maximum(high - low, FLATTEST * max(*(high - low), np.finfo(float).tiny))
    middle = (low + high) / 2
    for limit, centre, length in zip((axes.set_xlim, axes.set_ylim), middle, extent * (0.5 + _ROOM), strict=True):
        limit(centre - length, centre + length)
    _style(axes, plane)


def _settle(figure: Any, axes: Any, *, equal_scales: bool) -> None:
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


def _style(axes: Any, plane: Plane, *, outer_only: bool = False) -> None:
    across, up = plane.labels
    axes.set_xlabel(f"${across}$".replace(MINUS, "-"), fontsize=_SMALL)
    axes.set_ylabel(f"${up}$".replace(MINUS, "-"), fontsize=_SMALL)
    axes.tick_params(labelsize=_SMALL, colors=_QUIET, length=3)
    for side in ("top", "right"):
        axes.spines[side].set_visible(False)
    for side in ("left", "bottom"):
        axes.spines[side].set_color(_QUIET)
    if outer_only:
        axes.label_outer()


def _draw_part(axes: Any, plane: Plane, curve: OneCurve, p: int, part: tuple[float, float], **style: Any) -> None:
    x = np.linspace(*part, len(SAMPLES))
    axes.plot(*plane.drawn(curve.parabola(p, x)).T, color=_PARTS[p], **style)


def _draw_points(axes: Any, plane: Plane, curve: OneCurve) -> None:
    points = plane.drawn(curve.points)
    axes.plot(*points.T, color=_QUIET, linewidth=0.7, linestyle=":", zorder=1)
    axes.scatter(*points.T, s=26, c=SERIES, edgecolors="white", linewidths=0.6, zorder=5)


def _draw_blend(axes: Any, plane: Plane, curve: OneCurve) -> None:
    for p in range(3):
        _draw_part(axes, plane, curve, p, (0.0, 1.0), **_WHOLE)
        _draw_part(axes, plane, curve, p, curve.blended[p], **_BLENDED)
        _draw_part(axes, plane, curve, p, curve.auxiliary[p], **_AUXILIARY)
    name = f"${curve.direction.letter}({curve.parameter})$"
    axes.plot(*plane.drawn(curve.at(SAMPLES)).T, color=_INK, linewidth=1.8, zorder=3, label=name)
    fold = curve.fold_back
    if fold:
        backward = plane.drawn(curve.at(np.linspace(*fold.backward, len(SAMPLES))))
        axes.plot(*backward.T, color=_WARN, linewidth=1.8, zorder=3, label="$s$ runs back")
    ends = plane.drawn(curve.at(curve.landmarks))
    axes.scatter(*ends.T, s=70, facecolors="none", edgecolors=_INK, linewidths=0.8, zorder=4)
    _draw_points(axes, plane, curve)


def _add_legend(figure: Any, axes: Any) -> None:
    """Say once, below the drawing, what each kind of line is; in grey where there is one of every colour."""
    from matplotlib.lines import Line2D

    handles: dict[str, Any] = {}
    for line in axes.lines:
        if not line.get_label().startswith("_"):
            handle = Line2D([], [])
            handle.update_from(line)
            handle.set_color(line.get_color() if line.get_color() not in _PARTS else _QUIET)
            handles.setdefault(line.get_label(), handle)
    _legend(figure, list(handles.values()), list(handles), handlelength=2.6)


def _legend(figure: Any, handles: Sequence[Any], labels: Sequence[str], **style: Any) -> None:
    figure.legend(
        handles, labels, loc="outside lower center", ncols=len(labels), fontsize=_SMALL, frameon=False, **style
    )


def _knot_names(curve: OneCurve) -> list[str]:
    """Return the names of the points, with what holds where the curve meets them."""
    names = [f"$P_{k}$" for k in range(5)]
    for p in range(3):
        place = f"{curve.parameter} = {curve.landmarks[p]:.4g}"
        knot = f"{PARABOLA_LETTERS[p]} = {PARABOLA_LETTERS[p]}_{{ip}} = {curve.internal_knots[p]:.4g}"
        if p == 1:
            place = f"{curve.parameter} = {curve.parameter}_{{ip}} = {curve.knots.u:.4g}"
        names[p + 1] = f"$P_{p + 1}$\n${place}$\n${knot}$"
    return names


def _add_names(axes: Any, plane: Plane, curve: OneCurve, names: Sequence[str]) -> None:
    """Write the names of parabolas and points where they cover least."""
    from matplotlib.patheffects import withStroke

    centre = {"ha": "center", "va": "center", "fontsize": _FONT, "zorder": 6, "linespacing": 1.25}
    halo = [withStroke(linewidth=2, foreground="white")]
    to_pixels = axes.transData.transform
    places = named_places(curve, plane, to_pixels)
    texts = [*names, *(f"$Q_{p}({PARABOLA_LETTERS[p]})$" for p in range(3))]
    colours = [_INK] * 5 + list(_PARTS)
    labels = [
        axes.annotate(text, place, (0, 0), textcoords="offset points", path_effects=halo, color=colour, **centre)
        for text, place, colour in zip(texts, places, colours, strict=True)
    ]
    sizes = np.array([label.get_window_extent().size for label in labels])
    per_point = axes.figure.dpi / 72
    gap, box = _GAP_POINTS * per_point, axes.bbox.get_points()
    centres = name_centres(curve, plane, to_pixels, sizes, gap=gap, box=box)
    for label, offset in zip(labels, (centres - to_pixels(places)) / per_point, strict=True):
        label.set_position(tuple(offset))


# Functions of the parameter


def _draw_functions(axes: Any, curve: OneCurve, values: Array, names: Sequence[str], colours: Sequence[str]) -> None:
    for k, place in enumerate(label_places(values)):
        axes.plot(SAMPLES, values[:, k], color=colours[k], linewidth=1.2)
        label = axes.text(
            SAMPLES[place], values[place, k], names[k], color=colours[k], ha="center", va="center", fontsize=_SMALL
        )
        label.set_bbox({"facecolor": "white", "edgecolor": "none", "pad": 0.5})
    axes.axvline(curve.knots.u, color=_QUIET, linewidth=0.7, dashes=(4, 3), zorder=1)
    axes.set_xlim(0, 1)
    axes.tick_params(labelsize=_SMALL - 1, colors=_QUIET, length=3)
    for side in ("top", "right"):
        axes.spines[side].set_visible(False)


def _draw_transformations(axes: Any, curve: OneCurve) -> None:
    values = curve.transformed(SAMPLES)
    low, high = min(-0.5, values[:, 1].min()) - 0.1, max(1.5, values[:, 1].max()) + 0.1
    seen = np.where((low < values) & (values < high), values, np.nan)
    _draw_functions(axes, curve, seen, [f"${letter}$" for letter in PARABOLA_LETTERS], _PARTS)
    places = zip(curve.landmarks, curve.internal_knots, _PARTS, strict=True)
    for u, knot, colour in places:
        axes.plot(u, knot, "o", markersize=4.5, color="white", markeredgecolor=colour, clip_on=False, zorder=5)
    fold = curve.fold_back
    if fold:
        axes.axvspan(*fold.backward, color=_WARN, alpha=0.2, linewidth=0)
    for value in (0, 1):
        axes.axhline(value, color=_QUIET, linewidth=0.6, zorder=1)
    axes.set_ylim(low, high)
