"""One table of ratios at the end of ``make bench``; every figure in it was measured in the same run."""

from dataclasses import dataclass

import pytest

MEDIANS = {}
ROWS = []


@dataclass
class Row:
    """One line of the table: a measured ratio, and the goal it is held against (None where it only informs)."""

    what: str
    size: str
    ratio: float
    goal: str
    reached: bool | None


@pytest.fixture
def measure(benchmark):
    """Time a call and keep the median under (name, size), so that later rows can be ratios of it."""

    def run(name, size, call, *, rounds=15):
        benchmark.group = f"{size} x {size}"
        benchmark.pedantic(call, rounds=rounds, warmup_rounds=2)
        MEDIANS[name, size] = benchmark.stats.stats.median

    return run


@pytest.fixture
def row():
    """Add a line to the table; ``at_most`` or ``at_least`` is the goal."""

    def add(what, size, ratio, *, at_most=None, at_least=None):
        goal, reached = "", None
        if at_most is not None:
            goal, reached = f"at most {at_most:g}", ratio <= at_most
        if at_least is not None:
            goal, reached = f"at least {at_least:g}", ratio >= at_least
        ROWS.append(Row(what, size, ratio, goal, reached))

    return add


def pytest_terminal_summary(terminalreporter):
    """Print the table."""
    if not ROWS:
        return
    terminalreporter.section("ratios, medians of one run")
    width = max(len(row.what) for row in ROWS)
    for row in ROWS:
        verdict = {True: "reached", False: "MISSED", None: ""}[row.reached]
        line = f"{row.what:<{width}}  {row.size:>11}  {row.ratio:>10.3g}  {row.goal:<15} {verdict}"
        terminalreporter.write_line(line.rstrip())
