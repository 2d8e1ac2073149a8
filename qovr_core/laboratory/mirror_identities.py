"""What 0.5 knots make of symmetric nets, proved in exact rational arithmetic as ``identities`` are.

A net over a rectangle has the x of its columns and the y of its rows, each with its middle, and heights that are alike
under a symmetry. All sums of curves are linear in these numbers, so unit nets stand for all.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from functools import cache

import numpy as np

from qovr_core.geometry.weights import CURVE_DEGREE
from qovr_core.geometry.windows import NET_SIZE
from qovr_core.laboratory import exact
from qovr_core.laboratory.exact import Exact
from qovr_core.laboratory.identities import vanishes

_FLIPS = ((False, True), (True, False), (True, True))
"""Mirror in u, mirror in v, half a turn: whether a symmetry reverses the rows (v), and the columns (u)."""


@cache
def half_weights_mirror() -> bool:
    """With 0.5 knots b_j(1 - u) = b_{4-j}(u)."""
    return vanishes(lambda u: _half_weights(1 - u) - _half_weights(u)[::-1], CURVE_DEGREE)


@cache
def sums_mirror() -> bool:
    """With 0.5 knots (sum_i C_i) (sum_j K_j) of a symmetric net over a rectangle is symmetric."""
    return all(_product_mirrors(range(NET_SIZE), rows, columns) for rows, columns in _FLIPS)


@cache
def last_row_mirrors() -> bool:
    """With 0.5 knots C_4 sum_j K_j of a symmetric net whose last row is symmetric is symmetric."""
    return all(_product_mirrors((NET_SIZE - 1,), rows, columns) for rows, columns in _FLIPS)


def _product_mirrors(entering: Sequence[int], rows: bool, columns: bool) -> bool:
    """Return whether the product of the entering rows' sum and the columns' sum has a symmetry.

    A height keeps: both factors do. x and y turn about their middle where they are reversed: one factor does, and the
    other is constant.
    """
    x = _spread()
    y, z = x.swapaxes(1, 2), _heights(rows, columns, is_last_mirrored=len(entering) == 1)
    kept = np.concatenate([z, *([] if columns else [x]), *([] if rows else [y])])
    return (
        (not columns or _keeps(_along_u(kept, entering)))
        and (not rows or _keeps(_along_v(kept)))
        and (not columns or (_turns(_along_u(x, entering)) and _is_constant(_along_v(x))))
        and (not rows or (_turns(_along_v(y)) and _is_constant(_along_u(y, entering))))
    )


def _heights(rows: bool, columns: bool, *, is_last_mirrored: bool) -> Exact:
    """Return unit nets (25, 5, 5) for the heights under a symmetry, if asked with symmetric outer rows."""
    nets: Exact = np.eye(NET_SIZE**2, dtype=int).astype(object).reshape(-1, NET_SIZE, NET_SIZE)
    nets = nets + nets[:, :: -1 if rows else 1, :: -1 if columns else 1]
    if is_last_mirrored and columns:
        outer = [0, NET_SIZE - 1]
        nets[:, outer] = nets[:, outer] + nets[:, outer, ::-1]
    return nets


def _spread() -> Exact:
    """Return unit nets (3, 5, 5) of a coordinate that is one number a column, evenly about a middle."""
    lines = [[1, 1, 1, 1, 1], [-1, 0, 0, 0, 1], [0, -1, 0, 1, 0]]
    return np.repeat(np.array(lines, dtype=object)[:, None], NET_SIZE, axis=1)


@cache
def _half_weights(u: Fraction) -> Exact:
    return exact.values(exact.weights(*[Fraction(1, 2)] * 4), u)


Sums = Callable[[Fraction], Exact]
"""The factors of many nets, (k,), at a parameter."""


def _along_u(nets: Exact, entering: Sequence[int]) -> Sums:
    summed = nets[:, list(entering)].sum(axis=1)
    return lambda u: summed @ _half_weights(u)


def _along_v(nets: Exact) -> Sums:
    summed = nets.sum(axis=2)
    return lambda v: summed @ _half_weights(v)


def _keeps(sums: Sums) -> bool:
    """Return whether polynomials of degree 6 are the same from the other end."""
    return vanishes(lambda u: sums(1 - u) - sums(u), CURVE_DEGREE)


def _turns(sums: Sums) -> bool:
    middle = sums(Fraction(0)) + sums(Fraction(1))
    return vanishes(lambda u: sums(1 - u) + sums(u) - middle, CURVE_DEGREE)


def _is_constant(sums: Sums) -> bool:
    return vanishes(lambda u: sums(u) - sums(Fraction(0)), CURVE_DEGREE)
