"""The paper's claims about the shape: locality, symmetry, the boxes, fairness (abstract, 5.1 to 5.3)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from qovr_core.arrays import Array
from qovr_core.construction import build_patch, surface_rounding, window_arrays
from qovr_core.document import Document
from qovr_core.edits import set_all_knots, set_points
from qovr_core.evaluation import Evaluation, parameters
from qovr_core.geometry import bernstein
from qovr_core.geometry.alignment import bounding_box
from qovr_core.geometry.edges import Edge
from qovr_core.geometry.knots import Knots
from qovr_core.geometry.patch import PATCH_DEGREE
from qovr_core.geometry.rounding import ROUNDING, largest, part_of
from qovr_core.laboratory.falloff import best_decay
from qovr_core.laboratory.measurement import Condition, Measurement
from qovr_core.laboratory.trials import SAMPLES
from qovr_core.layer import Layer

POINT_STEP = 0.1
"""A control point is moved by this part of the net's size, along all axes alike."""

FITS = 0.05
"""A law that misses no displacement by more than this part of the largest one describes it, as a picture shows it."""

_NOTICED = 0.01
"""A displacement above this part of the largest one counts as moved."""

_LENGTHS = np.geomspace(0.02, 20, 30)
"""Decay lengths tried first, in parameters: from a fiftieth of the surface to no decay at all."""

_REFINED = 15
"""Decay lengths tried between the neighbours of the best of those."""

_GRID = np.linspace(0, 1, 21)


def local(document: Document) -> Measurement:
    """The displacement falls off exponentially with the distance from the moved point (abstract, 5.3)."""
    moved = point_displacements(document)
    net_shape = moved.shape[:2]
    misfits = np.array([misfit_of_exponential(moved[index]) for index in np.ndindex(net_shape)]).reshape(net_shape)
    worst = np.unravel_index(misfits.argmax(), net_shape)
    middle = tuple(count // 2 for count in net_shape)
    centre = moved[middle]
    share = float((centre > _NOTICED * centre.max()).mean())
    on_edges = max(centre[edge.position].max() for edge in Edge)
    part_on_edges = part_of(float(on_edges), float(centre.max()))
    is_moved = on_edges > 2 * np.linalg.norm(surface_rounding(document))
    edges = f"moves its edges by up to {part_on_edges:.2g} of that" if is_moved else "keeps its edges"
    return Measurement(
        value=float(misfits.max()),
        what="misfit of the best exponential as part of the largest displacement",
        holds=bool(misfits[worst] <= FITS),
        note=f"worst for {_point_name(worst)}; moving {_point_name(middle)} moves {share:.0%} of the surface "
        f"by more than {_NOTICED:.0%} of the largest displacement and {edges}",
    )


def point_displacements(document: Document) -> Array:
    """Return how far the raw surface moves when each control point is moved.

    Returns
    -------
    (5, 5, 21, 21) lengths, indexed [i, j, iu, iv] on 21 x 21 parameters from 0 to 1
    """
    net = document.control_points
    step = POINT_STEP * (document.net_size or 1.0) / np.sqrt(3)
    i, j = np.indices(net.shape[:2]).reshape(2, -1)
    nets = np.repeat(net[None], len(i), axis=0)
    nets[np.arange(len(i)), i, j] += step
    _, rows, columns = window_arrays(document)
    motion = document.formulation.build(nets, rows, columns) - build_patch(document).coefficients[0, 0]
    basis = bernstein.basis(PATCH_DEGREE, _GRID)
    lengths: Array = np.linalg.norm(np.einsum("ua,vb,kabd->kuvd", basis, basis, motion, optimize=True), axis=-1)
    return lengths.reshape(*net.shape[:2], *lengths.shape[1:])


def _point_name(index: Sequence[int | np.intp]) -> str:
    return "P_{},{}".format(*index)


def misfit_of_exponential(displacement: Array) -> float:
    """Return how far the best A exp(-d / l) misses a displacement (21, 21), as part of its largest value.

    The distance d in parameters is from where the displacement is largest. Amplitude A and decay length l are the
    least-squares ones.
    """
    top = displacement.max()
    if top == 0:
        return 0.0
    u, v = (_GRID[index] for index in np.unravel_index(displacement.argmax(), displacement.shape))
    distance = np.hypot(_GRID[:, None] - u, _GRID[None, :] - v).ravel()
    best, *_ = best_decay(distance, displacement.ravel(), _LENGTHS)
    near = np.geomspace(_LENGTHS[max(best - 1, 0)], _LENGTHS[min(best + 1, len(_LENGTHS) - 1)], _REFINED)
    *_, deviations = best_decay(distance, displacement.ravel(), near)
    return largest(deviations) / float(top)


def symmetry(document: Document) -> Measurement:
    """With 0.5 knots and a symmetric net the surface is symmetric (5.3).

    The nets are made from the document's: as the paper's, over a rectangle, with heights mirrored in u, mirrored in v,
    or alike under half a turn. A net in space that has no other symmetry than half a turn is tried besides.
    """
    asymmetries = {name: _asymmetry(name, made) for name, made in symmetric_documents(document).items()}
    worst = max(asymmetries, key=lambda name: asymmetries[name][0])
    symmetric = all(is_rounding for _, is_rounding in asymmetries.values())
    notes = [] if symmetric else [f"the net with heights symmetric by {worst} gives a surface that is not"]
    turned = _turned(document)
    part, is_rounding = _asymmetry(_HALF_TURN, turned)
    if not is_rounding:
        notes.append(f"a net in space that is symmetric by half-turn alone gives a surface that is not, by {part:.2g}")
    return Measurement(
        value=asymmetries[worst][0],
        what="largest mirrored difference as part of the surface's size",
        holds=symmetric,
        note="; ".join(notes),
        example=None if is_rounding else turned,
    )


_HALF_TURN = "half-turn"
_MIRRORS = {"mirror in u": (False, True), "mirror in v": (True, False), _HALF_TURN: (True, True)}
"""By name, whether the symmetry reverses the rows i (v) and the columns j (u)."""


def symmetric_documents(document: Document) -> dict[str, Document]:
    """Return documents with 0.5 knots over a symmetric rectangle, their heights made symmetric, by symmetry."""
    x, y, z = np.moveaxis(document.control_points, -1, 0)
    x_of_column, y_of_row = x.mean(axis=0), y.mean(axis=1)
    x = np.broadcast_to((x_of_column - x_of_column[::-1]) / 2 + x.mean(), z.shape)
    y = np.broadcast_to(((y_of_row - y_of_row[::-1]) / 2 + y.mean())[:, None], z.shape)
    nets = {name: np.stack([x, y, (z + _reversed(z, *flips)) / 2], axis=-1) for name, flips in _MIRRORS.items()}
    return {name: set_all_knots(set_points(document, net), Knots()) for name, net in nets.items()}


def _turned(document: Document) -> Document:
    """Return the document with 0.5 knots and its net made symmetric by half a turn about its upright middle line."""
    net = document.control_points
    turned = net[::-1, ::-1].copy()
    turned[..., :2] = 2 * net[..., :2].mean(axis=(0, 1)) - turned[..., :2]
    return set_all_knots(set_points(document, (net + turned) / 2), Knots())


def _reversed(values: Array, rows: bool, columns: bool) -> Array:
    return values[:: -1 if rows else 1, :: -1 if columns else 1]


def _asymmetry(name: str, document: Document) -> tuple[float, bool]:
    """Return how far a surface is from a symmetry, as part of its size, and whether that is rounding."""
    rows, columns = _MIRRORS[name]
    patch = build_patch(document).coefficients[0, 0]
    mirrored = _reversed(patch.swapaxes(0, 1), rows, columns).swapaxes(0, 1)
    difference = patch - mirrored
    for axis, is_reversed in ((0, columns), (1, rows)):
        if is_reversed:  # a mirrored coordinate changes sign about the middle
            sums = patch[..., axis] + mirrored[..., axis]
            difference[..., axis] = sums - sums.mean()
    size = float(np.ptp(patch, axis=(0, 1)).max())
    noise = 2 * surface_rounding(document)  # of a difference, and of a sum less the mean of many
    return part_of(largest(difference), size), bool((np.abs(difference) <= noise).all())


def _last_row_is_symmetric(document: Document) -> bool:
    heights = symmetric_documents(document)[_HALF_TURN].control_points[-1, :, 2]
    return largest(heights - heights[::-1]) <= ROUNDING * largest(document.control_points[..., 2])


def symmetry_examples(document: Document) -> tuple[Document, ...]:
    """Return the document with its heights mirrored in u, whose rows are symmetric, and twisted, whose are not."""
    net = document.control_points
    mirrored, twisted = net.copy(), net.copy()
    mirrored[..., 2] = (net[..., 2] + net[:, ::-1, 2]) / 2
    y, x = (np.linspace(-1.0, 1.0, count) for count in net.shape[:2])
    twisted[..., 2] += (np.ptp(net[..., 2]) or 1.0) * y[:, None] * x
    return set_points(document, mirrored), set_points(document, twisted)


ROW_4_SYMMETRIC = Condition("row 4 is symmetric in every symmetric net made from it", _last_row_is_symmetric)


def boxes(document: Document) -> Measurement:
    """T maps the box of the raw samples onto the box of the control points, (61)-(65), 5.1."""
    aligned = Evaluation(replace(document, samples=SAMPLES))
    u, v = map(parameters, SAMPLES)
    box = bounding_box(aligned.transformed_patch.points(u, v))
    difference = np.abs(box - aligned.control_box).max(axis=1)
    flat = ", ".join(aligned.flat_axes)
    return Measurement(
        value=part_of(largest(difference), document.net_size),
        what=f"largest difference of the two boxes at {SAMPLES[0]} x {SAMPLES[1]} samples as part of the net's size",
        holds=bool((difference <= aligned.layer_rounding(Layer.TRANSFORMED)).all()),
        note=f"the raw surface has no extent along {flat}: T only moves there" if flat else "",
    )


def _has_extent(document: Document) -> bool:
    return not Evaluation(replace(document, samples=SAMPLES)).flat_axes


RAW_HAS_EXTENT = Condition("the raw surface has an extent along every axis", _has_extent)
