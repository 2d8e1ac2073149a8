"""How the surface answers to one knot: the derivative dS/dknot, itself a patch."""

from __future__ import annotations

import numpy as np

from qovr_core.arrays import Array
from qovr_core.construction import window_arrays
from qovr_core.evaluation import Evaluation, parameters
from qovr_core.geometry.knots import KnotPlace
from qovr_core.geometry.patch import Patch
from qovr_core.layer import Layer

_ROWS_AT_A_TIME = 64
"""Rows of samples looked at together, so that a fine grid is never held as a whole."""


@np.errstate(all="ignore")  # what overflows has no colour
def knot_sensitivity(evaluation: Evaluation, place: KnotPlace, layer: Layer) -> Patch:
    """Return dS/dknot as a patch whose points are vectors, in the document's units per unit of the knot.

    The raw surface's is the formulation's own (``Formulation.knot_slope``): exact, but for a record that does not know
    its slope. For the transformed layer T follows: it depends on the samples at which the raw box is attained. Where
    several attain it together, its slope is one thing for a rising and another for a falling knot, and the mean of
    the two is taken. A knot without effect has the derivative zero.

    Parameters
    ----------
    evaluation : of the surface whose answer is asked for
    place : the knot
    layer : of which of its two surfaces
    """
    document = evaluation.document
    raw = Patch(document.formulation.knot_slope(*window_arrays(document), place))
    return raw if layer is Layer.RAW else _transformed_slope(evaluation, raw)


def _transformed_slope(evaluation: Evaluation, raw: Patch) -> Patch:
    """Return d(m S + n) = m dS + dm S + dn for the diagonal m and the shift n of (61)-(65)."""
    low, high = evaluation.raw_box.T
    slope_low, slope_high = _box_slopes(evaluation, raw)
    scale = evaluation.matrix.diagonal()[:3]
    is_flat = np.isin(list("xyz"), evaluation.flat_axes)
    scale_slope = np.where(is_flat, 0.0, -scale * (slope_high - slope_low) / np.where(is_flat, 1.0, high - low))
    shift_slope = -scale_slope * low - scale * slope_low
    return Patch(scale * raw.coefficients + scale_slope * evaluation.patch.coefficients + shift_slope)


def _box_slopes(evaluation: Evaluation, raw: Patch) -> tuple[Array, Array]:
    """Return the derivatives of the raw box's low and high sides, each (3,)."""
    u, v = (parameters(samples) for samples in evaluation.document.samples)
    low_side, high_side = evaluation.raw_box.T
    sides = (low_side + evaluation.rounding, high_side - evaluation.rounding)  # what is so near a side touches it
    least, most = np.full((2, 3), np.inf), np.full((2, 3), -np.inf)
    for start in range(0, len(u), _ROWS_AT_A_TIME):
        rows = u[start : start + _ROWS_AT_A_TIME]
        points, slopes = evaluation.patch.points(rows, v), raw.points(rows, v)
        for side, attained in enumerate((points <= sides[0], points >= sides[1])):
            least[side] = np.minimum(least[side], np.where(attained, slopes, np.inf).min(axis=(0, 1)))
            most[side] = np.maximum(most[side], np.where(attained, slopes, -np.inf).max(axis=(0, 1)))
    low, high = (least + most) / 2
    return low, high
