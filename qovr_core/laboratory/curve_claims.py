"""The paper's claims about one curve: its kernels, weights, degree and ends."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from qovr_core.arrays import Array
from qovr_core.construction import build_patch, surface_rounding, window_arrays
from qovr_core.document import Document
from qovr_core.edits import knots_of, set_all_knots
from qovr_core.geometry import bernstein
from qovr_core.geometry.kernels import inverse_kernels, kernels
from qovr_core.geometry.knots import KNOT_NAMES, Direction, Knots, KnotTable
from qovr_core.geometry.rounding import NOISE, ROUNDING, largest
from qovr_core.geometry.weights import CURVE_DEGREE, KERNEL_KNOTS, weight_coefficients, weight_summands
from qovr_core.laboratory.measurement import Condition, Measurement

_S, _U = (KNOT_NAMES.index(name) for name in "su")

_QUARTIC = 4
_HALVES = Knots()
_THIRDS = Knots(r=0.3, s=0.5, u=0.5, t=0.7)
"""The paper's Figure 6b: 1/0.3 and 1/0.7 have endless decimals."""
_LIFTED = Knots(s=0.6)


def curve_names(document: Document) -> tuple[str, ...]:
    """Return the names of the curves of a document, rows before columns."""
    return tuple(
        direction.curve_name(number) for direction in Direction for number in range(len(knots_of(document, direction)))
    )


def inverse(document: Document) -> Measurement:
    """M M^-1 = I for every kernel of the document, (14)-(17), (21), (22)."""
    knots = _knots(document)[:, KERNEL_KNOTS]
    kernel = kernels(knots)
    inverted = inverse_kernels(knots, decimals=document.formulation.kernel_decimals)
    deviation = np.abs(kernel @ inverted - np.eye(3))
    norms = (np.linalg.norm(matrices, 2, axis=(1, 2)) for matrices in (kernel, inverse_kernels(knots)))
    condition = largest(np.prod(list(norms), axis=0))
    return Measurement(
        value=largest(deviation),
        what="largest entry of M M^-1 - I",
        holds=bool((deviation <= NOISE * (np.abs(kernel) @ np.abs(inverted))).all()),
        note=f"the largest condition number of a kernel is {condition:.4g}",
    )


def unity(document: Document) -> Measurement:
    """The five weights of every curve sum to 1, (4)."""
    weights = _weights(document)
    along = bernstein.basis(CURVE_DEGREE, np.linspace(0, 1, 101))
    deviation = largest(along @ (weights.sum(axis=-1).T - 1))
    return Measurement(deviation, "largest |b_0 + ... + b_4 - 1|", deviation <= largest(_noise(document).sum(axis=-1)))


def _rows_cancel(document: Document) -> bool:
    """Whether the kernels keep what makes the weights sum to 1: [x^2 x 1] M^-1 sums to 1 for every x."""
    inverted = inverse_kernels(_knots(document)[:, KERNEL_KNOTS], decimals=document.formulation.kernel_decimals)
    return largest(inverted.sum(axis=-1) - [0, 0, 1]) <= ROUNDING * largest(inverted)


def kernel_examples(document: Document) -> tuple[Document, ...]:
    """Return the document with knots whose kernels four decimals hold, and with some whose kernels they do not."""
    return set_all_knots(document, _HALVES), set_all_knots(document, _THIRDS)


KERNELS_HOLD = Condition("the kernels' rows still sum to 0, 0, 1 once they are cut to four decimals", _rows_cancel)


def quartic(document: Document) -> Measurement:
    """Every curve, and with them the surface, is of degree four (title, abstract)."""
    noise = _noise(document).max(axis=1)
    of_curves = [polynomial_degree(*curve) for curve in zip(_weights(document), noise, strict=True)]
    coefficients, rounding = build_patch(document).coefficients[0, 0], surface_rounding(document)
    of_patch = [polynomial_degree(patch, rounding) for patch in (coefficients, coefficients.swapaxes(0, 1))]
    higher = [name for name, degree in zip(curve_names(document), of_curves, strict=True) if degree > _QUARTIC]
    degree = max(*of_curves, *of_patch)
    surface = f"the surface is of degree {of_patch[0]} in u and {of_patch[1]} in v"
    note = f"{surface}; above four: {', '.join(higher)}" if higher else surface
    return Measurement(float(degree), "largest degree", degree <= _QUARTIC, note)


def polynomial_degree(coefficients: Array, noise: Array) -> int:
    """Return the true degree of polynomials in Bernstein form, of all columns together, down to rounding.

    Parameters
    ----------
    coefficients : (n + 1, ..., d) of degree n along the first axis
    noise : (d,) what is no larger than this is rounding
    """
    degree = len(coefficients) - 1
    while degree and (np.abs(np.diff(coefficients, degree, axis=0)) <= 2**degree * noise).all():
        degree -= 1
    return degree


def _all_quartic(document: Document) -> bool:
    knots = _knots(document)
    return bool((knots[:, _S] == knots[:, _U]).all())


def degree_examples(document: Document) -> tuple[Document, ...]:
    """Return the document with s_ip = u_ip on every curve, and on every curve but C_0."""
    rows, columns = (family.array.copy() for family in (document.row_knots, document.column_knots))
    for family in (rows, columns):
        family[..., _S] = family[..., _U]
    quartic_here = replace(document, row_knots=KnotTable(rows), column_knots=KnotTable(columns))
    rows[0] = tuple(_LIFTED)
    return quartic_here, replace(quartic_here, row_knots=KnotTable(rows))


S_IS_U = Condition("s_ip = u_ip (v_ip) on every curve", _all_quartic)


def ends(document: Document) -> Measurement:
    """The weights at both ends are [0 0 1 0 0], (46), (48)."""
    return _against_the_paper(document, _weights(document), [[0, 0, 1, 0, 0]] * 2, "weight")


def tangents(document: Document) -> Measurement:
    """The first derivatives of the weights at both ends are [0 -0.5 0 0.5 0], (51), (53)."""
    first = bernstein.derivative(_weights(document), 1)
    return _against_the_paper(document, first, [[0, -0.5, 0, 0.5, 0]] * 2, "first derivative")


def curvatures(document: Document) -> Measurement:
    """The second derivatives of the weights are [0 0 2 -4 2] at the start and [2 -4 2 0 0] at the end, (55), (57)."""
    second = bernstein.derivative(bernstein.derivative(_weights(document), 1), 1)
    return _against_the_paper(document, second, [[0, 0, 2, -4, 2], [2, -4, 2, 0, 0]], "second derivative")


def _against_the_paper(document: Document, weights: Array, paper: list[list[float]], of_what: str) -> Measurement:
    """Compare the rows at both ends of the ten curves' weights, (10, n, 5), with the paper's, (2, 5)."""
    found = weights[:, [0, -1]]
    difference = np.abs(found - np.array(paper))
    curve = int(difference.max(axis=(1, 2)).argmax())
    start, end = (_row(row) for row in found[curve])
    deviation = largest(difference)
    return Measurement(
        value=deviation,
        what=f"largest difference of a {of_what} from the paper's",
        holds=bool((difference <= 2**CURVE_DEGREE * largest(_noise(document))).all()),
        note=f"{curve_names(document)[curve]} has {start} at 0 and {end} at 1",
    )


def _row(row: Array) -> str:
    """Return a row of weights in the paper's way of writing."""
    return "[" + " ".join(f"{value:.4g}" for value in np.round(row, 10) + 0.0) + "]"


def _knots(document: Document) -> Array:
    """Return the knots of all curves, (k, 4)."""
    return np.concatenate(window_arrays(document)[1:])


def _noise(document: Document) -> Array:
    """Return up to what size the weights of all curves are no more than rounding, (k, 7, 5)."""
    return NOISE * weight_summands(_knots(document), kernel_decimals=document.formulation.kernel_decimals)


def _weights(document: Document) -> Array:
    """Return the weights of all curves as the formulation computes them, (k, 7, 5)."""
    return weight_coefficients(_knots(document), kernel_decimals=document.formulation.kernel_decimals)
