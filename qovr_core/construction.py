"""From a document to what is exact about it: its ten curves, and its surface as one polynomial patch."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from qovr_core.arrays import Array, read_only
from qovr_core.document import Document
from qovr_core.edits import knots_of
from qovr_core.errors import EvaluationError
from qovr_core.geometry.knots import KNOT_NAMES, Direction, KnotPlace, knot_array
from qovr_core.geometry.network import network_curves
from qovr_core.geometry.patch import Patch


@dataclass(frozen=True)
class CurveNetwork:
    """The ten curves of a document as Bernstein coefficients.

    ``rows[i]`` is C_i(u) of (42) and ``columns[j]`` is K_j(v) of (43), each (7, 3).
    """

    rows: Array
    columns: Array


def document_arrays(document: Document) -> tuple[Array, Array, Array]:
    """Return the net (5, 5, 3), the row knots (5, 4) and the column knots (5, 4) of a document."""
    return document.control_points, knot_array(document.row_knots), knot_array(document.column_knots)


def curve_network(document: Document) -> CurveNetwork:
    """Return the curves C_i(u) and K_j(v) of (42) and (43), as the formulation computes them.

    Examples
    --------
    >>> net = [[[j, i, 0] for j in range(5)] for i in range(5)]
    >>> network = curve_network(Document(net))
    >>> network.rows[4][[0, -1]].tolist()  # C_4 begins at P_{4,1} and ends at P_{4,3}
    [[1.0, 4.0, 0.0], [3.0, 4.0, 0.0]]
    """
    rows, columns = network_curves(*document_arrays(document), document.formulation.kernel_decimals)
    return CurveNetwork(rows, columns)


def surface_rounding(document: Document) -> Array:
    """Return up to what size a coordinate of a document's raw surface is no more than rounding, (3,) for x, y and z.

    It is measured by what is added up, not by what comes out: of a net about the origin, sums cancel.

    Examples
    --------
    >>> net = [[[j - 2, i, 0] for j in range(5)] for i in range(5)]
    >>> surface_rounding(Document(net)) < 1e-12
    array([ True,  True,  True])
    """
    with np.errstate(all="ignore"):  # what overflows is all rounding, and what underflows has its least size
        return read_only(document.formulation.rounding(*document_arrays(document)))


def build_patch(document: Document) -> Patch:
    """Return the raw surface of a document as one polynomial patch.

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
    with np.errstate(all="ignore"):  # what overflows is refused just below, in words
        coefficients = document.formulation.build(*document_arrays(document))
    if not np.isfinite(coefficients).all():
        raise overflow_error(document)
    along_u, along_v = (_degree(document, direction) for direction in Direction)
    return Patch(coefficients, (along_u, along_v))


def _degree(document: Document, direction: Direction) -> int:
    """Return the degree along the curves of a direction: the largest of those that have an effect."""
    return max(
        knots.degree
        for curve, knots in enumerate(knots_of(document, direction))
        if document.formulation.is_active(direction, curve)
    )


def overflow_error(document: Document) -> EvaluationError:
    """Return an error that names the knot nearest to an end of (0, 1), which is what makes coordinates overflow."""
    margin, place, value = min(
        (min(value, 1 - value), str(KnotPlace(direction, curve, name)), value)
        for direction in Direction
        for curve, knots in enumerate(knots_of(document, direction))
        for name, value in zip(KNOT_NAMES, knots, strict=True)
        if document.formulation.is_active(direction, curve)
    )
    return EvaluationError(
        f"the surface has no finite coordinates: {place} = {value!r} is only {margin:.3g} away from an end of (0, 1); "
        "expected knots, and coordinates, of ordinary size"
    )
