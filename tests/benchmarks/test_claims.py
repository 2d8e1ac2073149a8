"""The claims: how long all of them take."""

import statistics
import time

import pytest

from qovr_core.laboratory import knot_claims
from qovr_core.laboratory.verify import verify
from qovr_core.presets import preset
from support.command import qovr

RUNS = 15
LONGEST_COMMAND = 2.0
"""Seconds, the interpreter's start included."""


@pytest.mark.parametrize("name", ["fig5", "fig6c"])
def test_claims(row, name):
    verify(preset(name).document)  # what every document shares is computed once
    seconds = []
    for _ in range(RUNS):
        knot_claims.knot_moves.cache_clear()
        start = time.perf_counter()
        verify(preset(name).document)
        seconds.append(time.perf_counter() - start)
    row("verify, ms", name, 1e3 * statistics.median(seconds))


def test_command(row):
    seconds = []
    for _ in range(5):
        start = time.perf_counter()
        assert qovr("verify", "paper:fig5").code == 0
        seconds.append(time.perf_counter() - start)
    row("qovr verify paper:fig5, s", "fig5", statistics.median(seconds), at_most=LONGEST_COMMAND)
