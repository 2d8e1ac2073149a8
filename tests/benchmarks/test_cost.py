"""How cost grows: with the windows, with the samples, with the control points that are drawn, with the edits made."""

from pathlib import Path

import numpy as np
import pytest

from qovr_core import Evaluation, build_patch, edits
from support.nets import random_net_document

from . import cost
from .timing import RUNS, in_turn

pytest.importorskip("PySide6")

from .test_evaluation import box, raw
from .test_net_view import waves
from .test_view import bench  # noqa: F401 - a fixture

BUILD = Path(__file__).parents[2] / "build"

WINDOWS = ((1, 1), (2, 5), (10, 10), (50, 50), (100, 100))
SAMPLES = (101, 201, 501, 1001, 2001, 4096)
SIDES = (1, 3, 9, 19, 39, 99)
"""Windows along each direction of nets with 25 to 40,401 control points."""

EDITS = (1, 10, 100, 1000, 5000, 20_000)

FRAMES = 16  # an even number, so that steps go up and down by turns
LINES = []


def milliseconds(*calls, rounds=7):
    """Return the quickest of three runs of each call."""
    return [1e3 * min(runs) for runs in in_turn(*calls, rounds=rounds)]


def quickest(bench, act):  # noqa: F811
    """Return the quickest of three runs of frames."""
    return min(bench.milliseconds(act, FRAMES) for _ in range(RUNS))


def keep(over, amounts, taken):
    """Keep a line for each name in what was taken at each amount."""
    LINES.extend(cost.Line(over, what, tuple(amounts), tuple(each[what] for each in taken)) for what in taken[0])


@pytest.mark.long
def test_windows():
    taken = []
    for windows in WINDOWS:
        document = random_net_document(1, windows, flatness=0.3, samples=(1001, 1001))
        before = Evaluation(document)
        before.matrix  # noqa: B018 - what an edit stands on has been asked for
        moved = edits.set_point(document, 2, 2, document.control_points[2, 2] + 0.1)
        calls = {
            "all patches": lambda document=document: build_patch(document),
            "1001 x 1001 samples": lambda document=document: Evaluation(document).raw,
            "one point moved, with T": lambda moved=moved, before=before: Evaluation(moved, before).matrix,
        }
        taken.append(dict(zip(calls, milliseconds(*calls.values()), strict=True)))
    keep("windows", [a * b for a, b in WINDOWS], taken)


@pytest.mark.long
def test_samples(bench):  # noqa: F811
    taken = []
    for size in SAMPLES:
        bench.dispatch("SamplesChosen", (size, size))
        bench.settle()
        bench.timed(bench.edit, 5)
        found = milliseconds(raw(size), box(size))
        taken.append(
            {
                "samples": found[0],
                "box of the samples": found[1],
                "edit with redraw": quickest(bench, bench.edit),
            }
        )
    bench.dispatch("SamplesChosen", (101, 101))
    keep("samples along u and along v", SAMPLES, taken)


@pytest.mark.long
def test_control_points(bench):  # noqa: F811
    taken = []
    for side in SIDES:
        bench.dispatch("Opened", waves(side), "net")
        bench.settle(2.0)
        found = {}
        for what, act in (("step of an orbit", bench.orbit), ("edit with redraw", bench.edit)):
            bench.timed(act, 5)
            found[what] = quickest(bench, act)
        taken.append(found)
    bench.dispatch("Opened", waves(1), "net")
    keep("control points drawn", [(2 * side + 3) ** 2 for side in SIDES], taken)


@pytest.mark.long
def test_edits(bench):  # noqa: F811
    made, taken = 0, []
    for wanted in EDITS:
        while made < wanted - 1:
            bench.step(made)
            made += 1
            if made % 100 == 0:
                bench.application.processEvents()
        bench.settle()
        taken.append({"edit with redraw": quickest(bench, lambda k, made=made: bench.step(made + k))})
        made += RUNS * FRAMES
        undone = [1e3 * bench.frame(lambda _, name=name: bench.dispatch(name), 0) for name in ("Undone", "Redone") * 5]
        taken[-1]["undo or redo with redraw"] = float(np.median(undone))
    keep("edits made before", EDITS, taken)


@pytest.mark.long
def test_picture():
    """Not a measurement: it draws what was measured above."""
    BUILD.mkdir(exist_ok=True)
    (BUILD / "cost.csv").write_text(cost.as_text(LINES), encoding="utf-8")
    cost.draw(LINES, BUILD / "cost.png")
