"""How the surface answers to one knot: the derivative dS/dknot, itself a patch."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from qovr_core.arrays import Array
from qovr_core.construction import document_arrays
from qovr_core.document import Document
from qovr_core.evaluation import Evaluation
from qovr_core.geometry.knots import Direction, KnotPlace
from qovr_core.geometry.locate import even
from qovr_core.geometry.patch import PATCH_DEGREE, Patch
from qovr_core.geometry.windows import NET_SIZE, STEP
from qovr_core.layer import Layer

_ROWS_AT_A_TIME = 64
"""Rows of samples looked at together, so that a fine grid is never held as a whole."""


@np.errstate(all="ignore")  # what overflows has no colour
def knot_sensitivity(evaluation: Evaluation, place: KnotPlace, layer: Layer) -> Patch:
    """Return dS/dknot as a patch whose points are vectors, in the document's units per unit of the knot.

    The raw surface's is the formulation's own (``Formulation.knot_slope``): exact, but for a record that does not know
    its slope. For the transformed layer T follows: it depends on the samples at which the raw box is attained. Where
    several attain it together, its slope is one thing for a rising and another for a falling knot, and the mean of
    the two is taken. A knot without effect has the derivative zero, and so has a raw surface in all windows but
    those at the knot's window along its curve that hold the curve.

    Parameters
    ----------
    evaluation : of the surface whose answer is asked for
    place : the knot
    layer : of which of its two surfaces
    """
    raw = Patch(_raw_slope(evaluation.document, place), lengths=evaluation.patch.lengths)
    return raw if layer is Layer.RAW else _transformed_slope(evaluation, raw)


def _raw_slope(document: Document, place: KnotPlace) -> Array:
    """Return the derivative of the raw surface's coefficients, (m, n, 7, 7, 3)."""
    arrays, (m, n) = document_arrays(document), document.windows
    slope = np.zeros((m, n, PATCH_DEGREE + 1, PATCH_DEGREE + 1, 3))
    is_row = place.direction is Direction.ROWS
    for across in range(m if is_row else n):
        number = place.curve - STEP * across
        if 0 <= number < NET_SIZE:
            window = (across, place.window) if is_row else (place.window, across)
            own = replace(place, curve=number, window=0)
            net, rows, columns = (array[window] for array in arrays)
            slope[window] = document.formulation.knot_slope(net, rows, columns, own)
    return slope


def _transformed_slope(evaluation: Evaluation, raw: Patch) -> Patch:
    """Return d(m S + n) = m dS + dm S + dn for the diagonal m and the shift n of (61)-(65)."""
    low, high = evaluation.raw_box.T
    slope_low, slope_high = _box_slopes(evaluation, raw)
    scale = evaluation.matrix.diagonal()[:3]
    is_flat = np.isin(list("xyz"), evaluation.flat_axes)
    scale_slope = np.where(is_flat, 0.0, -scale * (slope_high - slope_low) / np.where(is_flat, 1.0, high - low))
    shift_slope = -scale_slope * low - scale * slope_low
    slope = scale * raw.coefficients + scale_slope * evaluation.patch.coefficients + shift_slope
    return Patch(slope, lengths=raw.lengths)


def _box_slopes(evaluation: Evaluation, raw: Patch) -> tuple[Array, Array]:
    """Return the derivatives of the raw box's low and high sides, each (3,)."""
    u, v = (
        breakpoints[at.window] + at.local * np.diff(breakpoints)[at.window]
        for at, breakpoints in zip(map(even, evaluation.document.intervals), evaluation.patch.breakpoints, strict=True)
    )
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
