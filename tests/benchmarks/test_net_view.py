"""Nets in the view against one window in the same view."""

import time

import numpy as np
import pytest

from qovr_app.view3d.scene import display_grid
from qovr_core import Document
from qovr_core.presets import preset

pytest.importorskip("PySide6")

from .test_nets import POINTS
from .test_view import bench  # noqa: F401 - a fixture
from .timing import RUNS

PICKS = 40
FRAMES = 12
EDITS = 20


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


def edit_milliseconds(bench, document):  # noqa: F811
    opened(bench, document)
    bench.timed(bench.edit, 5)
    return bench.milliseconds(bench.edit, EDITS)


def test_one_point_moved_with_its_redraw(bench, record, monkeypatch):  # noqa: F811
    """The one window is drawn with as many vertices as the net while something moves."""
    limit, net, one = display_grid.MOVING_LIMIT, [], []
    for _ in range(RUNS):
        monkeypatch.setattr(display_grid, "MOVING_LIMIT", limit)
        net.append(edit_milliseconds(bench, waves(49)))
        scene, style = bench.view.picture().scene, bench.view.picture().settings.style
        vertices = display_grid.display_grid(scene.patch, (101, 101), style, moving=True).shape[0]
        monkeypatch.setattr(display_grid, "MOVING_LIMIT", vertices - 1)
        one.append(edit_milliseconds(bench, one_window()))
    record("net edit", net, one)


def pick_milliseconds(bench):  # noqa: F811
    from qovr_app.view3d.interaction.picking import points_under

    size = bench.view.viewports[0].logical_size
    picture, rng, seconds = bench.view.picture(), np.random.default_rng(0), []
    for x, y in rng.uniform(0.25, 0.75, (PICKS, 2)) * size:
        start = time.perf_counter()
        points_under(picture, size, x, y)
        seconds.append(time.perf_counter() - start)
    return 1e3 * float(np.median(seconds))


def test_the_largest_net(bench, record):  # noqa: F811
    document = waves((POINTS - 3) // 2)
    few, first, many, picks = [], [], [], []
    for _ in range(RUNS):
        opened(bench, one_window())
        few.append(bench.milliseconds(bench.orbit, EDITS))
        first.append(bench.frame(lambda _: bench.dispatch("Opened", document, "net"), 0))
        bench.settle()
        bench.timed(bench.orbit, 3)
        many.append(bench.milliseconds(bench.orbit, FRAMES))
        bench.settle(2.0)
        picks.append(pick_milliseconds(bench))
    record("net first frame", first)
    record("net orbit", many, few)
    record("net pick", picks)
