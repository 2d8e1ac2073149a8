"""The paper's pipeline in its order: raw surface, boxes, transformation, transformed surface."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from qovr_core.arrays import Array, read_only
from qovr_core.construction import build_patch
from qovr_core.document import Document
from qovr_core.geometry.alignment import align, bounding_box
from qovr_core.geometry.patch import Patch
from qovr_core.layer import Layer


@dataclass(frozen=True, eq=False)
class AlignedPatch:
    """A document's surface as a whole, with no samples of it; every array is float64 and read-only.

    Parameters
    ----------
    document : what it was made from
    patch : the raw surface, exact
    control_box, raw_box : (3, 2) boxes of the control points and of the raw samples, columns min and max
    matrix : (4, 4) the transformation T of (61)-(65)
    flat_axes : axes along which the raw samples have no extent, so that ``matrix`` only moves there
    """

    document: Document
    patch: Patch
    control_box: Array
    raw_box: Array
    matrix: Array
    flat_axes: tuple[str, ...]

    @property
    def transformed_patch(self) -> Patch:
        """The transformed surface, exact."""
        return self.patch.transformed(self.matrix)

    def layer_patch(self, layer: Layer) -> Patch:
        """Return the surface of a layer, exact."""
        return self.patch if layer is Layer.RAW else self.transformed_patch


@dataclass(frozen=True, eq=False)
class Surface(AlignedPatch):
    """The result of ``configure``: the aligned patch and its samples.

    Parameters
    ----------
    u, v : (n,) and (m,) parameters of the samples, from 0 to 1
    raw : (n, m, 3) samples of the raw surface, indexed [iu, iv]
    transformed : (n, m, 3) the same after ``matrix``
    """

    u: Array
    v: Array
    raw: Array
    transformed: Array


def parameters(samples: int) -> Array:
    """Return the sample parameters of one direction, (samples,) from 0 to 1: counted, never accumulated."""
    return read_only(np.linspace(0.0, 1.0, samples))


def align_patch(document: Document) -> AlignedPatch:
    """Compute a document's surface without keeping samples: what a view needs while something is dragged.

    Boxes and matrix are those of ``configure``, of the document's own samples.

    Raises
    ------
    EvaluationError : the coordinates are not finite in double precision
    """
    patch = build_patch(document)
    return _aligned(document, patch, patch.sampled_box(*map(parameters, document.samples)))


def configure(document: Document) -> Surface:
    """Compute a document's surface: raw samples, boxes, T, transformed samples (Figure 3, Algorithm 1).

    Raises
    ------
    EvaluationError : the coordinates are not finite in double precision
    """
    patch = build_patch(document)
    u, v = map(parameters, document.samples)
    raw, raw_box = patch.points_and_box(u, v)
    aligned = _aligned(document, patch, raw_box)
    transformed = aligned.transformed_patch.points(u, v)
    return Surface(**vars(aligned), u=u, v=v, raw=raw, transformed=transformed)


def _aligned(document: Document, patch: Patch, raw_box: Array) -> AlignedPatch:
    control_box = bounding_box(document.control_points)
    alignment = align(raw_box, control_box)
    return AlignedPatch(document, patch, control_box, raw_box, alignment.matrix, alignment.flat_axes)
