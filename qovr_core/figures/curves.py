"""The paper's Figure 1, one curve and its parts, drawn by matplotlib with no display."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from qovr_core.arrays import Array
from qovr_core.figures.curve_axes import (
    FONT,
    INK,
    PARTS,
    QUIET,
    ROOM,
    SERIES,
    SMALL,
    WARN,
    add_legend,
    add_names,
    frame_curve,
    settle,
    style_axes,
    write_legend,
)
from qovr_core.figures.style import house_style
from qovr_core.geometry.knots import KNOT_NAMES
from qovr_core.laboratory.labels import label_places
from qovr_core.laboratory.one_curve import PARABOLA_LETTERS, SAMPLES, OneCurve
from qovr_core.laboratory.planes import Plane, View, plane_of

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


@house_style()
def draw_parabolas(curve: OneCurve, sheet: Sheet = _PAPER) -> Any:
    """Return Figure 1a: the three parabolas, each by itself, and the segments of them that are blended."""
    figure, axes, plane = _drawing(curve, sheet)
    for p in range(3):
        _draw_part(axes, plane, curve, p, (0.0, 1.0), **_WHOLE)
        _draw_part(axes, plane, curve, p, curve.blended[p], **_BLENDED)
    _draw_points(axes, plane, curve)
    add_legend(figure, axes)
    settle(figure, axes, equal_scales=sheet.equal_scales)
    add_names(axes, plane, curve, [f"$P_{k}$" for k in range(5)])
    return figure


@house_style()
def draw_knots(curve: OneCurve, sheet: Sheet = _PAPER) -> Any:
    """Return Figure 1b: the blended curve, the places of the internal knots, and the auxiliary segments."""
    figure, axes, plane = _drawing(curve, sheet)
    _draw_blend(axes, plane, curve)
    add_legend(figure, axes)
    settle(figure, axes, equal_scales=sheet.equal_scales)
    add_names(axes, plane, curve, _knot_names(curve))
    return figure


@house_style()
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
        axes.set_title(f"${name}_{{ip}}$", fontsize=FONT + 1)
        style_axes(axes, plane, outer_only=True)
        if sheet.equal_scales:
            axes.set_aspect("equal", adjustable="box")
        axes.margins(ROOM)
    handles, labels = grid[0, 0].get_legend_handles_labels()
    write_legend(figure, handles, labels, title="value of the knot", title_fontsize=SMALL)
    return figure


@house_style()
def draw_curve(curve: OneCurve, sheet: Sheet) -> Any:
    """Return one curve with all its parts: the curve in a plane, its weights, and its transformations."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=sheet.size, layout="constrained")
    parts = figure.subplot_mosaic([["curve", "blends"], ["curve", "weights"], ["curve", "places"]], width_ratios=(5, 4))
    plane = plane_of(curve.points, sheet.view)
    axes = parts["curve"]
    _draw_blend(axes, plane, curve)
    frame_curve(axes, plane, curve)
    axes.set_title(f"${curve.name}({curve.parameter})$", fontsize=FONT + 1)
    _draw_functions(parts["blends"], curve, curve.blends(SAMPLES), [f"$w_{p}$" for p in range(3)], PARTS)
    _draw_functions(parts["weights"], curve, curve.weights(SAMPLES), [f"$b_{k}$" for k in range(5)], SERIES)
    _draw_transformations(parts["places"], curve)
    for name in ("blends", "weights"):
        parts[name].tick_params(labelbottom=False)
    add_legend(figure, axes)
    parts["places"].set_xlabel(f"${curve.parameter}$", fontsize=SMALL)
    settle(figure, axes, equal_scales=sheet.equal_scales)
    add_names(axes, plane, curve, _knot_names(curve))
    return figure


# The curve in its plane


def _drawing(curve: OneCurve, sheet: Sheet) -> tuple[Any, Any, Plane]:
    from matplotlib.figure import Figure

    figure = Figure(figsize=sheet.size, layout="constrained")
    axes = figure.add_subplot()
    plane = plane_of(curve.points, sheet.view)
    frame_curve(axes, plane, curve)
    return figure, axes, plane


def _draw_part(axes: Any, plane: Plane, curve: OneCurve, p: int, part: tuple[float, float], **style: Any) -> None:
    x = np.linspace(*part, len(SAMPLES))
    axes.plot(*plane.drawn(curve.parabola(p, x)).T, color=PARTS[p], **style)


def _draw_points(axes: Any, plane: Plane, curve: OneCurve) -> None:
    points = plane.drawn(curve.points)
    axes.plot(*points.T, color=QUIET, linewidth=0.7, linestyle=":", zorder=1)
    axes.scatter(*points.T, s=26, c=SERIES, edgecolors="white", linewidths=0.6, zorder=5)


def _draw_blend(axes: Any, plane: Plane, curve: OneCurve) -> None:
    for p in range(3):
        _draw_part(axes, plane, curve, p, (0.0, 1.0), **_WHOLE)
        _draw_part(axes, plane, curve, p, curve.blended[p], **_BLENDED)
        _draw_part(axes, plane, curve, p, curve.auxiliary[p], **_AUXILIARY)
    name = f"${curve.direction.letter}({curve.parameter})$"
    axes.plot(*plane.drawn(curve.at(SAMPLES)).T, color=INK, linewidth=1.8, zorder=3, label=name)
    for number, part in enumerate(curve.folding_parts):
        backward = plane.drawn(curve.at(np.linspace(*part, len(SAMPLES))))
        label = "_nolegend_" if number else "folds back"
        axes.plot(*backward.T, color=WARN, linewidth=1.8, zorder=3, label=label)
    ends = plane.drawn(curve.at(curve.landmarks))
    axes.scatter(*ends.T, s=70, facecolors="none", edgecolors=INK, linewidths=0.8, zorder=4)
    _draw_points(axes, plane, curve)


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


# Functions of the parameter


def _draw_functions(axes: Any, curve: OneCurve, values: Array, names: Sequence[str], colours: Sequence[str]) -> None:
    for k, place in enumerate(label_places(values)):
        axes.plot(SAMPLES, values[:, k], color=colours[k], linewidth=1.2)
        label = axes.text(
            SAMPLES[place], values[place, k], names[k], color=colours[k], ha="center", va="center", fontsize=SMALL
        )
        label.set_bbox({"facecolor": "white", "edgecolor": "none", "pad": 0.5})
    axes.axvline(curve.knots.u, color=QUIET, linewidth=0.7, dashes=(4, 3), zorder=1)
    axes.set_xlim(0, 1)
    axes.tick_params(labelsize=SMALL - 1, colors=QUIET, length=3)
    for side in ("top", "right"):
        axes.spines[side].set_visible(False)


def _draw_transformations(axes: Any, curve: OneCurve) -> None:
    values = curve.transformed(SAMPLES)
    low, high = min(-0.5, values[:, 1].min()) - 0.1, max(1.5, values[:, 1].max()) + 0.1
    seen = np.where((low < values) & (values < high), values, np.nan)
    _draw_functions(axes, curve, seen, [f"${letter}$" for letter in PARABOLA_LETTERS], PARTS)
    places = zip(curve.landmarks, curve.internal_knots, PARTS, strict=True)
    for u, knot, colour in places:
        axes.plot(u, knot, "o", markersize=4.5, color="white", markeredgecolor=colour, clip_on=False, zorder=5)
    for part in curve.folding_parts:
        axes.axvspan(*part, color=WARN, alpha=0.2, linewidth=0)
    for value in (0, 1):
        axes.axhline(value, color=QUIET, linewidth=0.6, zorder=1)
    axes.set_ylim(low, high)
