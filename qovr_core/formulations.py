"""The three surfaces that the paper's equations, data and claims describe, each as one exact patch."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from qovr_core.arrays import Array
from qovr_core.document import Document, Formulation
from qovr_core.errors import EvaluationError
from qovr_core.knots import Knots, knot_array
from qovr_core.patch import Patch
from qovr_core.weights import CURVE_DEGREE, weight_coefficients

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
    knots = knot_array(document.row_knots + document.column_knots)
    weights = weight_coefficients(knots, kernel_decimals=kernel_decimals(document.formulation))
    net = document.control_points
    polygons = np.concatenate([net, net.transpose(1, 0, 2)])
    curves = weights @ polygons
    return CurveNetwork(rows=curves[:5], columns=curves[5:])


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
        coefficients = _BUILDERS[document.formulation](document)
    if not np.isfinite(coefficients).all():
        raise EvaluationError(_overflow_text(document))
    return Patch(coefficients, patch_degree(document))


def patch_degree(document: Document) -> tuple[int, int]:
    """Return the degree of the surface in u and v: 4 where s_ip = u_ip on every curve that counts, else 6."""
    rows = [document.row_knots[i] for i in active_rows(document.formulation)]
    return _degree(rows), _degree(document.column_knots)


def _degree(curves: list[Knots] | tuple[Knots, ...]) -> int:
    return 4 if all(knots.is_quartic for knots in curves) else CURVE_DEGREE


def _product_surface(along_u: Array, along_v: Array) -> Array:
    """Return the component-wise product of two curves (7, 3) as patch coefficients (7, 7, 3)."""
    return along_u[:, None, :] * along_v[None, :, :]


def _published(document: Document) -> Array:
    """Only the last row curve enters: C_4(u) * sum_j K_j(v), as the published workbooks contain."""
    network = curve_network(document)
    return _product_surface(network.rows[_LAST_ROW], network.columns.sum(axis=0))


def _double_sum(document: Document) -> Array:
    """(sum_i C_i(u)) * (sum_j K_j(v)), eqs. (27), (44) and Algorithm 1 as printed."""
    network = curve_network(document)
    return _product_surface(network.rows.sum(axis=0), network.columns.sum(axis=0))


def _interpolating(document: Document) -> Array:
    """The Boolean-sum (Gordon) surface of the curve network, blended with the weights of the mean knots."""
    network = curve_network(document)
    means = [knot_array(knots).mean(axis=0) for knots in (document.row_knots, document.column_knots)]
    along_u, along_v = weight_coefficients(np.array(means))
    # Rows and points are blended by the same weights along v, so their difference is blended once.
    beyond_the_net = network.rows - along_u @ document.control_points
    patch: Array = np.tensordot(along_u, network.columns, axes=1)
    patch += np.tensordot(along_v, beyond_the_net, axes=1).transpose(1, 0, 2)
    return patch


_BUILDERS: dict[Formulation, Callable[[Document], Array]] = {
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
