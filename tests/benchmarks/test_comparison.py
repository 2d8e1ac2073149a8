"""The comparison: the closest points, all measures, and the command."""

import statistics
import time

import pytest

from qovr_core import Evaluation
from qovr_core.evaluation import parameters
from qovr_core.geometry.closest import closest_points
from qovr_core.laboratory.comparison import compare
from qovr_core.laboratory.splines import b_spline
from qovr_core.presets import preset
from support.command import qovr

from .conftest import MEDIANS

RUNS = 10
LONGEST_SEARCH = 0.1
"""Seconds for the 10,201 points of the paper's grid."""

LONGEST_COMMAND = 2.0
"""Seconds, the interpreter's start included."""


def test_closest_points(measure, row):
    document = preset("fig8").document
    patch, grid = Evaluation(document).transformed_patch, parameters(101)
    points = b_spline(document.control_points).points(grid, grid).reshape(-1, 3)
    measure("closest points", 101, lambda: closest_points(patch, points))
    row("closest points: part of 0.1 s", 101, MEDIANS["closest points", 101] / LONGEST_SEARCH, at_most=1)


@pytest.mark.parametrize("name", ["fig5", "fig6c", "fig8"])
def test_measures(row, name):
    seconds = []
    for _ in range(RUNS):
        start = time.perf_counter()
        compare(preset(name).document)
        seconds.append(time.perf_counter() - start)
    row("compare, ms", name, 1e3 * statistics.median(seconds))


def test_command(row):
    seconds = []
    for _ in range(5):
        start = time.perf_counter()
        assert qovr("compare", "paper:fig5").code == 0
        seconds.append(time.perf_counter() - start)
    row("qovr compare paper:fig5, s", "fig5", statistics.median(seconds), at_most=LONGEST_COMMAND)
