"""What was read of one sheet: the tables at its top, and the points below one another as one array."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from qovr_core.arrays import Array
from qovr_core.files import published_layout as layout

HEAD_ROWS = 64
"""Rows in which every cell is kept; all tables but those of points end above."""

HEAD_COLUMNS = 64

_MOST_ODD = 1000
"""Cells among the points that are no numbers, of which the first is told."""

POINT_COLUMNS = tuple(
    layout.column_index(table) + axis for table in (layout.RAW, layout.TRANSFORMED) for axis in (1, 2, 3)
)
_POSITION = {column: k for k, column in enumerate(POINT_COLUMNS)}


class SharedText(int):
    """The number of a text that cells share."""


@dataclass
class SheetCells:
    """What was read of a sheet.

    Parameters
    ----------
    cells : values by zero-based column and one-based row: float, bool, str, SharedText, or Verbatim
    points : (k, 6), raw and transformed coordinates from FIRST_ROW on; NaN where there is no number
    kept_rows : the rows whose points are kept
    last_row : the last row seen
    """

    kept_rows: int
    cells: dict[tuple[int, int], object] = field(default_factory=dict)
    points: Array = field(default_factory=lambda: np.full((64, len(POINT_COLUMNS)), np.nan))
    last_row: int = 0

    @property
    def count(self) -> int:
        """How many raw points there are: the last row with a raw number."""
        columns = POINT_COLUMNS[:3]
        (rows,) = np.nonzero(~np.isnan(self.points[:, :3]).all(axis=1))
        odd = [row - layout.FIRST_ROW for column, row in self.cells if column in columns and row >= layout.FIRST_ROW]
        return max([int(rows[-1]) if rows.size else -1, *odd]) + 1

    def value(self, column: int, row: int) -> object:
        """Return what stands in a cell; None where it is empty or was not read."""
        position, k = _POSITION.get(column), row - layout.FIRST_ROW
        if (column, row) in self.cells or position is None or not 0 <= k < len(self.points):
            return self.cells.get((column, row))
        number = float(self.points[k, position])
        return None if np.isnan(number) else number

    def put(self, column: int, row: int, value: object) -> None:
        """Keep a cell, where it is one of those that are asked for."""
        position = _POSITION.get(column) if row >= layout.FIRST_ROW else None
        if row > self.kept_rows:
            return
        if position is not None and type(value) is float:
            self.points_for(row)[row - layout.FIRST_ROW, position] = value
        elif (position is not None and len(self.cells) < _MOST_ODD) or (row <= HEAD_ROWS and column < HEAD_COLUMNS):
            self.cells[column, row] = value

    def points_for(self, row: int) -> Array:
        """Return the array of points, large enough for a row."""
        needed = row - layout.FIRST_ROW + 1
        if needed > len(self.points):
            longer = np.full((min(max(needed, 2 * len(self.points)), layout.MOST_POINTS), len(POINT_COLUMNS)), np.nan)
            longer[: len(self.points)] = self.points
            self.points = longer
        return self.points
