"""From a document to what is exact about it: its curves, and its surface as one polynomial a window."""

from __future__ import annotations

import functools
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from qovr_core.arrays import Array, Flags, Indices, read_only
from qovr_core.document import Document
from qovr_core.edits import knots_of
from qovr_core.errors import EvaluationError
from qovr_core.geometry.knots import KNOT_NAMES, Direction, KnotPlace
from qovr_core.geometry.patch import Patch
from qovr_core.geometry.weights import weight_coefficients
from qovr_core.geometry.window_bounds import window_bounds
from qovr_core.geometry.windows import (
    NET_SIZE,
    STEP,
    column_windows,
    curve_points,
    curve_windows,
    net_windows,
    row_windows,
)
from qovr_core.joints import window_lengths

_TOGETHER = 256
"""Windows that are computed together: what they are made of takes far more room than what comes out."""


@dataclass(frozen=True)
class CurveNetwork:
    """The curves of a document as Bernstein coefficients, one polynomial a window.

    ``rows[i, b]`` is C_i(u) of (42) in window b along u, (2m+3, n, 7, 3), and ``columns[j, a]`` is K_j(v) of (43) in
    window a along v, (2n+3, m, 7, 3).
    """

    rows: Array
    columns: Array


def document_arrays(document: Document) -> tuple[Array, Array, Array]:
    """Return nets (m, n, 5, 5, 3), row knots and column knots (m, n, 5, 4) of all windows of a document."""
    return net_windows(document.control_points), row_windows(document.row_knots), column_windows(document.column_knots)


def window_arrays(document: Document) -> tuple[Array, Array, Array]:
    """Return net (5, 5, 3), row knots and column knots (5, 4) of a document of one window."""
    net, row_knots, column_knots = document_arrays(document)
    return net[0, 0], row_knots[0, 0], column_knots[0, 0]


def curve_network(document: Document) -> CurveNetwork:
    """Return the curves C_i(u) and K_j(v) of (42) and (43), as the formulation computes them.

    Examples
    --------
    >>> net = [[[j, i, 0] for j in range(5)] for i in range(5)]
    >>> network = curve_network(Document(net))
    >>> network.rows[4, 0][[0, -1]].tolist()  # C_4 begins at P_{4,1} and ends at P_{4,3}
    [[1.0, 4.0, 0.0], [3.0, 4.0, 0.0]]
    """
    net, decimals = document.control_points, document.formulation.kernel_decimals
    rows, columns = (
        weight_coefficients(knots.array, kernel_decimals=decimals) @ curve_points(points)
        for knots, points in ((document.row_knots, net), (document.column_knots, net.swapaxes(0, 1)))
    )
    return CurveNetwork(read_only(rows), read_only(columns))


def window_rounding(document: Document, base: tuple[Document, Array] | None = None) -> Array:
    """Return what ``surface_rounding`` is of each window, (m, n, 3).

    Parameters
    ----------
    base : another document and its windows' rounding; only windows that differ from it are computed
    """
    arrays = document_arrays(document)
    with np.errstate(all="ignore"):  # what overflows is all rounding, and what underflows has its least size
        if base is None or not _is_alike(document, base[0]):
            return read_only(_by_rows(document.formulation.rounding, arrays))
        touched, rounding = np.nonzero(_touched(document, base[0])), base[1].copy()
        rounding[touched] = document.formulation.rounding(*(array[touched] for array in arrays))
        return read_only(rounding)


def bounds_of_windows(document: Document, patch: Patch, base: tuple[Document, Array] | None = None) -> Array:
    """Return ``window_bounds`` of a document's patch, (2, 6, m, n).

    Parameters
    ----------
    base : another document and its windows' bounds; only windows that differ from it are computed
    """
    m, n = document.windows
    if base is None or not _is_alike(document, base[0]):
        return window_bounds(patch.coefficients.reshape(-1, *patch.coefficients.shape[2:])).reshape(2, -1, m, n)
    touched, bounds = np.nonzero(_touched(document, base[0])), base[1].copy()
    if len(touched[0]):
        bounds[:, :, touched[0], touched[1]] = window_bounds(patch.coefficients[touched])
    return read_only(bounds)


def surface_rounding(document: Document) -> Array:
    """Return up to what size a coordinate of a document's raw surface is no more than rounding, (3,) for x, y and z.

    It is measured by what is added up, not by what comes out: of a net about the origin, sums cancel.

    Examples
    --------
    >>> net = [[[j - 2, i, 0] for j in range(5)] for i in range(5)]
    >>> surface_rounding(Document(net)) < 1e-12
    array([ True,  True,  True])
    """
    return read_only(window_rounding(document).max(axis=(0, 1)))


def build_patch(document: Document, base: tuple[Document, Patch] | None = None) -> Patch:
    """Return the raw surface of a document as one polynomial a window.

    Parameters
    ----------
    base : another document and its patch; only windows that differ from it are computed, bit for bit the same

    Raises
    ------
    EvaluationError : a knot so close to 0 or 1, or points so large, that coordinates overflow

    Examples
    --------
    >>> net = [[[j, i, 0] for j in range(5)] for i in range(5)]
    >>> patch = build_patch(Document(net, formulation="interpolating"))
    >>> patch.degree, patch.points([0, 1], [0]).tolist()
    ((4, 4), [[[1.0, 1.0, 0.0]], [[3.0, 1.0, 0.0]]])
    """
    if base is not None and _is_alike(document, base[0]):
        coefficients = _some_windows(document, base)
    else:
        coefficients = _all_windows(document)
    if not np.isfinite(coefficients).all():
        raise overflow_error(document)
    along_u, along_v = window_degrees(document).max(axis=(0, 1)).tolist()
    lengths_u, lengths_v = (
        window_lengths(knots_of(document, direction), document.joints.along(direction)) for direction in Direction
    )
    return Patch(read_only(coefficients), (along_u, along_v), (lengths_u, lengths_v))


@np.errstate(all="ignore")  # what overflows is refused in words
def _all_windows(document: Document) -> Array:
    """Return the coefficients of all windows, (m, n, 7, 7, 3); curves that windows share are computed once."""
    arrays, join = document_arrays(document), document.formulation.join
    if join is None or document.is_one_window:
        return _by_rows(document.formulation.build, arrays)
    network = curve_network(document)
    return _by_rows(join, (*arrays, curve_windows(network.rows), curve_windows(network.columns).swapaxes(0, 1)))


def _by_rows(compute: Callable[..., Array], arrays: tuple[Array, ...]) -> Array:
    """Return what a function makes of the arrays of windows, (m, n, ...) each, a few rows of windows at a time."""
    m, n = arrays[0].shape[:2]
    together = max(1, _TOGETHER // n)
    first = compute(*(array[:together] for array in arrays))
    if together >= m:
        return first
    result = np.empty((m, *first.shape[1:]))
    result[:together] = first
    for start in range(together, m, together):
        rows = slice(start, start + together)
        result[rows] = compute(*(array[rows] for array in arrays))
    return result


@np.errstate(all="ignore")
def _some_windows(document: Document, base: tuple[Document, Patch]) -> Array:
    """Return the same, computed only where the document differs from another."""
    touched = np.nonzero(_touched(document, base[0]))
    coefficients = base[1].coefficients.copy()
    if len(touched[0]):
        coefficients[touched] = document.formulation.build(*(array[touched] for array in document_arrays(document)))
    return coefficients


def _is_alike(document: Document, other: Document) -> bool:
    """Return whether windows of two documents can be compared one by one."""
    return document.formulation is other.formulation and document.windows == other.windows


def _touched(document: Document, other: Document) -> Flags:
    """Return in which windows two documents differ, (m, n)."""
    x, y, z = (document.control_points != other.control_points).transpose(2, 0, 1)
    touched = _any_in_windows(_any_in_windows(x | y | z).T).T
    for direction, windows_of in ((Direction.ROWS, row_windows), (Direction.COLUMNS, column_windows)):
        knots, others = knots_of(document, direction), knots_of(other, direction)
        if knots is not others:
            touched |= (windows_of(knots) != windows_of(others)).any(axis=(2, 3))
    return touched


def _any_in_windows(flags: Flags) -> Flags:
    """Return (m, ...) in which windows along the first axis (2 m + 3, ...) any flag is set: some views, and no copy."""
    last = len(flags) - NET_SIZE
    return functools.reduce(np.logical_or, (flags[k : k + last + 1 : STEP] for k in range(NET_SIZE)))


def active_curves(document: Document, direction: Direction) -> list[int]:
    """Return the curves of a direction whose knots have an effect on the surface."""
    curves = len(knots_of(document, direction))
    active = document.formulation.active_curves(direction)
    if active is None:
        return list(range(curves))
    return sorted({first + each for first in range(0, curves - NET_SIZE + 1, STEP) for each in active})


def window_degrees(document: Document) -> Indices:
    """Return the degree of the surface in u and in v in every window, (m, n, 2).

    It is 4 where s_ip = u_ip (v_ip) on all curves that have an effect, else 6.
    """
    degrees = []
    for direction, windows_of in ((Direction.ROWS, row_windows), (Direction.COLUMNS, column_windows)):
        knots, active = windows_of(knots_of(document, direction)), document.formulation.active_curves(direction)
        s, u = (knots[..., slice(None) if active is None else list(active), KNOT_NAMES.index(name)] for name in "su")
        degrees.append(np.where((s == u).all(axis=-1), 4, 6))
    return read_only(np.stack(degrees, axis=-1))


def overflow_error(document: Document) -> EvaluationError:
    """Return an error that names the knot nearest to an end of (0, 1), which is what makes coordinates overflow."""
    margin, place, value = min(_nearest_to_an_end(document, direction) for direction in Direction)
    return EvaluationError(
        f"the surface has no finite coordinates: {place} = {value!r} is only {margin:.3g} away from an end of (0, 1); "
        "expected knots, and coordinates, of ordinary size"
    )


def _nearest_to_an_end(document: Document, direction: Direction) -> tuple[float, str, float]:
    """Return how near the active knot nearest to 0 or 1 is to it, its place and its value."""
    knots, active = knots_of(document, direction), active_curves(document, direction)
    values = knots.array[active]
    margins = np.minimum(values, 1 - values)
    row, window, number = (int(k) for k in np.unravel_index(margins.argmin(), margins.shape))
    place = KnotPlace(direction, active[row], KNOT_NAMES[number], window)
    return float(margins[row, window, number]), place.text(knots.windows), float(values[row, window, number])
