"""Nets of many windows against one, against Splipy, and against what the program may take at their largest."""

import tracemalloc

import numpy as np
import pytest
from splipy import BSplineBasis
from splipy import Surface as SplipySurface

from qovr_core import Document, Evaluation, Formulation, build_patch, edits
from qovr_core.construction import bounds_of_windows
from qovr_core.files.qovr_document import read_document, write_document
from qovr_core.geometry.locate import spread
from support.nets import random_net_document

SAMPLES = 1001
SIDES = (10, 50, 100)
"""Windows along each direction."""

POINTS = 203
MOVES = 2000


def net_document(side, samples=SAMPLES):
    return random_net_document(1, (side, side), flatness=0.3, samples=(samples, samples))


def samples(side):
    """Return a call that evaluates the samples of a net whose patches are there."""
    patch, intervals = build_patch(net_document(side)), spread(SAMPLES, side)
    return lambda: patch.samples(intervals, intervals)


def one_point_moved(side):
    document = net_document(side)
    before = Evaluation(document)
    before.matrix  # noqa: B018 - what an edit stands on has been asked for
    moved = edits.set_point(document, 2, 2, document.control_points[2, 2] + 0.1)
    return lambda: Evaluation(moved, before).matrix


def box_after_one_point_moved(side):
    """Return a call that finds the box of the samples by what is known of the windows before."""
    document = net_document(side)
    moved = edits.set_point(document, 2, 2, document.control_points[2, 2] + 0.1)
    patch, known = build_patch(moved), (document, bounds_of_windows(document, build_patch(document)))
    return lambda: patch.sampled_box(*moved.intervals, lambda: bounds_of_windows(moved, patch, known))


def splipy(side):
    """Return a call that evaluates a bicubic B-spline of as many control points."""
    net = net_document(side).control_points
    rows, columns = net.shape[:2]
    knots_u, knots_v = ([0.0] * 3 + np.linspace(0, 1, count - 2).tolist() + [1.0] * 3 for count in (columns, rows))
    surface = SplipySurface(BSplineBasis(4, knots_u), BSplineBasis(4, knots_v), net.transpose(0, 1, 2).reshape(-1, 3))
    parameters = np.linspace(0, 1, SAMPLES)
    return lambda: surface(parameters.copy(), parameters.copy())


def test_patches(measure):
    document = net_document(50)
    measure("patches 2500", lambda: build_patch(document))


@pytest.mark.parametrize("side", SIDES)
def test_samples(measure, side):
    measure(f"samples {side**2}", samples(side), samples(1))


@pytest.mark.parametrize("side", SIDES)
def test_one_point_moved(measure, side):
    measure(f"moved {side**2}", one_point_moved(side), one_point_moved(1))


@pytest.mark.parametrize("side", SIDES[1:])
def test_box_after_one_point_moved(measure, side):
    measure(f"box net {side**2}", box_after_one_point_moved(side))


@pytest.mark.parametrize("side", SIDES)
def test_splipy(measure, side):
    document, theirs = net_document(side), splipy(side)
    measure(f"splipy net {side**2}", samples(side), theirs, rounds=4)
    measure(f"splipy whole {side**2}", lambda: Evaluation(document).raw, theirs, rounds=4)


def test_the_largest_net_from_its_file(measure, tmp_path):
    path = tmp_path / "largest.qovr"
    write_document(net_document((POINTS - 3) // 2, 101), path)
    measure("net file", lambda: Evaluation(read_document(path)).matrix, rounds=2)


def test_memory(record):
    document = net_document(50)
    Evaluation(document).raw  # noqa: B018
    tracemalloc.start()
    raw = Evaluation(document).raw
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    record("net memory", [peak / 1e6], [raw.nbytes / 1e6])


def test_the_history_of_moved_points(record):
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
    record("net history", [held / 1e6])
