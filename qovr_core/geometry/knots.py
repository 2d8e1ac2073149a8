"""The four internal knots of one curve (Table 1)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from qovr_core.arrays import Array
from qovr_core.checks import checked_knot


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
    """

    r: float = 0.5
    s: float = 0.5
    u: float = 0.5
    t: float = 0.5

    def __post_init__(self) -> None:
        for name in ("r", "s", "u", "t"):
            object.__setattr__(self, name, checked_knot(getattr(self, name), name))

    def __iter__(self) -> Iterator[float]:
        return iter((self.r, self.s, self.u, self.t))

    @property
    def is_quartic(self) -> bool:
        """Whether the curve is of degree 4 in its parameter; otherwise it is of degree 6."""
        return self.s == self.u

    @property
    def is_monotone(self) -> bool:
        """Whether the transformation s(u) of (25) is monotone on [0, 1]; otherwise the curve folds back."""
        return abs(self.s - self.u) <= self.u * (1 - self.u)


def knot_array(knots: Sequence[Knots]) -> Array:
    """Return the knots of several curves as (k, 4) float64 in the order r, s, u, t."""
    return np.array([tuple(curve) for curve in knots], dtype=np.float64)
