"""Where rows and columns of a net stand after an edit of its structure, as a value that can be taken back."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from qovr_core import Document
from qovr_core.arrays import Indices
from qovr_core.document import NetIndex, Window
from qovr_core.edits import knots_of
from qovr_core.geometry.knots import Direction
from qovr_core.geometry.windows import STEP


@dataclass(frozen=True)
class Renumbering:
    """The new number of every row and column, by the old one; those that are gone are missing.

    Parameters
    ----------
    rows, columns : the numbers
    is_transposed : whether rows are columns afterwards, by these numbers
    """

    rows: Mapping[int, int]
    columns: Mapping[int, int]
    is_transposed: bool = False

    def point(self, index: NetIndex) -> NetIndex | None:
        """Return where a control point is afterwards; None where it is gone."""
        i, j = self.rows.get(index[0]), self.columns.get(index[1])
        if i is None or j is None:
            return None
        return (j, i) if self.is_transposed else (i, j)

    def window(self, window: Window) -> Window | None:
        """Return the window in which the middle of a window, or what is left of it, lies afterwards; else None."""
        found = []
        for at, lines in zip(window, (self.rows, self.columns), strict=True):
            first = STEP * at + 1
            middle, ends = lines.get(first + 1), [lines[end] for end in (first, first + 2) if end in lines]
            if middle is None and not ends:
                return None
            found.append(max((min(ends) - 1 if middle is None else middle - 2) // STEP, 0))
        a, b = found
        return (b, a) if self.is_transposed else (a, b)

    @property
    def back(self) -> Renumbering:
        """What takes it back."""
        rows, columns = ({new: old for old, new in lines.items()} for lines in (self.rows, self.columns))
        return Renumbering(columns, rows, True) if self.is_transposed else Renumbering(rows, columns)


def lines_kept(document: Document) -> list[Mapping[int, int]]:
    """Return rows and columns that stay where they are."""
    rows, columns, _ = document.control_points.shape
    return [{k: k for k in range(count)} for count in (rows, columns)]


def lines_of_origin(document: Document, direction: Direction, origin: Indices) -> Mapping[int, int]:
    """Return where the lines across the curves of a direction are, by which line each one was, -1 for none.

    In a net that closes along them, its first and its last lines are the same ones: they go to the first joint and on.
    """
    closes = document.is_closed(direction)
    kept = range(1, len(origin) - 2) if closes else range(len(origin))
    now = {int(origin[new]): new for new in kept if origin[new] >= 0}
    if closes:
        period = STEP * knots_of(document, direction).windows
        for old in (0, period + 1, period + 2):
            alike = (old - 1) % period + 1
            if alike in now:
                now[old] = now[alike]
    return now
