"""The exact box of patches: branch and bound on Bernstein coefficients, whose hull contains the surface."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from qovr_core.arrays import Array
from qovr_core.geometry import bernstein

Owners = npt.NDArray[np.intp]

_TOLERANCE = 4 * np.finfo(np.float64).eps
"""A piece is settled when its bound exceeds an attained value by this part of its largest coefficient."""

_DEEPEST = 64
"""Halvings of a piece; 52 reach the resolution of double precision."""

_MOST_PIECES = 4096
"""Where the maximum is attained along a whole curve, only the most promising pieces are refined further."""


@np.errstate(under="ignore")  # what underflows is nothing
def bounding_box(coefficients: Array) -> Array:
    """Return the exact box of tensor-product Bernstein patches, each over [0, 1] x [0, 1], together.

    Parameters
    ----------
    coefficients : (..., a, b, d), finite

    Returns
    -------
    (d, 2) float64, columns min and max; every bound is attained by the surface to rounding
    """
    a, b, d = coefficients.shape[-3:]
    axes = np.moveaxis(coefficients.reshape(-1, a, b, d), -1, 0)
    highest = _maxima(np.concatenate([-axes, axes]))
    return np.stack([-highest[:d], highest[d:]], axis=1)


def _corners(pieces: Array) -> Array:
    """Return the four attained corner values of every piece, (k, 4)."""
    return pieces[:, [0, 0, -1, -1], [0, -1, 0, -1]]


def _maxima(functions: Array) -> Array:
    """Return the maximum of each function over all its pieces, given by their Bernstein coefficients (k, p, a, b)."""
    count, parts, a, b = functions.shape
    pieces, owner = functions.reshape(-1, a, b), np.repeat(np.arange(count, dtype=np.intp), parts)
    best: Array = _corners(pieces).reshape(count, -1).max(axis=1)
    slack = _TOLERANCE * np.abs(functions).max(axis=(1, 2, 3))
    for _ in range(_DEEPEST):
        bound = pieces.max(axis=(1, 2))
        open_pieces = np.flatnonzero(bound > (best + slack)[owner])
        if open_pieces.size == 0:
            break
        if open_pieces.size > _MOST_PIECES:
            promise = (bound - best[owner])[open_pieces]
            open_pieces = open_pieces[np.argsort(promise)[-_MOST_PIECES:]]
        pieces, owner = _halved(pieces[open_pieces], owner[open_pieces])
        np.maximum.at(best, owner, _corners(pieces).max(axis=1))
    return best


def _halved(pieces: Array, owner: Owners) -> tuple[Array, Owners]:
    """Cut every piece in two across the direction in which its coefficients vary more."""
    along_u = np.abs(np.diff(pieces, axis=1)).max(axis=(1, 2))
    along_v = np.abs(np.diff(pieces, axis=2)).max(axis=(1, 2))
    cut_u = along_u >= along_v
    in_u, in_v = pieces[cut_u], pieces[~cut_u]
    low_u, high_u = bernstein.halving(pieces.shape[1] - 1)
    low_v, high_v = bernstein.halving(pieces.shape[2] - 1)
    halves = np.concatenate([low_u @ in_u, high_u @ in_u, in_v @ low_v.T, in_v @ high_v.T])
    owner_u, owner_v = owner[cut_u], owner[~cut_u]
    return halves, np.concatenate([owner_u, owner_u, owner_v, owner_v])
