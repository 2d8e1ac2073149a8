"""The immutable document: everything that defines one QOVR surface."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from math import hypot
from typing import Any

import numpy as np
import numpy.typing as npt

from qovr_core.arrays import Array, read_only
from qovr_core.checks import LARGEST_MAGNITUDE, checked_choice, checked_number, checked_samples, described
from qovr_core.errors import DocumentError
from qovr_core.formulations import FORMULATIONS, Formulation
from qovr_core.geometry.knots import Knots

NET_SIZE = 5
"""Rows and columns of the control net."""

NetIndex = tuple[int, int]
"""Row i and column j of a control point."""


@dataclass(frozen=True, eq=False)
class Document:
    """The inputs of one surface; never changed, only replaced (``qovr_core.edits``).

    Parameters
    ----------
    control_points : (5, 5, 3), ``[i, j]`` is P_{i,j} in row i and column j; kept as read-only float64
    row_knots : the knots of C_0..C_4, which run along the rows
    column_knots : the knots of K_0..K_4, which run along the columns; their ``u`` is v_ip
    formulation : a Formulation, or the name of a registered one
    samples : number of samples along u and along v, each from 2 to 4096

    Raises
    ------
    DocumentError : a value is out of its range, not finite, or of the wrong shape; it names the place

    Examples
    --------
    >>> net = [[[j, i, i * j] for j in range(5)] for i in range(5)]
    >>> document = Document(net, formulation="double-sum", samples=(11, 21))
    >>> document.control_points[4, 1]
    array([1., 4., 4.])
    >>> print(document.formulation, document.row_knots[0])
    double-sum Knots(r=0.5, s=0.5, u=0.5, t=0.5)
    """

    control_points: Array
    row_knots: tuple[Knots, ...] = (Knots(),) * NET_SIZE
    column_knots: tuple[Knots, ...] = (Knots(),) * NET_SIZE
    formulation: Formulation = Formulation.PUBLISHED
    samples: tuple[int, int] = (101, 101)

    def __post_init__(self) -> None:
        replace = object.__setattr__
        replace(self, "control_points", _checked_net(self.control_points))
        replace(self, "row_knots", _checked_curves(self.row_knots, "row_knots"))
        replace(self, "column_knots", _checked_curves(self.column_knots, "column_knots"))
        replace(self, "formulation", _checked_formulation(self.formulation))
        replace(self, "samples", _checked_counts(self.samples))

    @property
    def net_size(self) -> float:
        """The size of the net: the diagonal of the control points' box."""
        return hypot(*np.ptp(self.control_points, axis=(0, 1)))

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Document):
            return NotImplemented
        return self._key() == other._key()

    def __hash__(self) -> int:
        return hash(self._key())

    def _key(self) -> tuple[object, ...]:
        return (
            tuple(self.control_points.ravel().tolist()),
            self.row_knots,
            self.column_knots,
            self.formulation,
            self.samples,
        )


def _checked_net(points: npt.ArrayLike) -> Array:
    shape = (NET_SIZE, NET_SIZE, 3)
    if isinstance(points, np.ndarray) and points.dtype == np.float64 and points.shape == shape:
        net = points
    else:
        net = _net_of_numbers(points)
    for i, j, k in np.argwhere(~(np.abs(net) <= LARGEST_MAGNITUDE)):
        checked_number(net[i, j, k].item(), f"control_points[{i}][{j}][{k}]")
    return read_only(net.copy())


def _net_of_numbers(points: Any) -> Array:
    rows = _entries(points, "control_points", NET_SIZE)
    return np.array(
        [
            [
                [
                    checked_number(value, f"control_points[{i}][{j}][{k}]")
                    for k, value in enumerate(_entries(point, f"control_points[{i}][{j}]", 3))
                ]
                for j, point in enumerate(_entries(row, f"control_points[{i}]", NET_SIZE))
            ]
            for i, row in enumerate(rows)
        ]
    )


def _entries(value: object, place: str, count: int) -> Sequence[Any]:
    """Return a list of exactly ``count`` entries or raise DocumentError."""
    expected = f"a list of {count} entries"
    if isinstance(value, np.ndarray):
        value = list(value)
    if isinstance(value, (str, bytes, dict)) or not isinstance(value, Iterable):
        raise DocumentError(place, described(value), expected)
    entries = list(value)
    if len(entries) != count:
        raise DocumentError(place, described(entries), expected)
    return entries


def _checked_curves(curves: object, place: str) -> tuple[Knots, ...]:
    entries = _entries(curves, place, NET_SIZE)
    for k, knots in enumerate(entries):
        if not isinstance(knots, Knots):
            raise DocumentError(f"{place}[{k}]", described(knots), "a Knots object")
    return tuple(entries)


def _checked_formulation(formulation: object) -> Formulation:
    if isinstance(formulation, Formulation):
        return formulation
    return FORMULATIONS[checked_choice(formulation, "formulation", FORMULATIONS)]


def _checked_counts(samples: object) -> tuple[int, int]:
    n, m = _entries(samples, "samples", 2)
    return checked_samples(n, "samples[0]"), checked_samples(m, "samples[1]")
