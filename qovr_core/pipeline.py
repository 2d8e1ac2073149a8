"""The paper's pipeline in its order: raw surface, boxes, transformation, transformed surface."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from qovr_core.alignment import align, bounding_box
from qovr_core.arrays import Array, read_only
from qovr_core.document import Document
from qovr_core.formulations import build_patch
from qovr_core.patch import Patch


@dataclass(frozen=True, eq=False)
class Surface:
    """The result of ``configure``; every array is float64 and read-only.

    Parameters
    ----------
    document : what it was made from
    patch : the raw surface, exact
    u, v : (n,) and (m,) parameters of the samples, from 0 to 1
    raw : (n, m, 3) samples of the raw surface, indexed [iu, iv]
    transformed : (n, m, 3) the same after ``matrix``
    control_box, raw_box : (3, 2) boxes of the control points and of ``raw``, columns min and max
    matrix : (4, 4) the transformation T of (61)-(65)
    flat_axes : axes along which ``raw`` has no extent, so that ``matrix`` only moves there
    """

    document: Document
    patch: Patch
    u: Array
    v: Array
    raw: Array
    transformed: Array
    control_box: Array
    raw_box: Array
    matrix: Array
    flat_axes: tuple[str, ...]

    @property
    def transformed_patch(self) -> Patch:
        """The transformed surface, exact."""
        return self.patch.transformed(self.matrix)


def parameters(samples: int) -> Array:
    """Return the sample parameters of one direction, (samples,) from 0 to 1: counted, never accumulated."""
    return read_only(np.linspace(0.0, 1.0, samples))


def configure(document: Document) -> Surface:
    """Compute a document's surface: raw samples, boxes, T, transformed samples (Figure 3, Algorithm 1).

    Raises
    ------
    EvaluationError : the coordinates are not finite in double precision
    """
    patch = build_patch(document)
    u, v = (parameters(count) for count in document.samples)
    raw, raw_box = patch.points_and_box(u, v)
    control_box = bounding_box(document.control_points)
    alignment = align(raw_box, control_box)
    transformed = patch.transformed(alignment.matrix).points(u, v)
    return Surface(
        document=document,
        patch=patch,
        u=u,
        v=v,
        raw=raw,
        transformed=transformed,
        control_box=control_box,
        raw_box=raw_box,
        matrix=alignment.matrix,
        flat_axes=alignment.flat_axes,
    )
