"""The claims: how long all of them take, and the longest wait for the next verdict."""

import itertools
import statistics
import time

import pytest

from qovr_core.laboratory import joint_claims, knot_claims
from qovr_core.laboratory.verify import verify
from qovr_core.presets import preset

from .timing import RUNS

ROUNDS = 5


def waits(document):
    """Return the milliseconds before each verdict."""
    knot_claims.knot_moves.cache_clear()
    joint_claims.joint_jumps.cache_clear()
    times = [time.perf_counter()]
    verify(document, report=lambda _finding: times.append(time.perf_counter()))
    return [1e3 * (after - before) for before, after in itertools.pairwise(times)]


@pytest.mark.parametrize("name", ["fig5", "fig6c"])
def test_findings(record, name):
    document = preset(name).document
    verify(document)  # what every document shares is computed once
    runs = [[waits(document) for _ in range(ROUNDS)] for _ in range(RUNS)]
    record(f"verify wait {name}", [statistics.median(map(max, run)) for run in runs])
    record(f"verify {name}", [statistics.median(map(sum, run)) for run in runs])
