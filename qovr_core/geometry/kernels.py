"""Blending kernels of one parabola and their inverses, eqs. (14)-(17), (21), (22)."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from qovr_core.arrays import Array

_BELOW_A_DECIMAL = 1e-9
"""Keeps 2.5 computed as 2.4999999999999996 at 2.5 when it is truncated; far below a fourth decimal."""


def kernels(knots: npt.ArrayLike) -> Array:
    r"""Return the blending kernels M of (14): rows are [x^2 x 1] at x = 0, the knot and 1.

    $$M = \begin{bmatrix} 0 & 0 & 1 \\\\ k^2 & k & 1 \\\\ 1 & 1 & 1 \end{bmatrix}$$

    Parameters
    ----------
    knots : (...) internal knots, each in (0, 1)

    Returns
    -------
    (..., 3, 3) float64
    """
    k = np.asarray(knots, dtype=np.float64)
    kernel = np.zeros((*k.shape, 3, 3))
    kernel[..., 0, 2] = 1
    kernel[..., 1, 0] = k * k
    kernel[..., 1, 1] = k
    kernel[..., 1, 2] = 1
    kernel[..., 2, :] = 1
    return kernel


def inverse_kernels(knots: npt.ArrayLike, *, decimals: int | None = None) -> Array:
    r"""Return the inverse kernels M^-1 of (17), (21), (22) in the paper's closed form.

    $$M^{-1} = \begin{bmatrix} \frac{1}{k} & \frac{1}{k (k - 1)} & \frac{1}{1 - k}
    \\\\ -\frac{k + 1}{k} & \frac{1}{k (1 - k)} & \frac{k}{k - 1} \\\\ 1 & 0 & 0 \end{bmatrix}$$

    Parameters
    ----------
    knots : (...) internal knots, each in (0, 1)
    decimals : truncate every entry toward zero to this many decimals, as the published workbooks
        do with 4; None keeps them exact

    Returns
    -------
    (..., 3, 3) float64; rows belong to x^2, x, 1 and columns to the parabola's three points
    """
    k = np.asarray(knots, dtype=np.float64)
    inverse = np.zeros((*k.shape, 3, 3))
    inverse[..., 0, 0] = 1 / k
    inverse[..., 0, 1] = 1 / (k * (k - 1))
    inverse[..., 0, 2] = 1 / (1 - k)
    inverse[..., 1, 0] = -(k + 1) / k
    inverse[..., 1, 1] = 1 / (k * (1 - k))
    inverse[..., 1, 2] = k / (k - 1)
    inverse[..., 2, 0] = 1
    if decimals is None:
        return inverse
    scale = 10.0**decimals
    return np.trunc(scale * inverse + np.copysign(_BELOW_A_DECIMAL, inverse)) / scale


def inverse_kernel_slopes(knots: npt.ArrayLike) -> Array:
    """Return the derivatives of the exact inverse kernels of (17), (21), (22) with respect to their knots.

    Parameters
    ----------
    knots : (...) internal knots, each in (0, 1)

    Returns
    -------
    (..., 3, 3) float64, as ``inverse_kernels``
    """
    k = np.asarray(knots, dtype=np.float64)
    slope = np.zeros((*k.shape, 3, 3))
    slope[..., 0, 0] = slope[..., 1, 0] = -1 / k**2
    slope[..., 1, 0] *= -1
    slope[..., 0, 1] = (1 - 2 * k) / (k * (k - 1)) ** 2
    slope[..., 1, 1] = -slope[..., 0, 1]
    slope[..., 0, 2] = 1 / (1 - k) ** 2
    slope[..., 1, 2] = -slope[..., 0, 2]
    return slope
