"""The comparison: the closest points, all measures, and the longest wait for the next surface's."""

import itertools
import statistics
import time

import pytest

from qovr_core import Evaluation
from qovr_core.evaluation import parameters
from qovr_core.geometry.closest import closest_points
from qovr_core.laboratory.comparison import compare
from qovr_core.laboratory.splines import b_spline
from qovr_core.presets import preset

from .timing import RUNS

ROUNDS = 4


def test_closest_points(measure):
    document = preset("fig8").document
    patch, grid = Evaluation(document).transformed_patch, parameters(101)
    points = b_spline(document.control_points).points(grid, grid).reshape(-1, 3)
    measure("closest points", lambda: closest_points(patch, points))


def waits(document):
    """Return the milliseconds before each surface's measures."""
    times = [time.perf_counter()]
    compare(document, report=lambda _name, _measures: times.append(time.perf_counter()))
    return [1e3 * (after - before) for before, after in itertools.pairwise(times)]


@pytest.mark.parametrize("name", ["fig5", "fig6c", "fig8"])
def test_measures(record, name):
    document = preset(name).document
    runs = [[waits(document) for _ in range(ROUNDS)] for _ in range(RUNS)]
    record(f"compare wait {name}", [statistics.median(map(max, run)) for run in runs])
    record(f"compare {name}", [statistics.median(map(sum, run)) for run in runs])
