"""The table of a run: what was measured, against its goal, and what is missed."""

import statistics
from dataclasses import asdict, dataclass

from .goals import GOALS, Goal

PER_SECOND = {"ns": 1e9, "ms": 1e3, "s": 1, "min": 1 / 60}
"""Of each unit in which times are told."""

COLUMNS = ("measured", "figure", "beside", "its figure", "ratio", "three runs", "goal", "")
ALIGNED = "<><>>><<"
"""How each column stands in its width."""


@dataclass(frozen=True)
class Result:
    """What was measured for one goal: the figures of each run, ours and the peer's, in the goal's unit.

    Parameters
    ----------
    key : the goal's
    figures, peers : of each run; peers are empty where the goal has no peer
    """

    key: str
    figures: tuple[float, ...]
    peers: tuple[float, ...] = ()

    @property
    def goal(self) -> Goal:
        """The goal it is held against."""
        return GOALS[self.key]

    @property
    def values(self):
        """What is held against the limit, of each run."""
        if not self.peers:
            return self.figures
        return tuple(self.goal.value(*pair) for pair in zip(self.figures, self.peers, strict=True))

    @property
    def is_met(self):
        """Whether the median of the runs keeps the limit; None where there is none."""
        return self.goal.is_met(statistics.median(self.values))

    @property
    def cells(self):
        """The row of the table."""
        goal, values = self.goal, self.values
        return (
            goal.what,
            _with_unit(statistics.median(self.figures), goal.unit),
            goal.peer,
            _with_unit(statistics.median(self.peers), goal.unit) if self.peers else "",
            _number(statistics.median(values)) if self.peers else "",
            f"{_number(min(values))}-{_number(max(values))}" if len(values) > 1 else "",
            _limit(goal),
            {True: "met", False: "MISSED", None: ""}[self.is_met],
        )


def as_json(results):
    """Return results as values for a file."""
    return [asdict(result) for result in results]


def rows(results):
    """Return the table, its head first, in the order of the goals."""
    order = list(GOALS)
    return [COLUMNS, *(result.cells for result in sorted(results, key=lambda result: order.index(result.key)))]


def lines(results):
    """Return the table's lines for a terminal."""
    cells = rows(results)
    widths = [max(map(len, column)) for column in zip(*cells, strict=True)]
    padded = ([f"{cell:{side}{w}}" for cell, side, w in zip(row, ALIGNED, widths, strict=True)] for row in cells)
    return ["  ".join(row).rstrip() for row in padded]


def markdown(results):
    """Return the table's lines for the README."""
    head, *body = rows(results)
    return [f"| {' | '.join(row)} |" for row in (head, ["---"] * len(head), *body)]


def verdict(results):
    """Return the line that ends the table: what is missed."""
    held = [result for result in results if result.is_met is not None]
    missed = [result.key for result in held if not result.is_met]
    return f"missed: {len(missed)} of {len(held)}: {'; '.join(missed)}" if missed else f"all {len(held)} goals met"


def _with_unit(value, unit):
    return f"{_number(value)} {unit}".rstrip()


def _number(value):
    return f"{value:,.0f}" if abs(value) >= 1000 else f"{value:.3g}"


def _limit(goal):
    if goal.limit is None:
        return ""
    unit = "" if goal.peer else f" {goal.unit}"
    return f"{goal.direction} {goal.limit:g}{unit}".rstrip()
