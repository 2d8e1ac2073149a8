"""What benchmarks share: two fixtures to report by, and the table at the end of ``make bench``."""

import json
import os
import time
from pathlib import Path

import pytest

from . import table
from .goals import GOALS
from .timing import in_turn

KEPT = Path(__file__).parents[2] / "build/benchmarks.json"
"""The newest result of each goal, quick or long; ``benchmarks.readme`` writes the README's table from it."""

STARTED = time.monotonic()
RESULTS = {}


@pytest.fixture
def record(request):
    """A function that puts figures into the table by a goal's key: of each run ours, and the peer's if it has one."""
    is_long = request.node.get_closest_marker("long") is not None

    def add(key, figures, peers=()):
        goal = GOALS[key]
        assert goal.is_long == is_long, f"{key}: the goal and its test must agree whether it is long"
        assert len(peers) == (len(figures) if goal.peer else 0), f"{key}: figures of the peer too, or none"
        RESULTS[key] = table.Result(key, tuple(map(float, figures)), tuple(map(float, peers)))

    return add


@pytest.fixture
def measure(record):
    """A function that times a call and its peer's in turn, three runs of so many rounds, and records the medians.

    A peer that takes long is called in ``every`` so many rounds only.
    """

    def run(key, ours, *peer, rounds=15, every=1, clock=time.perf_counter):
        scale = table.PER_SECOND[GOALS[key].unit]
        taken = in_turn(ours, *peer, rounds=rounds, every=every, clock=clock)
        record(key, *([scale * seconds for seconds in runs] for runs in taken))

    return run


def pytest_terminal_summary(terminalreporter, config):
    """Print the table, and keep it for the README."""
    if _is_whole(config) and not _is_long(config):
        RESULTS["make bench"] = table.Result("make bench", ((time.monotonic() - STARTED) / 60,))
    if not RESULTS:
        return
    terminalreporter.section("ratio: ours over the other where the goal is <=, the other over ours where it is >=")
    for line in table.lines(RESULTS.values()):
        terminalreporter.write_line(line)
    terminalreporter.write_line(f"{os.cpu_count()} cores, load {os.getloadavg()[1]:.1f} in the last five minutes")
    _keep()


def pytest_unconfigure(config):
    """Say last what is missed, and what of a whole run was not measured."""
    if not RESULTS:
        return
    wanted = [key for key, goal in GOALS.items() if _is_whole(config) and goal.is_long == _is_long(config)]
    silent = [key for key in wanted if key not in RESULTS]
    reporter = config.pluginmanager.get_plugin("terminalreporter")
    if silent:
        reporter.write_line(f"not measured: {len(silent)} of {len(wanted)}: {'; '.join(silent)}")
    reporter.write_line(table.verdict(RESULTS.values()))


def _is_whole(config):
    """Return whether all benchmarks of a kind were asked for, not some files or names."""
    return all(Path(argument).is_dir() for argument in config.args) and not config.option.keyword


def _is_long(config):
    return config.option.markexpr == "long"


def _keep():
    """Put what was measured beside what other runs did."""
    kept = {found["key"]: found for found in json.loads(KEPT.read_text(encoding="utf-8"))} if KEPT.exists() else {}
    kept |= {found["key"]: found for found in table.as_json(RESULTS.values())}
    KEPT.parent.mkdir(exist_ok=True)
    KEPT.write_text(json.dumps([kept[key] for key in GOALS if key in kept], indent=1), encoding="utf-8")
