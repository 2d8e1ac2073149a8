"""The surface of a net in the parts that CAD formats hold: one B-spline surface for each smooth part."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise, product
from pathlib import Path

import numpy as np

from qovr_core.arrays import Array, Indices, read_only
from qovr_core.construction import window_degrees
from qovr_core.document import Document
from qovr_core.errors import FileError
from qovr_core.evaluation import Evaluation
from qovr_core.files import bspline
from qovr_core.files.bspline import SplineSurface
from qovr_core.files.options import ExportOptions
from qovr_core.geometry.knots import Direction
from qovr_core.geometry.patch import Patch

Sheet = tuple[tuple[SplineSurface, ...], ...]
"""Surfaces that meet along their edges, ``[k][l]`` the one that is k-th along u and l-th along v."""

Block = tuple[slice, slice]
"""The windows of a part, along u and along v."""

_UNMET = 1e-12
"""A smooth joint's coefficients are means of their neighbours within this part of the largest coefficient: rounding."""


def sheets(evaluation: Evaluation, options: ExportOptions, path: Path) -> tuple[Sheet, ...]:
    """Return the surface to be written, cut along its sharp joints, or along none where it is to be one face.

    Its parameters are those of the net, so that a closed direction is cut at its seam, smooth or not. Where the
    formulation leaves gaps between windows, each of them is a sheet of its own.

    Raises
    ------
    FileError : the surface, or a part of it, has no area
    """
    patch, document = bspline.chosen_patch(evaluation, options, path), evaluation.document
    rounding = evaluation.layer_rounding(options.chosen_layer(document))
    degrees = window_degrees(document)
    if not document.formulation.is_continuous:
        m, n = patch.windows
        gaps = _Net(patch, degrees, ([False] * (n - 1), [False] * (m - 1)), rounding, path)
        along_u, along_v = map(_runs, gaps.smooth)
        return tuple(((gaps.part((b, a)),),) for b, a in product(along_u, along_v))
    patch = Patch(_met(patch.coefficients), patch.degree, patch.lengths)
    net = _Net(patch, degrees, _smooth_joints(document, patch), rounding, path)
    along_u, along_v = (_runs([True] * len(joints) if options.single_face else joints) for joints in net.smooth)
    return (tuple(tuple(net.part((b, a)) for a in along_v) for b in along_u),)


def surfaces(sheets: tuple[Sheet, ...]) -> Iterator[SplineSurface]:
    """Yield the surfaces of all sheets."""
    for sheet in sheets:
        for along_v in sheet:
            yield from along_v


def uncertainty(sheets: tuple[Sheet, ...]) -> float:
    """Return the distance below which points of the whole surface are the same, a power of ten."""
    return bspline.uncertainty(np.concatenate([surface.points.reshape(-1, 3) for surface in surfaces(sheets)]))


def _runs(smooth: Sequence[bool]) -> list[slice]:
    """Return the windows between which joints are smooth, of all windows that so many joints part."""
    cuts = [k for k, is_smooth in enumerate(smooth, 1) if not is_smooth]
    return [slice(start, end) for start, end in pairwise([0, *cuts, len(smooth) + 1])]


def _met(coefficients: Array) -> Array:
    """Return coefficients (m, n, 7, 7, 3) of which neighbours share those of their joint to the last bit."""
    result = coefficients.copy()
    for windows, inside in ((1, 2), (0, 3)):
        pieces = np.moveaxis(result, (windows, inside), (0, 1))
        pieces[:-1, -1] = pieces[1:, 0] = (pieces[:-1, -1] + pieces[1:, 0]) / 2
    return read_only(result)


def _smooth_joints(document: Document, patch: Patch) -> tuple[list[bool], list[bool]]:
    """Return which joints between windows along u and along v are smooth in the surface's own parameter.

    Others than these of the document's are sharp, or their windows' lengths differ too much for one parameter.
    """
    largest = _UNMET * np.abs(patch.coefficients).max()
    found = []
    for direction, (windows, inside), ends in zip(Direction, ((1, 2), (0, 3)), patch.breakpoints, strict=True):
        pieces = np.moveaxis(patch.coefficients, (windows, inside), (0, 1))
        lengths = np.diff(ends).reshape(-1, 1, 1, 1)
        before, after = lengths[:-1], lengths[1:]
        means = (after * pieces[:-1, -2] + before * pieces[1:, 1]) / (before + after)
        missed = np.abs(means - pieces[1:, 0]).max(axis=(1, 2, 3))
        smooth = document.joints.smooth(direction)[: len(missed)]
        found.append((smooth & (missed <= largest)).tolist())
    return found[0], found[1]


@dataclass(frozen=True, eq=False)
class _Net:
    """What parts are cut from.

    Parameters
    ----------
    patch : the surface
    degrees : its degrees in u and in v by window, (m, n, 2)
    smooth : which joints along u and along v are smooth
    rounding : up to what size a difference of coordinates is no more than rounding, (3,)
    path : the file that is written, for the texts of errors
    """

    patch: Patch
    degrees: Indices
    smooth: tuple[Sequence[bool], Sequence[bool]]
    rounding: Array
    path: Path

    def part(self, block: Block) -> SplineSurface:
        """Return a block of windows as one surface.

        Raises
        ------
        FileError : it has no area
        """
        along_u, along_v = block
        coefficients = self.patch.coefficients[along_v, along_u]
        if not bspline.has_area(Patch(coefficients), self.rounding):
            raise FileError(
                f"{self.path}: the part that begins with window {along_v.start},{along_u.start} is drawn together into "
                "a curve or a point; expected one with an area"
            )
        degree_u, degree_v = self.degrees[along_v, along_u].max(axis=(0, 1)).tolist()
        ends_u, ends_v = (ends[k.start : k.stop + 1] for k, ends in zip(block, self.patch.breakpoints, strict=True))
        inner_u, inner_v = (joints[k.start : k.stop - 1] for k, joints in zip(block, self.smooth, strict=True))
        return bspline.spline_surface(coefficients, (degree_u, degree_v), (ends_u, ends_v), (inner_u, inner_v))
