"""The curves of a window, the two ways in which they become one surface, and how both answer to one knot."""

from __future__ import annotations

import numpy as np

from qovr_core.arrays import Array
from qovr_core.geometry.knots import Direction, KnotPlace
from qovr_core.geometry.weights import weight_coefficients, weight_slopes, weight_summands

_UNSEEN = 1 / 32
"""What counts of summands that cancel before a curve's points enter, and of blends that are larger than 1: their
rounding stays below this part of them, and beside ordinary knots it does not show."""


def network_curves(
    net: Array, row_knots: Array, column_knots: Array, kernel_decimals: int | None = None
) -> tuple[Array, Array]:
    """Return the curves C_i(u) of (42) and K_j(v) of (43) of many nets at once, (..., k, 7, 3) and (..., l, 7, 3).

    Parameters
    ----------
    net : (..., k, l, 3) control points
    row_knots, column_knots : (..., k, 4) and (..., l, 4) knots r, s, u, t; the leading axes of both are the same, and
        broadcastable with those of ``net``
    kernel_decimals : to how many decimals the inverse kernels are cut; None keeps them exact
    """
    knots, points = _knots_and_points(net, row_knots, column_knots)
    curves, rows = weight_coefficients(knots, kernel_decimals=kernel_decimals) @ points, row_knots.shape[-2]
    return curves[..., :rows, :, :], curves[..., rows:, :, :]


def _knots_and_points(net: Array, row_knots: Array, column_knots: Array) -> tuple[Array, Array]:
    """Return the knots (..., k + l, 4) and the points (..., k + l, 5, 3) of all curves, rows before columns."""
    knots = np.concatenate([row_knots, column_knots], axis=-2)
    return knots, np.concatenate([net, net.swapaxes(-2, -3)], axis=-3)


def product_surface(along_u: Array, along_v: Array) -> Array:
    """Return the component-wise product of two curves (..., 7, 3) as patch coefficients (..., 7, 7, 3), (27)."""
    return along_u[..., :, None, :] * along_v[..., None, :, :]


def boolean_sum(net: Array, row_knots: Array, column_knots: Array) -> Array:
    r"""Return the Boolean-sum (Gordon) surface of the curve network, blended with the weights of the mean knots.

    $$S(u, v) = \sum_j w_j(u) K_j(v) + \sum_i w_i(v) C_i(u) - \sum_i \sum_j w_i(v) w_j(u) P_{i,j}$$

    Parameters are those of ``network_curves``; the result is (..., 7, 7, 3).
    """
    return boolean_sum_of(net, row_knots, column_knots, *network_curves(net, row_knots, column_knots))


def boolean_sum_of(net: Array, row_knots: Array, column_knots: Array, rows: Array, columns: Array) -> Array:
    """Return ``boolean_sum`` from curves that are known, (..., k, 7, 3) and (..., l, 7, 3)."""
    along_u, along_v = weight_coefficients(row_knots.mean(axis=-2)), _weights_across(column_knots.mean(axis=-2))
    # Rows and points are blended by the same weights along v, so their difference is blended once.
    beyond_the_net = rows - along_u[..., None, :, :] @ net
    return _blend(along_u, columns) + _blend(along_v, beyond_the_net).swapaxes(-2, -3)


def _weights_across(knots: Array) -> Array:
    """Return the weights for knots (..., 4) that windows beside one another along u, the second axis, may share."""
    if knots.ndim < 3:
        return weight_coefficients(knots)
    return weight_coefficients(knots.swapaxes(0, 1)).swapaxes(0, 1)


def _blend(weights: Array, curves: Array) -> Array:
    """Return sum_k weights[a, k] curves[k, b, :], (..., 7, 7, 3), of (..., 7, 5) and (..., 5, 7, 3)."""
    blended = weights @ curves.reshape(*curves.shape[:-2], -1)
    return blended.reshape(*blended.shape[:-1], *curves.shape[-2:])


def product_summands(
    net: Array,
    row_knots: Array,
    column_knots: Array,
    *,
    kernel_decimals: int | None = None,
    entering_rows: slice = slice(None),
) -> Array:
    r"""Return how large the summands of a product of sums of curves are together, by coordinate, (..., 3).

    With $A_i$ the largest $\sum_j |w_{aj}| |P_{i,j}|$ over the coefficients a of C_i, and $B_j$ likewise of K_j, it is
    $\sum_i A_i \sum_j B_j$; knots near 0 and 1, whose kernels cancel, make them larger. Parameters are those of
    ``network_curves``, and ``entering_rows`` that of ``product_slope``.
    """
    rows, columns = _curve_summands(net, row_knots, column_knots, kernel_decimals)
    product: Array = rows[..., entering_rows, :].sum(axis=-2) * columns.sum(axis=-2)
    return product


def boolean_sum_summands(net: Array, row_knots: Array, column_knots: Array) -> Array:
    r"""Return how large the summands of ``boolean_sum`` are together, by coordinate, (..., 3).

    It is $\sum_i A_i + \sum_j B_j + 25 \max |P|$, as in ``product_summands``; where the mean knots lie so near 0 or 1
    that the weights which blend are large, they count too. Parameters are those of ``network_curves``.
    """
    rows, columns = _curve_summands(net, row_knots, column_knots, None)
    means = np.stack([row_knots.mean(axis=-2), column_knots.mean(axis=-2)])
    along_u, along_v = _UNSEEN * weight_summands(means).max(axis=(-1, -2))[..., None]
    points = net.shape[-2] * net.shape[-3] * np.abs(net).max(axis=(-2, -3))
    of_curves = np.maximum(along_v, 1) * rows.sum(axis=-2) + np.maximum(along_u, 1) * columns.sum(axis=-2)
    summands: Array = of_curves + np.maximum(along_u * along_v / _UNSEEN, 1) * points
    return summands


def _curve_summands(
    net: Array, row_knots: Array, column_knots: Array, kernel_decimals: int | None
) -> tuple[Array, Array]:
    """Return the largest sum |w_aj| |P_ij| over the coefficients a of each curve, (..., k, 3) and (..., l, 3)."""
    knots, points = _knots_and_points(net, row_knots, column_knots)
    weights = np.abs(weight_coefficients(knots, kernel_decimals=kernel_decimals))
    unseen = _UNSEEN * weight_summands(knots, kernel_decimals=kernel_decimals)
    points = np.abs(points)
    sizes = np.maximum((weights @ points).max(axis=-2), (unseen @ points).max(axis=-2))
    rows = row_knots.shape[-2]
    return sizes[..., :rows, :], sizes[..., rows:, :]


def product_slope(
    net: Array,
    row_knots: Array,
    column_knots: Array,
    place: KnotPlace,
    *,
    entering_rows: slice = slice(None),
) -> Array:
    """Return the derivative of a product of sums of curves, kernels uncut, with respect to one knot, (7, 7, 3).

    Parameters
    ----------
    net, row_knots, column_knots : (k, l, 3), (k, 4) and (l, 4)
    place : which knot
    entering_rows : the row curves that enter the sum; of the column curves all do
    """
    net, own, other = _turned(net, row_knots, column_knots, place.direction)
    entering = slice(None) if place.direction is Direction.ROWS else entering_rows
    curve_slope = weight_slopes(own[place.curve])[place.number] @ net[place.curve]
    across = weight_coefficients(other) @ net.transpose(1, 0, 2)
    return _turned_back(curve_slope[:, None] * across[entering].sum(axis=0), place.direction)


def boolean_sum_slope(net: Array, row_knots: Array, column_knots: Array, place: KnotPlace) -> Array:
    """Return the derivative of ``boolean_sum`` with respect to one knot, (7, 7, 3): a curve and a blend change.

    Parameters are those of ``product_slope``.
    """
    net, own, other = _turned(net, row_knots, column_knots, place.direction)
    curve_slope = weight_slopes(own[place.curve])[place.number] @ net[place.curve]
    across = weight_coefficients(other) @ net.transpose(1, 0, 2)
    blend_slope = weight_slopes(own.mean(axis=0))[place.number] / len(own)
    blend_across = weight_coefficients(other.mean(axis=0))
    beyond_the_net = across - blend_across @ net.transpose(1, 0, 2)
    slope = np.tensordot(blend_slope, beyond_the_net, axes=1)
    slope += curve_slope[:, None] * blend_across[None, :, place.curve, None]
    return _turned_back(slope, place.direction)


def _turned(net: Array, row_knots: Array, column_knots: Array, direction: Direction) -> tuple[Array, Array, Array]:
    """Return the net with one family of curves along its rows, that family's knots, and the other's."""
    if direction is Direction.ROWS:
        return net, row_knots, column_knots
    return net.transpose(1, 0, 2), column_knots, row_knots


def _turned_back(slope: Array, direction: Direction) -> Array:
    return slope if direction is Direction.ROWS else slope.transpose(1, 0, 2)
