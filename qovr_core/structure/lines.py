"""The columns of a net with all that goes where they go."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from qovr_core.arrays import Array, Indices
from qovr_core.checks import SAMPLES_RANGE
from qovr_core.document import Document
from qovr_core.geometry.knots import KnotTable
from qovr_core.geometry.windows import window_count
from qovr_core.joints import Joint


@dataclass(frozen=True, eq=False)
class Lines:
    """Columns of a net.

    Parameters
    ----------
    points : (k, rows, 3)
    knots : (k, m, 4) of the curves along them
    origin : (k,) which column each one was, -1 where it is new
    """

    points: Array
    knots: Array
    origin: Indices

    @classmethod
    def of(cls, document: Document) -> Lines:
        net = document.control_points.swapaxes(0, 1)
        return cls(net, document.column_knots.array, np.arange(len(net)))

    def inserted(self, at: int, other: Lines) -> Lines:
        """Return them with two others, one before and one after the line at a place."""
        places = [at, at + 1]
        return Lines(
            np.insert(self.points, places, other.points, axis=0),
            np.insert(self.knots, places, other.knots, axis=0),
            np.insert(self.origin, places, other.origin),
        )

    def followed_by(self, other: Lines) -> Lines:
        """Return them with others behind."""
        return Lines(
            np.concatenate([self.points, other.points]),
            np.concatenate([self.knots, other.knots]),
            np.concatenate([self.origin, other.origin]),
        )

    def without(self, *places: int) -> Lines:
        """Return them with some left out."""
        return self._picked(np.delete(np.arange(len(self.points)), places))

    def rolled(self, steps: int) -> Lines:
        """Return them with as many of the last ones first."""
        return self._picked(np.roll(np.arange(len(self.points)), steps))

    def ring(self) -> Lines:
        """Return those of a closed net, each once, from its first joint on."""
        return self._picked(np.arange(1, len(self.points) - 2))

    def unrolled(self) -> Lines:
        """Return the closed net of a ring."""
        count = len(self.points)
        return self._picked(np.arange(-1, count + 2) % count)

    def _picked(self, places: Indices) -> Lines:
        return Lines(self.points[places], self.knots[places], self.origin[places])


def rebuilt(document: Document, lines: Lines, row_knots: Array, joints: list[Joint]) -> Document:
    """Return a document of other columns and windows, with as many intervals between samples a window.

    Where that were more samples than there may be, it has the most.
    """
    windows = window_count(len(lines.points))
    along_u, along_v = document.samples
    intervals = round((along_u - 1) * windows / document.windows[1])
    return replace(
        document,
        control_points=lines.points.swapaxes(0, 1),
        row_knots=KnotTable(row_knots),
        column_knots=KnotTable(lines.knots),
        samples=(min(intervals + 1, SAMPLES_RANGE[1]), along_v),
        joints=replace(document.joints, u=tuple(joints)),
    )
