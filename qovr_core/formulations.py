"""The three surfaces that the paper's equations, data and claims describe, each as one exact patch."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from qovr_core.arrays import Array
from qovr_core.document import NET_SIZE, Document, Formulation
from qovr_core.errors import EvaluationError
from qovr_core.geometry.knots import Knots, knot_array
from qovr_core.geometry.patch import Patch
from qovr_core.geometry.weights import CURVE_DEGREE, weight_coefficients

PUBLISHED_KERNEL_DECIMALS = 4
"""The published workbooks were computed from inverse kernels cut to this many decimals."""

_LAST_ROW = 4


@dataclass(frozen=True)
class CurveNetwork:
    """The ten curves of a document as Bernstein coefficients.

    ``rows[i]`` is C_i(u) of (42) and ``columns[j]`` is K_j(v) of (43), each (7, 3).
    """

    rows: Array
    columns: Array


def kernel_decimals(formulation: Formulation) -> int | None:
    """Return the decimals to which a formulation cuts its inverse kernels; None where they are exact."""
    return PUBLISHED_KERNEL_DECIMALS if formulation is Formulation.PUBLISHED else None


def curve_network(document: Document) -> CurveNetwork:
    """Return the curves C_i(u) and K_j(v) of (42) and (43), as the formulation computes them."""
    rows, columns = _curves(*_arrays(document), document.formulation)
    return CurveNetwork(rows, columns)


def _arrays(document: Document) -> tuple[Array, Array, Array]:
    """Return the net, the row knots and the column knots of a document as arrays."""
    return document.control_points, knot_array(document.row_knots), knot_array(document.column_knots)


def _curves(net: Array, row_knots: Array, column_knots: Array, formulation: Formulation) -> tuple[Array, Array]:
    """Return the curves of many documents at once, rows and columns, each (..., 5, 7, 3)."""
    knots = np.concatenate([row_knots, column_knots], axis=-2)
    weights = weight_coefficients(knots, kernel_decimals=kernel_decimals(formulation))
    curves = weights @ np.concatenate([net, net.swapaxes(-2, -3)], axis=-3)
    return curves[..., :NET_SIZE, :, :], curves[..., NET_SIZE:, :, :]


def active_rows(formulation: Formulation) -> tuple[int, ...]:
    """Return the rows i whose knots have an effect on the surface; all five columns always have."""
    return (_LAST_ROW,) if formulation is Formulation.PUBLISHED else (0, 1, 2, 3, 4)


def build_patch(document: Document) -> Patch:
    """Return the raw surface of a document as one polynomial patch.

    Raises
    ------
    EvaluationError : a knot so close to 0 or 1, or points so large, that coordinates overflow
    """
    with np.errstate(all="ignore"):  # what overflows is refused just below, in words
        coefficients = patch_coefficients(*_arrays(document), document.formulation)
    if not np.isfinite(coefficients).all():
        raise EvaluationError(_overflow_text(document))
    return Patch(coefficients, patch_degree(document))


def patch_coefficients(net: Array, row_knots: Array, column_knots: Array, formulation: Formulation) -> Array:
    """Return the raw surfaces of many documents at once, as Bernstein coefficients.

    Parameters
    ----------
    net : (..., 5, 5, 3) control points
    row_knots, column_knots : (..., 5, 4) knots r, s, u, t of C_0..C_4 and of K_0..K_4; the leading axes of
        both are the same, and broadcastable with those of ``net``

    Returns
    -------
    (..., 7, 7, 3) float64, u along the first of them; not finite where coordinates overflow
    """
    return _BUILDERS[formulation](net, row_knots, column_knots)


def patch_degree(document: Document) -> tuple[int, int]:
    """Return the degree of the surface in u and v: 4 where s_ip = u_ip on every curve that counts, else 6."""
    rows = [document.row_knots[i] for i in active_rows(document.formulation)]
    return _degree(rows), _degree(document.column_knots)


def _degree(curves: list[Knots] | tuple[Knots, ...]) -> int:
    return 4 if all(knots.is_quartic for knots in curves) else CURVE_DEGREE


def _product_surface(along_u: Array, along_v: Array) -> Array:
    """Return the component-wise product of two curves (..., 7, 3) as patch coefficients (..., 7, 7, 3)."""
    return along_u[..., :, None, :] * along_v[..., None, :, :]


def _published(net: Array, row_knots: Array, column_knots: Array) -> Array:
    """Only the last row curve enters: C_4(u) * sum_j K_j(v), as the published workbooks contain."""
    rows, columns = _curves(net, row_knots, column_knots, Formulation.PUBLISHED)
    return _product_surface(rows[..., _LAST_ROW, :, :], columns.sum(axis=-3))


def _double_sum(net: Array, row_knots: Array, column_knots: Array) -> Array:
    """(sum_i C_i(u)) * (sum_j K_j(v)), eqs. (27), (44) and Algorithm 1 as printed."""
    rows, columns = _curves(net, row_knots, column_knots, Formulation.DOUBLE_SUM)
    return _product_surface(rows.sum(axis=-3), columns.sum(axis=-3))


def _interpolating(net: Array, row_knots: Array, column_knots: Array) -> Array:
    """The Boolean-sum (Gordon) surface of the curve network, blended with the weights of the mean knots."""
    rows, columns = _curves(net, row_knots, column_knots, Formulation.INTERPOLATING)
    means = np.stack([row_knots.mean(axis=-2), column_knots.mean(axis=-2)])
    along_u, along_v = weight_coefficients(means)
    # Rows and points are blended by the same weights along v, so their difference is blended once.
    beyond_the_net = rows - along_u[..., None, :, :] @ net
    return _blend(along_u, columns) + _blend(along_v, beyond_the_net).swapaxes(-2, -3)


def _blend(weights: Array, curves: Array) -> Array:
    """Return sum_k weights[a, k] curves[k, b, :], (..., 7, 7, 3), of (..., 7, 5) and (..., 5, 7, 3)."""
    blended = weights @ curves.reshape(*curves.shape[:-2], -1)
    return blended.reshape(*blended.shape[:-1], *curves.shape[-2:])


_BUILDERS: dict[Formulation, Callable[[Array, Array, Array], Array]] = {
    Formulation.PUBLISHED: _published,
    Formulation.DOUBLE_SUM: _double_sum,
    Formulation.INTERPOLATING: _interpolating,
}


def _overflow_text(document: Document) -> str:
    """Name the knot nearest to an end of (0, 1), which is what makes coordinates overflow."""
    curves = [("row_knots", i, k) for i, k in enumerate(document.row_knots)]
    curves += [("column_knots", j, k) for j, k in enumerate(document.column_knots)]
    margin, place = min(
        (min(value, 1 - value), f"{zone}[{index}].{name} = {value!r}")
        for zone, index, knots in curves
        for name, value in zip("rsvt" if zone == "column_knots" else "rsut", knots, strict=True)
    )
    return (
        f"the surface has no finite coordinates: {place} is only {margin:.3g} away from an end of (0, 1); "
        "expected knots, and coordinates, of ordinary size"
    )
