"""Bounding boxes and the transformation that brings a raw surface onto its control net, eqs. (61)-(65)."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from qovr_core.arrays import Array, read_only


@dataclass(frozen=True)
class Alignment:
    """The transformation T and what it met.

    Parameters
    ----------
    matrix : (4, 4) float64, acts on columns [x y z 1]
    flat_axes : the axes, of ``"x"``, ``"y"``, ``"z"``, along which the raw surface has no extent; there T
        only moves (m = 1), because no scale is defined
    """

    matrix: Array
    flat_axes: tuple[str, ...]


def bounding_box(points: Array) -> Array:
    """Return the box of points.

    Parameters
    ----------
    points : (..., 3)

    Returns
    -------
    (3, 2) float64, columns min and max
    """
    flat = points.reshape(-1, 3)
    return read_only(np.stack([flat.min(axis=0), flat.max(axis=0)], axis=1))


@np.errstate(under="ignore")  # what underflows is nothing
def align(raw_box: Array, control_box: Array, rounding: npt.ArrayLike = 0.0) -> Alignment:
    r"""Return the transformation that maps one box onto the other axis by axis, eqs. (61)-(65).

    $$x' = m_x x + c_x, \quad m_x = \frac{x^P_{max} - x^P_{min}}{x^S_{max} - x^S_{min}}, \quad
    c_x = x^P_{min} - m_x x^S_{min}$$

    Parameters
    ----------
    raw_box : (3, 2) box of the sampled raw surface, columns min and max
    control_box : (3, 2) box of the control points
    rounding : (3,) an extent up to this is rounding of the raw surface (``Evaluation.rounding``), and the axis flat
    """
    raw_extent = raw_box[:, 1] - raw_box[:, 0]
    control_extent = control_box[:, 1] - control_box[:, 0]
    is_flat = raw_extent <= np.asarray(rounding)
    scale = np.where(is_flat, 1.0, control_extent / np.where(is_flat, 1.0, raw_extent))
    matrix = np.diag([*scale, 1.0])
    matrix[:3, 3] = control_box[:, 0] - scale * raw_box[:, 0]
    flat_axes = tuple(axis for axis, flat in zip("xyz", is_flat, strict=True) if flat)
    return Alignment(read_only(matrix), flat_axes)
