"""The four internal knots of one curve (Table 1)."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from enum import StrEnum

import numpy as np

from qovr_core.arrays import Array, read_only
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
    """Where one knot stands: its family of curves, the curve's number, ``r``, ``s``, ``u`` (v_ip) or ``t``, and the
    window along the curve."""

    direction: Direction
    curve: int
    name: str
    window: int = 0

    @property
    def number(self) -> int:
        """Its place in ``KNOT_NAMES``."""
        return KNOT_NAMES.index(self.name)

    @property
    def letter(self) -> str:
        """What the paper writes it as: v for the knot of a column curve that is u on a row."""
        return self.direction.knot_letters[self.number]

    def text(self, windows: int) -> str:
        """Return the place in the words of a document whose curves run through so many windows."""
        window = f"[{self.window}]" if windows > 1 else ""
        return f"{self.direction}[{self.curve}]{window}.{self.letter}"

    def __str__(self) -> str:
        return self.text(self.window + 1)


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


@dataclass(frozen=True, eq=False)
class KnotTable:
    """The knots of a family of curves; ``table[curve, window]`` are those of one curve in one window along it.

    Parameters
    ----------
    array : (curves, windows, 4) float64 in the order of ``KNOT_NAMES``; kept read-only

    Raises
    ------
    ValueError : the array has another shape

    Examples
    --------
    >>> table = KnotTable(np.full((5, 1, 4), 0.5))
    >>> len(table), table.windows, table[4, 0]
    (5, 1, Knots(r=0.5, s=0.5, u=0.5, t=0.5))
    """

    array: Array

    def __post_init__(self) -> None:
        array = np.array(self.array, dtype=np.float64)
        if array.ndim != 3 or array.shape[2] != len(KNOT_NAMES):
            raise ValueError(f"knots have shape {array.shape}; expected (curves, windows, {len(KNOT_NAMES)})")
        object.__setattr__(self, "array", read_only(array))

    @property
    def windows(self) -> int:
        """Through how many windows each curve runs."""
        return int(self.array.shape[1])

    def __len__(self) -> int:
        return int(self.array.shape[0])

    def __getitem__(self, at: tuple[int, int]) -> Knots:
        curve, window = at
        return Knots(*self.array[curve, window].tolist())

    def in_window(self, window: int) -> tuple[Knots, ...]:
        """Return the knots of all curves in one window along them."""
        return tuple(Knots(*knots) for knots in self.array[:, window].tolist())

    __iter__ = None  # without it, Python would try numbers in place of pairs

    def __eq__(self, other: object) -> bool:
        return isinstance(other, KnotTable) and np.array_equal(self.array, other.array)

    def __hash__(self) -> int:
        return hash(self.array.tobytes())
