"""Nets of many windows against one, against Splipy, and against what the program may take at their largest."""

import time
import tracemalloc

import numpy as np
import pytest
from splipy import BSplineBasis
from splipy import Surface as SplipySurface

from qovr_core import Document, Evaluation, Formulation, build_patch, edits
from qovr_core.files.qovr_document import read_document, write_document
from qovr_core.geometry.locate import spread
from support.nets import random_net_document

from .conftest import MEDIANS

SAMPLES = 1001
SIDES = (1, 10, 50, 100)
"""Windows along each direction."""

POINTS = 203
MOVES = 2000
HISTORY_MEGABYTES = 50


def net_document(side, samples=SAMPLES):
    return random_net_document(1, (side, side), flatness=0.3, samples=(samples, samples))


@pytest.mark.parametrize("side", SIDES)
def test_patches(measure, side):
    document = net_document(side)
    measure("patches", side, lambda: build_patch(document))


@pytest.mark.parametrize("side", SIDES)
def test_samples(measure, side):
    patch, intervals = build_patch(net_document(side)), spread(SAMPLES, side)
    measure("samples", side, lambda: patch.samples(intervals, intervals))


@pytest.mark.parametrize("side", SIDES)
def test_one_point_moved(measure, side):
    document = net_document(side)
    before = Evaluation(document)
    before.matrix  # noqa: B018 - what an edit stands on has been asked for
    moved = edits.set_point(document, 2, 2, document.control_points[2, 2] + 0.1)
    measure("moved", side, lambda: Evaluation(moved, before).matrix)


@pytest.mark.parametrize("side", SIDES)
def test_splipy(measure, side):
    """A bicubic B-spline of as many control points, the whole pipeline of ours beside it."""
    net = net_document(side).control_points
    rows, columns = net.shape[:2]
    knots_u, knots_v = ([0.0] * 3 + np.linspace(0, 1, count - 2).tolist() + [1.0] * 3 for count in (columns, rows))
    surface = SplipySurface(BSplineBasis(4, knots_u), BSplineBasis(4, knots_v), net.transpose(0, 1, 2).reshape(-1, 3))
    parameters = np.linspace(0, 1, SAMPLES)
    measure("splipy net", side, lambda: surface(parameters.copy(), parameters.copy()), rounds=5)


@pytest.mark.parametrize("side", SIDES)
def test_whole(measure, side):
    document = net_document(side)
    measure("whole net", side, lambda: Evaluation(document).raw, rounds=5)


def test_ratios(row):
    """Not a measurement: it turns the medians above into the table."""
    m, at = MEDIANS, f"{SAMPLES} x {SAMPLES}"
    for side, goal in ((10, 1.5), (50, 4), (100, None)):
        row(f"samples, {side**2} windows / one", at, m["samples", side] / m["samples", 1], at_most=goal)
    row("ms for the patches of 2,500 windows", "", 1e3 * m["patches", 50], at_most=40)
    for side in SIDES[1:]:
        windows, splipy = f"{side**2} windows", m["splipy net", side]
        row(f"one point moved, with T, {windows} / one", at, m["moved", side] / m["moved", 1])
        row(f"Splipy / samples, {windows}", at, splipy / m["samples", side], at_least=2)
        row(f"Splipy / document to samples, {windows}", at, splipy / m["whole net", side])


def test_the_largest_net_from_its_file(row, tmp_path):
    side = (POINTS - 3) // 2
    path = tmp_path / "largest.qovr"
    write_document(net_document(side, 101), path)
    seconds = []
    for _ in range(3):
        start = time.perf_counter()
        Evaluation(read_document(path)).matrix  # noqa: B018
        seconds.append(time.perf_counter() - start)
    row("seconds from file to evaluation", f"{POINTS} x {POINTS}", float(np.median(seconds)), at_most=0.8)


def test_memory(row):
    document = net_document(50)
    Evaluation(document).raw  # noqa: B018
    tracemalloc.start()
    raw = Evaluation(document).raw
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    row("peak memory / raw samples, 2,500 windows", f"{SAMPLES} x {SAMPLES}", peak / raw.nbytes, at_most=1.25)


def test_the_history_of_moved_points(row):
    pytest.importorskip("PySide6")
    from qovr_app.state.history import History

    net = np.random.default_rng(0).random((POINTS, POINTS, 3))
    history = History.of(Document(net, formulation=Formulation.INTERPOLATING))
    history = history.pushed("Move", edits.set_point(history.document, 0, 0, (0.0, 0.0, 0.0)), None)
    tracemalloc.start()
    for k in range(MOVES):
        i, j = divmod(7 * k, POINTS)
        history = history.pushed("Move", edits.set_point(history.document, i, j, (float(k), 1.0, 2.0)), None)
    held = tracemalloc.get_traced_memory()[0]
    tracemalloc.stop()
    row(f"MB of {MOVES:,} moves in the history", f"{POINTS} x {POINTS}", held / 1e6, at_most=HISTORY_MEGABYTES)
