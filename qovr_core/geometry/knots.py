"""The four internal knots of one curve (Table 1)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from enum import StrEnum

import numpy as np

from qovr_core.arrays import Array
from qovr_core.checks import checked_knot

KNOT_NAMES = ("r", "s", "u", "t")
"""The internal knots of a curve in their order everywhere; ``u`` is written v on a column curve."""


class Direction(StrEnum):
    """The two families of curves, by the names of their knots in a document."""

    ROWS = "row_knots"
    COLUMNS = "column_knots"

    @property
    def letter(self) -> str:
        """The letter of its curves, C_i or K_j."""
        return "C" if self is Direction.ROWS else "K"

    @property
    def parameter(self) -> str:
        """The letter of the parameter that runs along its curves, C_i(u) or K_j(v)."""
        return "u" if self is Direction.ROWS else "v"

    @property
    def other(self) -> Direction:
        """The other family."""
        return Direction.COLUMNS if self is Direction.ROWS else Direction.ROWS

    @property
    def knot_letters(self) -> tuple[str, ...]:
        """What the knots of its curves are written as, in the order of ``KNOT_NAMES``: r s u t, or r s v t."""
        return tuple(self.parameter if name == "u" else name for name in KNOT_NAMES)

    def curve_name(self, number: int) -> str:
        """Return what messages call one of its curves, as ``C_4``."""
        return f"{self.letter}_{number}"


@dataclass(frozen=True, slots=True)
class KnotPlace:
    """Where one knot stands: its family of curves, the curve's number, and ``r``, ``s``, ``u`` (v_ip) or ``t``."""

    direction: Direction
    curve: int
    name: str

    @property
    def number(self) -> int:
        """Its place in ``KNOT_NAMES``."""
        return KNOT_NAMES.index(self.name)

    @property
    def letter(self) -> str:
        """What the paper writes it as: v for the knot of a column curve that is u on a row."""
        return self.direction.knot_letters[self.number]

    def __str__(self) -> str:
        return f"{self.direction}[{self.curve}].{self.letter}"


@dataclass(frozen=True, slots=True)
class Knots:
    """The internal knots of one curve, each strictly between 0 and 1.

    Parameters
    ----------
    r, s, t : r_ip, s_ip and t_ip, where the parabolas Q_0, Q_1, Q_2 meet P_1, P_2, P_3
    u : u_ip, where the curve itself meets P_2; v_ip for a column curve

    Raises
    ------
    DocumentError : a knot is not a number strictly between 0 and 1

    Examples
    --------
    >>> knots = Knots(s=0.4)
    >>> list(knots), knots.is_quartic, knots.degree
    ([0.5, 0.4, 0.5, 0.5], False, 6)
    >>> Knots(u=1)
    Traceback (most recent call last):
    qovr_core.errors.DocumentError: u is 1; expected a number strictly between 0 and 1
    """

    r: float = 0.5
    s: float = 0.5
    u: float = 0.5
    t: float = 0.5

    def __post_init__(self) -> None:
        for name in KNOT_NAMES:
            object.__setattr__(self, name, checked_knot(getattr(self, name), name))

    def __iter__(self) -> Iterator[float]:
        return iter((self.r, self.s, self.u, self.t))

    @property
    def is_quartic(self) -> bool:
        """Whether the curve is of degree 4 in its parameter; otherwise it is of degree 6."""
        return self.s == self.u

    @property
    def degree(self) -> int:
        """The degree of the curve in its parameter, 4 or 6."""
        return 4 if self.is_quartic else 6


def knot_array(knots: Sequence[Knots]) -> Array:
    """Return the knots of several curves as (k, 4) float64 in the order of ``KNOT_NAMES``."""
    return np.array([tuple(curve) for curve in knots], dtype=np.float64)
