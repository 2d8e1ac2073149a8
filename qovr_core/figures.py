"""The paper's surface figures 5 to 8, drawn by matplotlib with no display."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from typing import Any

import numpy as np

from qovr_core.errors import SourceError
from qovr_core.files.atomic import replacing
from qovr_core.pipeline import Surface, configure
from qovr_core.presets import FigureCase, figure_cases

FIGURE_FORMATS = ("png", "svg", "pdf")

# MATLAB's view(36, 64) and view(0, 90): its azimuth is 90 degrees ahead of matplotlib's.
_CAMERAS = {"paper": {"elev": 64.0, "azim": 36.0 - 90.0}, "top": {"elev": 90.0, "azim": 0.0 - 90.0}}

_ZOOM = {"paper": 0.9, "top": 1.1}
"""Fills the frame without cutting off the box's upper corners or the titles of the axes."""

_SIZE_INCHES = (6.4, 5.2)
_POINT_COLOR = "#0032ff"
_EDGE_COLOR = (0.0, 0.0, 0.0, 0.55)
_EDGE_POINTS = 0.15
"""Width of a facet's edge: at 100 facets across 90 mm it must stay finer than the facet."""


def find_figures(only: Iterable[str]) -> list[FigureCase]:
    """Return the named figures in the paper's order, all of them where no name is given.

    A name may also be that of several, as ``fig6`` for ``fig6a`` to ``fig6d``.

    Raises
    ------
    SourceError : a name is no figure's
    """
    cases = figure_cases()
    chosen: set[str] = set()
    for name in only:
        matching = {known for known in cases if known == name or known[:-1] == name}
        if not matching:
            raise SourceError(f"there is no figure '{name}'; expected one of {', '.join(cases)}")
        chosen |= matching
    return [case for case in cases.values() if case.name in chosen or not chosen]


def save_figure(case: FigureCase, path: Path, *, dpi: int = 300) -> None:
    """Draw one figure into a file of the kind that its suffix names, whole or not at all.

    Parameters
    ----------
    case : the figure
    path : ends in ``.png``, ``.svg`` or ``.pdf``
    dpi : resolution of a ``.png``

    Raises
    ------
    FileError : the file cannot be written
    """
    figure = draw_figure(configure(case.preset.document), layer=case.layer, camera=case.camera)
    kind = path.suffix.lower().removeprefix(".")
    with replacing(path) as (draft,):
        figure.savefig(draft, format=kind, dpi=dpi)


def draw_figure(surface: Surface, *, layer: str, camera: str) -> Any:
    """Return a matplotlib Figure that shows a surface as the paper does.

    Parameters
    ----------
    surface : the configured surface
    layer : ``raw`` or ``transformed``
    camera : ``paper`` (azimuth 36, elevation 64 degrees in MATLAB's sense) or ``top``
    """
    from matplotlib.figure import Figure

    figure = Figure(figsize=_SIZE_INCHES, layout="constrained")
    axes: Any = figure.add_subplot(projection="3d", proj_type="ortho", computed_zorder=False)
    axes.view_init(**_CAMERAS[camera])
    axes.set_box_aspect(None, zoom=_ZOOM[camera])
    facets = _draw_facets(axes, surface.raw if layer == "raw" else surface.transformed)
    _draw_control_points(axes, surface.document.control_points)
    _label_axes(axes, from_above=camera == "top")
    figure.colorbar(facets, ax=axes, label="Z-Axis Value", shrink=0.72, pad=0.08)
    return figure


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
    from matplotlib.patheffects import withStroke

    # Beside a raw surface the net is a corner of the picture: there everything shrinks with it.
    shrink = 1.0 if np.ptp(net[..., 0]) > 0.25 * np.ptp(axes.get_xlim()) else 0.5
    halo = [withStroke(linewidth=1.6 * shrink, foreground="white")]
    x, y, z = net.reshape(-1, 3).T
    size, rim = 26 * shrink**2, 0.5 * shrink
    axes.scatter(x, y, z, s=size, c=_POINT_COLOR, edgecolors="white", linewidths=rim, depthshade=False, zorder=3)
    for i, j in np.ndindex(net.shape[:2]):
        label = axes.text(*net[i, j], f" P{i},{j}", fontsize=7 * shrink, va="bottom", zorder=4)
        label.set_path_effects(halo)


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
