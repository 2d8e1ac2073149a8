"""Nets in the view against one window in the same view."""

import time

import numpy as np
import pytest

from qovr_app.view3d.scene import display_grid
from qovr_core import Document
from qovr_core.presets import preset

pytest.importorskip("PySide6")

from .test_nets import POINTS
from .test_view import EDITS, bench  # noqa: F401 - a fixture

PICKS = 40
FRAMES = 12


def opened(bench, document):  # noqa: F811
    bench.dispatch("Opened", document, "net")
    bench.settle()


def waves(side):
    """Return a net of so many windows each way over the same waves."""
    y, x = np.mgrid[: 2 * side + 3, : 2 * side + 3] * 9.0 / (2 * side + 2)
    net = np.stack([x, y, np.sin(x) * np.cos(0.8 * y)], axis=-1)
    return Document(net, formulation="interpolating", samples=(101, 101))


def one_window():
    return Document(preset("fig5").document.control_points, formulation="interpolating")


def test_one_point_moved_with_its_redraw(bench, row, monkeypatch):  # noqa: F811
    """The one window is drawn with as many vertices as the net while something moves."""
    opened(bench, waves(49))
    bench.timed(bench.edit, 5)
    ours = np.median(bench.timed(bench.edit))
    scene, style = bench.view.picture().scene, bench.view.picture().settings.style
    vertices = display_grid.display_grid(scene.patch, (101, 101), style, moving=True).shape[0]
    monkeypatch.setattr(display_grid, "MOVING_LIMIT", vertices - 1)
    opened(bench, one_window())
    bench.timed(bench.edit, 5)
    row(
        "one point moved with redraw, net / one window",
        "101 x 101",
        ours / np.median(bench.timed(bench.edit)),
        at_most=1.3,
    )


def test_the_largest_net(bench, row):  # noqa: F811
    from qovr_app.view3d.interaction.picking import points_under

    opened(bench, one_window())
    few = np.median(bench.timed(bench.orbit, EDITS))
    document = waves((POINTS - 3) // 2)
    start, before = time.perf_counter(), bench.painted
    bench.dispatch("Opened", document, "net")
    while bench.painted == before:
        bench.application.processEvents()
    at = f"{POINTS} x {POINTS}"
    row("seconds to the first frame of a net", at, time.perf_counter() - start, at_most=1.5)
    bench.settle()
    bench.timed(bench.orbit, 3)
    row("orbiting, net / 25 points", at, np.median(bench.timed(bench.orbit, FRAMES)) / few, at_most=1.5)
    bench.settle(2.0)
    size = bench.view.viewports[0].logical_size
    picture, rng, seconds = bench.view.picture(), np.random.default_rng(0), []
    for x, y in rng.uniform(0.25, 0.75, (PICKS, 2)) * size:
        start = time.perf_counter()
        points_under(picture, size, x, y)
        seconds.append(time.perf_counter() - start)
    row("ms to pick a point, hidden ones left out", at, 1e3 * float(np.median(seconds)), at_most=5)
