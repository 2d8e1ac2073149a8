"""How a time is taken: calls in turn, so that whoever else uses the machine slows each of them alike."""

import statistics
import time

RUNS = 3
"""What is measured is measured so often; the table says how far the ratios lie apart."""


def in_turn(*calls, rounds=15, every=1, clock=time.perf_counter):
    """Return a list for each call, of the median seconds of its rounds in each run; each is called once before.

    All but the first call are left out of the rounds between every so many: for peers that take long.
    """
    for call in calls:
        call()
    return [list(of_call) for of_call in zip(*(_run(calls, rounds, every, clock) for _ in range(RUNS)), strict=True)]


def _run(calls, rounds, every, clock):
    seconds = [[] for _ in calls]
    for k in range(rounds):
        for call, taken in zip(calls[: None if k % every == 0 else 1], seconds, strict=False):
            start = clock()
            call()
            taken.append(clock() - start)
    return [statistics.median(taken) for taken in seconds]
