"""One curve with all its parts (the paper's Figure 1): parabolas, weights, transformations, and where it folds back."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
import numpy.typing as npt

from qovr_core.arrays import Array, read_only
from qovr_core.document import Document
from qovr_core.edits import knots_of
from qovr_core.errors import EvaluationError
from qovr_core.geometry import bernstein
from qovr_core.geometry.folding import Parts, folding_parts
from qovr_core.geometry.kernels import inverse_kernels
from qovr_core.geometry.knots import KNOT_NAMES, Direction, Knots
from qovr_core.geometry.weights import CURVE_DEGREE, KERNEL_KNOTS, transformations, weight_coefficients

SAMPLES = read_only(np.linspace(0.0, 1.0, 161))
"""Parameters so close together that a line through their points is seen as the curve; 0, 1/2 and 1 among them."""

PARABOLA_LETTERS = tuple(KNOT_NAMES[k] for k in KERNEL_KNOTS)
"""The letters r, s, t of the parameters of Q_0, Q_1, Q_2, of their transformations (24)-(26) and of their knots."""


@dataclass(frozen=True, eq=False)
class OneCurve:
    """A QOVR curve C(u) of (23), or K(v) of (43), and what it is blended from.

    Parameters
    ----------
    points : (5, 3) its points P_0..P_4; kept read-only
    knots : its internal knots
    decimals : to how many decimals its inverse kernels are cut; None keeps them exact
    direction, number : which of the ten curves it is

    Raises
    ------
    EvaluationError : a knot so close to 0 or 1 that coordinates overflow
    """

    points: Array
    knots: Knots
    decimals: int | None = None
    direction: Direction = Direction.ROWS
    number: int = 0

    def __post_init__(self) -> None:
        object.__setattr__(self, "points", read_only(np.array(self.points, dtype=np.float64)))
        with np.errstate(all="ignore"):
            is_finite = np.isfinite(self._coefficients).all() and np.isfinite(self._parabolas).all()
        if not is_finite:
            value, letter = min(
                zip(self.knots, self.direction.knot_letters, strict=True), key=lambda k: min(k[0], 1 - k[0])
            )
            raise EvaluationError(
                f"{self.name} has no finite coordinates: its {letter} is {value!r}; expected knots farther from 0 and 1"
            )

    @property
    def name(self) -> str:
        """What messages call the curve, as ``C_4``."""
        return self.direction.curve_name(self.number)

    @property
    def parameter(self) -> str:
        """The letter of its parameter, u or v."""
        return self.direction.parameter

    @property
    def coefficients(self) -> Array:
        """Its Bernstein coefficients, (7, 3)."""
        return read_only(self._coefficients)

    @np.errstate(under="ignore")
    def at(self, u: npt.ArrayLike) -> Array:
        """Return the points of the curve at parameters (n,), as (n, 3)."""
        return read_only(bernstein.basis(CURVE_DEGREE, u) @ self._coefficients)

    def parabola(self, p: int, x: npt.ArrayLike) -> Array:
        """Return points of Q_p, eqs. (18)-(20).

        Parameters
        ----------
        p : 0, 1 or 2; Q_p runs through P_p, P_{p+1}, P_{p+2}
        x : (n,) values of its own parameter r, s or t; its points lie at 0, the knot and 1

        Returns
        -------
        (n, 3) float64, read-only
        """
        return read_only(np.vander(np.asarray(x, dtype=np.float64), 3) @ self._parabolas[p])

    def transformed(self, u: npt.ArrayLike) -> Array:
        """Return r(u), s(u) and t(u) of (24)-(26) at parameters (n,), as (n, 3)."""
        return read_only(bernstein.basis(2, u) @ transformations(tuple(self.knots)).T)

    def blends(self, u: npt.ArrayLike) -> Array:
        """Return the weights w_0, w_1, w_2 of the parabolas, (5)-(7), at parameters (n,), as (n, 3)."""
        return read_only(bernstein.basis(2, u))

    def weights(self, u: npt.ArrayLike) -> Array:
        """Return the weights b_0..b_4 of the five points at parameters (n,), as (n, 5)."""
        return read_only(bernstein.basis(CURVE_DEGREE, u) @ self._weights)

    @property
    def landmarks(self) -> Array:
        """The parameters 0, u_ip and 1, at which the curve meets P_1, P_2 and P_3; (3,)."""
        return read_only(np.array([0.0, self.knots.u, 1.0]))

    @property
    def internal_knots(self) -> tuple[float, float, float]:
        """r_ip, s_ip and t_ip: the parameters at which Q_0, Q_1, Q_2 meet P_1, P_2, P_3."""
        return self.knots.r, self.knots.s, self.knots.t

    @property
    def blended(self) -> tuple[tuple[float, float], ...]:
        """The part of each parabola between its points that is blended: Q_0 from P_1, Q_1 whole, Q_2 up to P_3."""
        return (self.knots.r, 1.0), (0.0, 1.0), (0.0, self.knots.t)

    @property
    def auxiliary(self) -> tuple[tuple[float, float], ...]:
        """The parts beyond [0, 1] that the transformations reach too: Q_0 behind P_2, Q_2 before it.

        Of Q_1 it is the part between an end and where s turns round; empty where s is monotone.
        """
        r, _, t = self.transformed([0.0, 1.0]).T
        turn = self._turn
        beyond_the_middle = (turn, 0.0) if turn <= 0 else (1.0, turn)
        return (1.0, float(r[1])), beyond_the_middle, (float(t[0]), 0.0)

    def free_part(self, p: int) -> Array:
        """Return values of the parameter of Q_p where its name has room: Q_0 before P_1, Q_2 behind P_3, all of Q_1."""
        r, _, t = self.internal_knots
        first, last = ((0.0, r), (0.0, 1.0), (t, 1.0))[p]
        return read_only(first + (last - first) * SAMPLES[16:-16])

    @property
    def folding_parts(self) -> Parts:
        """Where it would run back if its points were evenly spaced; empty where it does not fold."""
        return folding_parts(self.knots)

    @property
    def _turn(self) -> float:
        """The s at which s(u) of (25) turns round, below 0 or above 1; 0 where it is monotone."""
        _, s, u, _ = self.knots
        a = (s - u) / (u * (u - 1))
        return float(self.transformed([(a - 1) / (2 * a)])[0, 1]) if abs(a) > 1 else 0.0

    @cached_property
    def _weights(self) -> Array:
        return weight_coefficients(tuple(self.knots), kernel_decimals=self.decimals)

    @cached_property
    def _coefficients(self) -> Array:
        return self._weights @ self.points

    @cached_property
    def _parabolas(self) -> Array:
        """(3, 3, 3): for every parabola the vectors that belong to x^2, x and 1."""
        triples = np.stack([self.points[p : p + 3] for p in range(3)])
        return inverse_kernels(self.internal_knots, decimals=self.decimals) @ triples


def curve_of(document: Document, direction: Direction, number: int) -> OneCurve:
    """Return C_i or K_j of a document, as its formulation computes it.

    Raises
    ------
    EvaluationError : a knot so close to 0 or 1 that coordinates overflow
    """
    net = document.control_points
    points = net[number] if direction is Direction.ROWS else net[:, number]
    knots = knots_of(document, direction)[number, 0]
    return OneCurve(points, knots, document.formulation.kernel_decimals, direction, number)
