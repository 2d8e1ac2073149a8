"""The paper's Figures 2 and 5 to 8, curve networks and surfaces in space, drawn by matplotlib with no display."""

from __future__ import annotations

from typing import Any

import numpy as np

from qovr_core.cameras import NAMED_VIEWS
from qovr_core.construction import curve_network
from qovr_core.document import Document
from qovr_core.evaluation import Evaluation
from qovr_core.figures.style import halo, house_style
from qovr_core.geometry import bernstein
from qovr_core.geometry.weights import CURVE_DEGREE
from qovr_core.laboratory.one_curve import SAMPLES
from qovr_core.layer import Layer

_ZOOM = {"paper": 0.9, "top": 1.1}
"""Fills the frame without cutting off the box's upper corners or the titles of the axes."""

_SIZE_INCHES = (6.4, 5.2)
_POINT_COLOR = "#0032ff"
_NET_COLOR = "#70767f"
_ROW_COLOR = "#20242a"
_NAMED_SAMPLE = {"C": 3 * len(SAMPLES) // 4, "K": len(SAMPLES) // 4}
"""Where a curve of the network has its name: between two points, and not where the other family has its names."""

_EDGE_COLOR = (0.0, 0.0, 0.0, 0.55)
_EDGE_POINTS = 0.15
"""Width of a facet's edge: at 100 facets across 90 mm it must stay finer than the facet."""


@house_style()
def draw_figure(evaluation: Evaluation, *, layer: str, camera: str) -> Any:
    """Return a matplotlib Figure that shows a surface as the paper does.

    Parameters
    ----------
    evaluation : of the document that is shown
    layer : ``raw`` or ``transformed``
    camera : ``paper`` (azimuth 36, elevation 64 degrees in MATLAB's sense) or ``top``
    """
    from matplotlib.figure import Figure

    figure = Figure(figsize=_SIZE_INCHES, layout="constrained")
    axes: Any = figure.add_subplot(projection="3d", proj_type="ortho", computed_zorder=False)
    _look(axes, camera)
    facets = _draw_facets(axes, evaluation.samples(Layer(layer)))
    _draw_control_points(axes, evaluation.document.control_points)
    _label_axes(axes, from_above=camera == "top")
    figure.colorbar(facets, ax=axes, label="Z-Axis Value", shrink=0.72, pad=0.08)
    return figure


@house_style()
def draw_network(document: Document, size: tuple[float, float] = _SIZE_INCHES) -> Any:
    """Return a matplotlib Figure of the ten curves C_i(u) and K_j(v) over their control net, as Figure 2.

    Parameters
    ----------
    size : width and height in inches
    """
    from matplotlib.figure import Figure

    figure = Figure(figsize=size, layout="constrained")
    axes: Any = figure.add_subplot(projection="3d", proj_type="ortho", computed_zorder=False)
    _look(axes, "paper")
    net = document.control_points
    for line in (*net, *net.transpose(1, 0, 2)):
        axes.plot(*line.T, color=_NET_COLOR, linewidth=0.8, linestyle=":", zorder=1)
    network, basis = curve_network(document), bernstein.basis(CURVE_DEGREE, SAMPLES)
    for letter, parameter, curves, color in (
        ("C", "u", network.rows[:, 0], _ROW_COLOR),
        ("K", "v", network.columns[:, 0], _POINT_COLOR),
    ):
        for k, curve in enumerate(curves):
            points = basis @ curve
            axes.plot(*points.T, color=color, linewidth=1.6, zorder=2)
            name = axes.text(*points[_NAMED_SAMPLE[letter]], f" ${letter}_{k}({parameter})$", color=color, fontsize=8)
            name.set(zorder=5, path_effects=halo(2))
    _draw_control_points(axes, net)
    _label_axes(axes, from_above=False)
    return figure


def _look(axes: Any, camera: str) -> None:
    azimuth, elevation = NAMED_VIEWS[camera]
    axes.view_init(elev=elevation, azim=azimuth)
    axes.set_box_aspect(None, zoom=_ZOOM[camera])


def _draw_facets(axes: Any, points: np.ndarray) -> Any:
    x, y, z = np.moveaxis(points, -1, 0)
    # matplotlib thins silently to 50 x 50 unless it is told the counts.
    return axes.plot_surface(
        x,
        y,
        z,
        cmap="jet",
        rcount=len(x),
        ccount=x.shape[1],
        linewidth=_EDGE_POINTS,
        edgecolor=_EDGE_COLOR,
        shade=False,
    )


def _draw_control_points(axes: Any, net: np.ndarray) -> None:

    # Beside a raw surface the net is a corner of the picture: there everything shrinks with it.
    shrink = 1.0 if np.ptp(net[..., 0]) > 0.25 * np.ptp(axes.get_xlim()) else 0.5
    x, y, z = net.reshape(-1, 3).T
    size, rim = 26 * shrink**2, 0.5 * shrink
    axes.scatter(x, y, z, s=size, c=_POINT_COLOR, edgecolors="white", linewidths=rim, depthshade=False, zorder=3)
    for i, j in np.ndindex(net.shape[:2]):
        label = axes.text(*net[i, j], f" P{i},{j}", fontsize=7 * shrink, va="bottom", zorder=4)
        label.set_path_effects(halo(1.6 * shrink))


def _label_axes(axes: Any, *, from_above: bool) -> None:
    axes.set_xlabel("X-Axis", labelpad=6)
    axes.set_ylabel("Y-Axis", labelpad=6)
    for axis in (axes.xaxis, axes.yaxis, axes.zaxis):
        axis.set_pane_color("white")
        axis.set_tick_params(labelsize=8)
    if from_above:
        axes.set_zticks([])
        axes.zaxis.line.set_visible(False)
    else:
        axes.set_zlabel("Z-Axis", labelpad=4)
