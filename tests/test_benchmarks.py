"""The table of the benchmarks: which way a ratio is taken, and what is said to be missed."""

from benchmarks.goals import GOALS, ROWS, Goal
from benchmarks.table import Result, lines, verdict


def test_every_goal_has_a_key_of_its_own_and_a_direction():
    assert len(GOALS) == len(ROWS)
    assert {goal.direction for goal in ROWS} == {"<=", ">="}


def test_a_ratio_is_ours_over_the_peer_or_the_peer_over_ours():
    assert Goal("a", "ours", "theirs", "<=", 2).value(3.0, 2.0) == 1.5
    assert Goal("a", "ours", "theirs", ">=", 2).value(3.0, 6.0) == 2.0
    assert Goal("a", "ours", "", "<=", 2).value(3.0, None) == 3.0


def test_the_last_line_names_what_is_missed():
    met = Result("raw/copy 1001", (1.0, 1.1, 9.0), (1.0, 1.0, 1.0))  # the median of the runs counts
    missed = Result("splipy 1001", (1.0, 1.0, 1.0), (1.9, 1.9, 2.1))
    informs = Result("verify fig5", (700.0,))
    assert verdict([met, informs]) == "all 1 goals met"
    assert verdict([met, missed, informs]) == "missed: 1 of 2: splipy 1001"
    assert [line.split()[-1] for line in lines([missed, met, informs])] == ["goal", "met", "MISSED", "ms"]
