"""The immutable document: everything that defines one QOVR surface."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import cached_property
from math import hypot

import numpy as np
import numpy.typing as npt

from qovr_core.arrays import Array, Indices
from qovr_core.checks import checked_choice, checked_samples, entries
from qovr_core.errors import DocumentError
from qovr_core.formulations import FORMULATIONS, Formulation
from qovr_core.geometry.knots import Direction, Knots, KnotTable
from qovr_core.geometry.locate import spread
from qovr_core.geometry.windows import window_count
from qovr_core.joints import Joints, checked_closed, checked_joints, smooth_where_possible
from qovr_core.knot_input import KnotsLike, checked_knots
from qovr_core.net_input import checked_net

NetIndex = tuple[int, int]
"""Row i and column j of a control point."""

_ALL_HALF = Knots()

Window = tuple[int, int]
"""A window (a, b) of a net: a counts along v, b along u."""

ALIKE_WHERE_CLOSED = 3
"""Rows (columns) at the end of a closed net that are those at its beginning."""


@dataclass(frozen=True, eq=False, init=False)
class Document:
    """The inputs of one surface; never changed, only replaced (``qovr_core.edits``).

    A net of m x n windows, each of 5 x 5 points, has 2m + 3 rows and 2n + 3 columns; one window is the paper's case.
    Window (a, b) holds the rows 2a to 2a + 4 and the columns 2b to 2b + 4.

    Parameters
    ----------
    control_points : (2m+3, 2n+3, 3), ``[i, j]`` is P_{i,j} in row i and column j; kept as read-only float64
    row_knots : the knots of C_0..C_{2m+2}, which run along the rows through n windows: an array (2m+3, n, 4), a list
        of one ``Knots`` a curve or of lists of n of them, or one ``Knots`` for all
    column_knots : the knots of K_0..K_{2n+2}, which run along the columns through m windows; their ``u`` is v_ip
    formulation : a Formulation, or the name of a registered one
    samples : number of samples along u and along v over the whole, each from 2, or windows + 1, to 4096
    joints : which joints between windows are smooth; None where they are as smooth as the knots allow
    closed : of ``u`` and ``v`` the directions in which the net closes: its last three columns (rows) are the first

    Raises
    ------
    DocumentError : a value is out of its range, not finite, or of the wrong shape; it names the place

    Examples
    --------
    >>> net = [[[j, i, i * j] for j in range(5)] for i in range(5)]
    >>> document = Document(net, formulation="double-sum", samples=(11, 21))
    >>> document.control_points[4, 1]
    array([1., 4., 4.])
    >>> print(document.formulation, document.row_knots[0, 0])
    double-sum Knots(r=0.5, s=0.5, u=0.5, t=0.5)
    """

    control_points: Array
    row_knots: KnotTable
    column_knots: KnotTable
    formulation: Formulation
    samples: tuple[int, int]
    joints: Joints
    closed: tuple[str, ...]

    def __init__(
        self,
        control_points: npt.ArrayLike,
        row_knots: KnotsLike = _ALL_HALF,
        column_knots: KnotsLike = _ALL_HALF,
        formulation: Formulation | str = Formulation.PUBLISHED,
        samples: Sequence[int] = (101, 101),
        *,
        joints: Joints | None = None,
        closed: Iterable[str] = (),
    ) -> None:
        net = checked_net(control_points)
        rows, columns = net.shape[:2]
        m, n = window_count(rows), window_count(columns)
        row_table = checked_knots(row_knots, Direction.ROWS, rows, n)
        column_table = checked_knots(column_knots, Direction.COLUMNS, columns, m)
        closed_along = checked_closed(closed)
        if joints is None:
            joints = smooth_where_possible(row_table, column_table, closed_along)
        values = {
            "control_points": net,
            "row_knots": row_table,
            "column_knots": column_table,
            "formulation": _checked_formulation(formulation),
            "samples": _checked_counts(samples, (n, m)),
            "joints": checked_joints(joints, row_table, column_table, closed_along),
            "closed": closed_along,
        }
        for name, value in values.items():
            object.__setattr__(self, name, value)
        self._check_closed()

    @property
    def windows(self) -> tuple[int, int]:
        """How many windows the net has along v and along u, (m, n)."""
        return self.column_knots.windows, self.row_knots.windows

    @property
    def is_one_window(self) -> bool:
        """Whether the net is the paper's, of 5 x 5 points."""
        return self.windows == (1, 1)

    @property
    def intervals(self) -> tuple[Indices, Indices]:
        """The intervals between samples that fall to each window along u, (n,), and along v, (m,)."""
        (m, n), samples = self.windows, self.samples
        return spread(samples[0], n), spread(samples[1], m)

    def is_closed(self, direction: Direction) -> bool:
        """Return whether the net closes along the curves of a direction."""
        return direction.parameter in self.closed

    @property
    def net_size(self) -> float:
        """The size of the net: the diagonal of the control points' box."""
        return hypot(*np.ptp(self.control_points, axis=(0, 1)))

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Document):
            return NotImplemented
        return self is other or (
            self.control_points.shape == other.control_points.shape
            and self._rest == other._rest
            and np.array_equal(self.control_points, other.control_points)
            and self.row_knots == other.row_knots
            and self.column_knots == other.column_knots
        )

    def __hash__(self) -> int:
        return self._hash

    @cached_property
    def _hash(self) -> int:
        points = self.control_points + 0.0  # so that -0.0, which equals 0.0, has its hash
        return hash((points.tobytes(), self.row_knots, self.column_knots, self._rest))

    @property
    def _rest(self) -> tuple[object, ...]:
        return self.formulation, self.samples, self.joints, self.closed

    def _check_closed(self) -> None:
        """Raise DocumentError where a closed net does not close."""
        for direction, name, crossing, knots in (
            (Direction.ROWS, "column", self.control_points.swapaxes(0, 1), self.column_knots),
            (Direction.COLUMNS, "row", self.control_points, self.row_knots),
        ):
            if not self.is_closed(direction):
                continue
            if len(crossing) < 2 * ALIKE_WHERE_CLOSED:
                raise DocumentError(
                    "closed", f"a list with {direction.parameter}", "a net of two windows or more there"
                )
            last = len(crossing) - ALIKE_WHERE_CLOSED
            for k in range(ALIKE_WHERE_CLOSED):
                expected = f"that of {name} {k}, since the net is closed along {direction.parameter}"
                if not np.array_equal(crossing[k], crossing[last + k]):
                    raise DocumentError("control_points", f"another {name} {last + k}", expected)
                if not np.array_equal(knots.array[k], knots.array[last + k]):
                    raise DocumentError(f"{direction.other}[{last + k}]", "different", expected)


def _checked_formulation(formulation: object) -> Formulation:
    if isinstance(formulation, Formulation):
        return formulation
    return FORMULATIONS[checked_choice(formulation, "formulation", FORMULATIONS)]


def _checked_counts(samples: object, windows: tuple[int, int]) -> tuple[int, int]:
    n, m = entries(samples, "samples", 2)
    counts = checked_samples(n, "samples[0]"), checked_samples(m, "samples[1]")
    for k, (count, along) in enumerate(zip(counts, windows, strict=True)):
        if count <= along:
            raise DocumentError(
                f"samples[{k}]", str(count), f"at least {along + 1}, for the net has {along} windows there"
            )
    return counts
