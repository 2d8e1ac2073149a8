"""The five blending weights of a QOVR curve, eqs. (5)-(7), (23)-(26)."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from qovr_core.arrays import Array
from qovr_core.geometry import bernstein
from qovr_core.geometry.kernels import inverse_kernel_slopes, inverse_kernels

CURVE_DEGREE = 6
"""Degree in which every weight is held; the true degree is 4 where s_ip = u_ip."""

_PARABOLAS = 3
KERNEL_KNOTS = [0, 1, 3]
"""Of r, s, u, t those that stand in the kernels of Q_0, Q_1, Q_2."""

_BLEND = (
    bernstein.binomials(2)[:, None]
    * bernstein.binomials(4)
    / np.array([bernstein.binomials(6)[p : p + 5] for p in range(_PARABOLAS)])
)
"""w_p is B_{p,2}: times coefficient k of degree 4, scaled by this, it is coefficient p + k of degree 6."""


def transformations(knots: npt.ArrayLike) -> Array:
    r"""Return the parameter transformations r(u), s(u), t(u) of (24)-(26) as Bernstein coefficients.

    $$r(u) = r + (1 - r) \frac{u}{u_{ip}}, \quad s(u) = u + \frac{s - u_{ip}}{u_{ip}^2 - u_{ip}} (u^2 - u), \quad
    t(u) = t \frac{u - u_{ip}}{1 - u_{ip}}$$

    Parameters
    ----------
    knots : (..., 4) internal knots r, s, u, t, each in (0, 1)

    Returns
    -------
    (..., 3, 3) float64; the second axis from the end is r, s, t, the last the coefficients of degree 2
    """
    r, s, u, t = np.moveaxis(np.asarray(knots, dtype=np.float64), -1, 0)
    a = (s - u) / (u * (u - 1))  # u * u - u would lose the digits of a u near 1
    result = np.zeros((*np.shape(r), _PARABOLAS, 3))
    result[..., 0, 0] = r
    result[..., 0, 2] = r + (1 - r) / u
    result[..., 1, 1] = (1 - a) / 2
    result[..., 1, 2] = 1
    result[..., 2, 0] = -t * u / (1 - u)
    result[..., 2, 2] = t
    result[..., ::2, 1] = (result[..., ::2, 0] + result[..., ::2, 2]) / 2
    return result


def weight_coefficients(knots: npt.ArrayLike, *, kernel_decimals: int | None = None) -> Array:
    r"""Return the five blending weights of QOVR curves as Bernstein coefficients, eq. (23).

    With x_0, x_1, x_2 = r(u), s(u), t(u) and the parabolas' kernels M_p of the knots r, s, t:

    $$C(u) = \sum_{p=0}^{2} \binom{2}{p} u^p (1 - u)^{2 - p} \,
    [x_p^2 \; x_p \; 1] \, M_p^{-1} \, [P_p \; P_{p+1} \; P_{p+2}]^T$$

    Parameters
    ----------
    knots : (..., 4) internal knots r, s, u, t of each curve, each in (0, 1)
    kernel_decimals : truncate the inverse kernels (17), (21), (22) toward zero to this many
        decimals, as the published workbooks do; None keeps them exact

    Returns
    -------
    (..., 7, 5) float64; column j belongs to P_j. Rows of a degree-4 curve are its degree elevation to 6. Where all
    entries of the first axis are alike, as curves that share their knots are, they are one.
    """
    k = np.asarray(knots, dtype=np.float64)
    if k.ndim > 1 and len(k) > 1 and (k == k[:1]).all():
        once = weight_coefficients(k[:1], kernel_decimals=kernel_decimals)
        return np.broadcast_to(once, (len(k), *once.shape[1:]))
    kernels = inverse_kernels(k[..., KERNEL_KNOTS], decimals=kernel_decimals)
    return _blended(_monomials(transformations(k)) @ kernels)


def weight_summands(knots: npt.ArrayLike, *, kernel_decimals: int | None = None) -> Array:
    """Return how large all that is added up to each weight of ``weight_coefficients`` is together, (..., 7, 5).

    It is far more than the weight itself where kernels of knots near 0 and 1 cancel.
    """
    k = np.asarray(knots, dtype=np.float64)
    kernels = inverse_kernels(k[..., KERNEL_KNOTS], decimals=kernel_decimals)
    return _blended(_monomials(np.abs(transformations(k))) @ np.abs(kernels))


def transformation_slopes(knots: npt.ArrayLike) -> Array:
    """Return the derivatives of ``transformations`` with respect to the knots.

    Parameters
    ----------
    knots : (..., 4) internal knots r, s, u, t, each in (0, 1)

    Returns
    -------
    (..., 4, 3, 3) float64; the third axis from the end is the knot r, s, u, t
    """
    r, s, u, t = np.moveaxis(np.asarray(knots, dtype=np.float64), -1, 0)
    width = u * (u - 1)
    result = np.zeros((*np.shape(r), 4, _PARABOLAS, 3))
    result[..., 0, 0, 0] = 1
    result[..., 0, 0, 2] = 1 - 1 / u
    result[..., 2, 0, 2] = (r - 1) / u**2
    result[..., 1, 1, 1] = -1 / (2 * width)
    result[..., 2, 1, 1] = (width + (s - u) * (2 * u - 1)) / (2 * width**2)
    result[..., 2, 2, 0] = -t / (1 - u) ** 2
    result[..., 3, 2, 0] = -u / (1 - u)
    result[..., 3, 2, 2] = 1
    result[..., ::2, 1] = (result[..., ::2, 0] + result[..., ::2, 2]) / 2
    return result


def weight_slopes(knots: npt.ArrayLike) -> Array:
    """Return the derivatives of the five blending weights (23), with exact kernels, with respect to the knots.

    Parameters
    ----------
    knots : (..., 4) internal knots r, s, u, t of each curve, each in (0, 1)

    Returns
    -------
    (..., 4, 7, 5) float64; the third axis from the end is the knot r, s, u, t, the others are as in
    ``weight_coefficients``
    """
    k = np.asarray(knots, dtype=np.float64)
    x, dx = transformations(k)[..., None, :, :], transformation_slopes(k)
    monomial_slopes = _monomials(dx)
    monomial_slopes[..., 0] = 2 * bernstein.product(x, dx)
    monomial_slopes[..., 2] = 0
    own = k[..., KERNEL_KNOTS]
    slopes = monomial_slopes @ inverse_kernels(own)[..., None, :, :, :]
    through_kernels = _monomials(transformations(k)) @ inverse_kernel_slopes(own)
    for parabola, knot in enumerate(KERNEL_KNOTS):
        slopes[..., knot, parabola, :, :] += through_kernels[..., parabola, :, :]
    return _blended(slopes)


def _monomials(x: Array) -> Array:
    """Return x^2, x, 1 as Bernstein coefficients of degree 4, (..., 3, 5, 3), for x (..., 3, 3) of degree 2."""
    monomials = np.empty((*x.shape[:-1], 5, 3))
    monomials[..., 0] = bernstein.product(x, x)
    monomials[..., 1] = x @ bernstein.elevation(2, 4).T
    monomials[..., 2] = 1
    return monomials


def _blended(parabolas: Array) -> Array:
    """Return sum_p w_p Q_p as weights (..., 7, 5) from the parabolas' weights (..., 3, 5, 3)."""
    weights = np.zeros((*parabolas.shape[:-3], CURVE_DEGREE + 1, 5))
    for p in range(_PARABOLAS):
        weights[..., p : p + 5, p : p + 3] += _BLEND[p][:, None] * parabolas[..., p, :, :]
    return weights
