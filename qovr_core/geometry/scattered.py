"""Evaluation of a tensor-product polynomial at scattered places, in blocks as ``grid`` does it on a grid."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from qovr_core.arrays import Array, Indices, checked_out
from qovr_core.geometry.grid import BLOCK_BYTES


@np.errstate(under="ignore")  # what underflows is nothing
def evaluate(
    coefficients: Array, basis_u: Array, basis_v: Array, out: npt.NDArray[Any] | None = None
) -> npt.NDArray[Any]:
    """Return the values of a tensor-product polynomial at k places.

    Parameters
    ----------
    coefficients : (a, b, d)
    basis_u, basis_v : (k, a) and (k, b), one row a place
    out : (k, d) to write to; see ``arrays.checked_out``

    Returns
    -------
    (k, d) float64; or ``out``
    """
    a, b, d = coefficients.shape
    table = coefficients.reshape(a, b * d)
    values = checked_out(out, (len(basis_u), d))
    step = max(1, BLOCK_BYTES // (table.itemsize * b * d))
    for k in range(0, len(values), step):
        places = slice(k, k + step)
        along_v = (basis_u[places] @ table).reshape(-1, b, d)
        values[places] = np.einsum("kb,kbd->kd", basis_v[places], along_v)
    return values


def asked_pieces(coefficients: Array, pieces: tuple[Indices, Indices]) -> tuple[Array, tuple[Indices, Indices]]:
    """Return of a piecewise polynomial (m, n, ...) only the pieces that are asked, and which of them each place asks.

    Parameters
    ----------
    pieces : for every place the piece's number along v and along u, (k,) each
    """
    if coefficients.shape[:2] == (1, 1):
        return coefficients, pieces
    (a, b), number = np.unique(pieces, axis=1, return_inverse=True)
    return coefficients[None, a, b], (np.zeros_like(number), number)


@np.errstate(under="ignore")  # what underflows is nothing
def evaluate_pieces(
    coefficients: Array,
    pieces: tuple[Indices, Indices],
    basis_u: Array,
    basis_v: Array,
    out: npt.NDArray[Any] | None = None,
) -> npt.NDArray[Any]:
    """Return the values of a piecewise tensor-product polynomial at k places, (k, d).

    Parameters
    ----------
    coefficients : (m, n, a, b, d)
    pieces : for every place the piece's number along v and along u, (k,) each
    basis_u, basis_v : (k, a) and (k, b), one row a place
    out : as for ``evaluate``
    """
    m, n, a, b, d = coefficients.shape
    if m * n == 1:
        return evaluate(coefficients[0, 0], basis_u, basis_v, out)
    values = checked_out(out, (len(basis_u), d))
    step = max(1, BLOCK_BYTES // (coefficients.itemsize * a * b * d))
    for k in range(0, len(values), step):
        places = slice(k, k + step)
        own = coefficients[pieces[0][places], pieces[1][places]].reshape(-1, a, b * d)
        along_v = (basis_u[places, None] @ own).reshape(-1, b, d)
        values[places] = np.einsum("kb,kbd->kd", basis_v[places], along_v)
    return values
