r"""Where a curve folds back: where $\sum_j j \, b_j'(u)$, its speed over evenly spaced points, is below 0.

The sum is a polynomial of degree 5 in u. Its sign is decided for the very numbers that the knots are: by bounds where
those settle it, which is nearly always, and in rational arithmetic where they do not, so that a curve which stops for a
moment and goes on is told from one that turns. The kernels are the exact ones under every formulation: truncated, as in
the published workbooks, the weights no longer sum to 1, and the answer would change with the first point's place.
"""

from __future__ import annotations

from functools import lru_cache

import numpy as np
import numpy.typing as npt

from qovr_core.arrays import Array, Flags
from qovr_core.geometry import bernstein
from qovr_core.geometry.knots import KNOT_NAMES, Knots
from qovr_core.geometry.weights import CURVE_DEGREE, KERNEL_KNOTS, transformations

MOST_FOLDS = (CURVE_DEGREE - 1) // 2
"""How many parts of a curve can run back at most: its speed has so many pairs of roots."""

_HALVINGS = 8
"""So often cut in two, a curve has shown its sign unless it all but stops somewhere; then it is decided exactly."""

_ROUNDING = 2.0**-40
"""Part of what is added up that rounding cannot reach: some 30 operations of 2^-53 each, a hundred times over."""

_BLENDING = bernstein.product(np.eye(3)[:, None], np.eye(5)).reshape(15, 7)
"""What each coefficient of each parabola adds to those of the curve."""

_REMEMBERED = 512
STEPS = 1000
"""A range of a knot is found to this part of 1; so fine are sliders, too, which leave both ends out."""


Parts = tuple[tuple[float, float], ...]
"""Parts of a curve, each from its first to its last parameter."""


def folds(knots: npt.ArrayLike) -> Flags:
    """Return whether curves fold back on evenly spaced points.

    Parameters
    ----------
    knots : (..., 4) internal knots r, s, u, t of each curve, each in (0, 1)

    Returns
    -------
    (...) bool

    Examples
    --------
    >>> folds([(0.5, 0.2, 0.2, 0.5), (0.5, 0.2, 0.5, 0.5)])
    array([ True, False])
    """
    k = np.asarray(knots, dtype=np.float64)
    curves = k.reshape(-1, 4)
    result, unsettled = np.zeros(len(curves), dtype=bool), np.arange(len(curves))
    left, right = (half.T for half in bernstein.halving(CURVE_DEGREE - 1))
    with np.errstate(all="ignore"):  # what overflows is left to the exact way
        speeds, error = _speeds(curves)
        for _ in range(_HALVINGS):
            runs_back = (speeds[..., [0, -1]] < -error).any(axis=(1, 2))
            result[unsettled[runs_back]] = True
            is_left = ~(runs_back | (speeds > error).all(axis=(1, 2)))
            unsettled, error = unsettled[is_left], error[is_left]
            speeds = np.concatenate([speeds[is_left] @ left, speeds[is_left] @ right], axis=1)
    for number in unsettled:
        result[number] = bool(folding_parts(Knots(*curves[number].tolist())))
    return np.asarray(result.reshape(k.shape[:-1]))


@lru_cache(maxsize=_REMEMBERED)
def folding_parts(knots: Knots) -> Parts:
    """Return between which parameters a curve runs back on evenly spaced points; none where it does not fold.

    Where it only stops and goes on, as at a double root of its speed, it does not fold.

    Examples
    --------
    >>> [(round(low, 4), round(high, 4)) for low, high in folding_parts(Knots(s=0.2, u=0.2))]
    [(0.6504, 0.9071)]
    >>> folding_parts(Knots(s=0.2))
    ()
    """
    from qovr_core.geometry.exact_roots import sign_changes
    from qovr_core.geometry.exact_speed import exact_speed

    # At both ends the speed is above 0, whatever the knots: between its changes of sign it is so by turns.
    turns = sign_changes(exact_speed(knots))
    return tuple(zip(turns[::2], turns[1::2], strict=True))


def forward_range(knots: Knots, name: str) -> tuple[float, float] | None:
    """Return between which values of one of its knots a curve does not fold, the others staying, in steps of 0.001.

    Of several ranges it is the one nearest to the knot; None where the curve folds whatever that knot is.
    """
    value, number = getattr(knots, name), KNOT_NAMES.index(name)
    others = tuple(each for each in KNOT_NAMES if each != name)
    ranges = _forward_ranges(tuple(getattr(knots, each) for each in others), number)
    return min(ranges, key=lambda ends: max(ends[0] - value, value - ends[1]), default=None)


@lru_cache(maxsize=_REMEMBERED)
def _forward_ranges(others: tuple[float, ...], number: int) -> list[tuple[float, float]]:
    values = np.arange(1, STEPS) / STEPS
    knots = np.insert(np.broadcast_to(others, (values.size, 3)), number, values, axis=1)
    is_forward = np.concatenate([[False], ~folds(knots), [False]])
    begins, ends = (np.flatnonzero(np.diff(is_forward.astype(int)) == turn) for turn in (1, -1))
    return [(float(values[begin]), float(values[end - 1])) for begin, end in zip(begins, ends, strict=True)]


def _speeds(knots: Array) -> tuple[Array, Array]:
    """Return the speeds of curves (k, 4) over the points 0, 1, .. 4 as (k, 1, 6), and their error (k, 1, 1).

    On points p, p + 1, p + 2 a parabola is p + 2x + c (x - x^2), c = (1 - 2k) / (k (1 - k)) for its knot k.
    """
    own = knots[:, KERNEL_KNOTS]
    c = ((1 - 2 * own) / (own * (1 - own)))[..., None]
    x = transformations(knots)
    x_4, first = x @ bernstein.elevation(2, 4).T, np.arange(3.0)[:, None]
    position = _blended(first + (2 + c) * x_4 - c * bernstein.product(x, x))
    added_up = _blended(first + (2 + np.abs(c)) * np.abs(x_4) + np.abs(c) * bernstein.product(np.abs(x), np.abs(x)))
    speeds = bernstein.derivative(position, axis=-1)
    return speeds[:, None], (_ROUNDING * added_up.max(axis=1))[:, None, None]


def _blended(parabolas: Array) -> Array:
    """Return sum_p w_p Q_p, (k, 7), of parabolas (k, 3, 5)."""
    return np.asarray(parabolas.reshape(len(parabolas), -1) @ _BLENDING)
