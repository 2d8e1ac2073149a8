"""The claims: how long all of them take, and the longest wait for the next verdict."""

import itertools
import statistics
import time

import pytest

from qovr_core.laboratory import joint_claims, knot_claims
from qovr_core.laboratory.verify import verify
from qovr_core.presets import preset
from support.command import qovr

RUNS = 15
LONGEST_WAIT = 50.0
"""Milliseconds: a row of verdicts then follows the other without a pause that is seen."""

LONGEST_COMMAND = 2.0
"""Seconds, the interpreter's start included."""


@pytest.mark.parametrize("name", ["fig5", "fig6c"])
def test_findings(row, name):
    verify(preset(name).document)  # what every document shares is computed once
    longest, total = [], []
    for _ in range(RUNS):
        knot_claims.knot_moves.cache_clear()
        joint_claims.joint_jumps.cache_clear()
        times = [time.perf_counter()]
        verify(preset(name).document, report=lambda _finding, times=times: times.append(time.perf_counter()))
        longest.append(1e3 * max(after - before for before, after in itertools.pairwise(times)))
        total.append(1e3 * (times[-1] - times[0]))
    row("longest wait for a verdict, ms", name, statistics.median(longest), at_most=LONGEST_WAIT)
    row("verify, ms", name, statistics.median(total))


def test_command(row):
    seconds = []
    for _ in range(5):
        start = time.perf_counter()
        assert qovr("verify", "paper:fig5").code == 0
        seconds.append(time.perf_counter() - start)
    row("qovr verify paper:fig5, s", "fig5", statistics.median(seconds), at_most=LONGEST_COMMAND)
