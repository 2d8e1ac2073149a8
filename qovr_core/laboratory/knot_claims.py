"""The paper's claim that internal knots leave the boundary where it is (abstract, 5.2)."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np

from qovr_core.arrays import Array, Flags, Indices
from qovr_core.construction import build_patch, surface_rounding, window_arrays
from qovr_core.document import Document
from qovr_core.edits import set_all_knots
from qovr_core.geometry import bernstein
from qovr_core.geometry.alignment import align, bounding_box
from qovr_core.geometry.edges import Edge
from qovr_core.geometry.knots import Knots
from qovr_core.geometry.patch import PATCH_DEGREE
from qovr_core.geometry.rounding import NOISE, part_of
from qovr_core.laboratory.curve_claims import curve_names
from qovr_core.laboratory.measurement import Measurement
from qovr_core.laboratory.trials import SAMPLES

KNOT_STEP = 0.1
"""Each knot is moved this far up and down, and half the way to 0 or 1 where there is not so much room."""

_LARGEST = 1e120
"""A moved knot so near 0 or 1 that coordinates go beyond this gives no surface to compare; squares stay numbers."""

_REMEMBERED = 16
"""Both claims ask for the same moves: those of one document and its examples, under three formulations."""


@dataclass(frozen=True, eq=False)
class EdgeMotion:
    """How far the edges move, by move of a knot.

    Parameters
    ----------
    parts : (k, 4) largest motion of the edges u=0, u=1, v=0, v=1, of the size of what they bound
    edge_keeps : (k, 4) whether an edge keeps its place to rounding
    corners : the largest motion of a corner, likewise of the size
    corners_keep : whether that is rounding
    """

    parts: Array
    edge_keeps: Flags
    corners: float
    corners_keep: bool

    @property
    def keeps(self) -> Flags:
        """(k,) whether all four edges keep their places."""
        return np.asarray(self.edge_keeps.all(axis=1))


@dataclass(frozen=True, eq=False)
class KnotMoves:
    """What the moves of single knots do to a surface, by move: two of each knot, 80 of ten curves, but for those that
    lead to no finite surface.

    Parameters
    ----------
    names : the names of the ten curves
    curve : (80,) which of them the knot belongs to
    has_effect : (80,) whether the surface moves at all
    box_keeps : (80,) whether the box of the raw samples is the same as before
    raw, transformed : how the edges move before and after T, which every move computes anew
    """

    names: tuple[str, ...]
    curve: Indices
    has_effect: Flags
    box_keeps: Flags
    raw: EdgeMotion
    transformed: EdgeMotion


EDGES_KEPT_BY = "the knot belongs to {parts}"
EDGES_KEPT_AFTER_T = "the knot belongs to {parts}, and the box of the raw samples keeps"


def edges(document: Document) -> Measurement:
    """No internal knot moves an edge of the raw surface."""
    moves = knot_moves(document)
    return Measurement(
        value=float(moves.raw.parts.max()),
        what=f"largest motion of an edge when one knot moves by {KNOT_STEP:g}, as part of the surface's size",
        holds=bool(moves.raw.keeps.all()),
        note=f"{_who_moves(moves)}; {_corners(moves.raw)}",
        parts=_by_curve(moves, moves.has_effect, moves.raw.keeps),
    )


def edges_transformed(document: Document) -> Measurement:
    """No internal knot moves an edge of the transformed surface, T computed anew."""
    moves = knot_moves(document)
    counted = moves.has_effect & moves.box_keeps
    return Measurement(
        value=float(moves.transformed.parts.max()),
        what=f"largest motion of an edge after T when one knot moves by {KNOT_STEP:g}, as part of the net's size",
        holds=bool(moves.transformed.keeps.all()),
        note=f"{counted.sum()} of {moves.has_effect.sum()} moves with an effect keep the sampled box; "
        f"{_corners(moves.transformed)}",
        parts=_by_curve(moves, counted, moves.transformed.keeps),
    )


def box_examples(document: Document) -> tuple[Document, ...]:
    """Return two saddles over a rectangle, with the document's knots and with 0.5: they meet their box on the edges."""
    i, j = np.meshgrid(*(np.linspace(-1, 1, count) for count in document.control_points.shape[:2]), indexing="ij")
    box = bounding_box(document.control_points)
    extent = np.where(box[:, 1] > box[:, 0], box[:, 1] - box[:, 0], 1.0)
    net = box.mean(axis=1) + extent / 2 * np.stack([j, i, j * j - i * i], axis=-1)
    saddle = replace(document, control_points=net)
    return saddle, set_all_knots(saddle, Knots())


def _who_moves(moves: KnotMoves) -> str:
    """Name, for each edge, the curves under whose knots it moves."""
    texts = []
    for number, edge in enumerate(Edge):
        moved = ~moves.raw.edge_keeps[:, number]
        curves = [moves.names[k] for k in np.unique(moves.curve[moved])]
        texts.append(f"{edge} moves under {', '.join(curves)}" if curves else f"{edge} keeps")
    return "; ".join(texts)


def _corners(motion: EdgeMotion) -> str:
    return "corners keep" if motion.corners_keep else f"corners move by {motion.corners:.2g}"


def _by_curve(moves: KnotMoves, counted: Flags, keeps: Flags) -> dict[str, bool]:
    """Return whether the counted moves of each curve's knots keep the edges; curves without any are left out."""
    return {
        name: bool(keeps[counted & (moves.curve == k)].all())
        for k, name in enumerate(moves.names)
        if (counted & (moves.curve == k)).any()
    }


@lru_cache(maxsize=_REMEMBERED)
def knot_moves(document: Document) -> KnotMoves:
    """Move each knot up and down, and compare surfaces, edges and boxes.

    Raises
    ------
    EvaluationError : the document has no finite surface
    """
    curve, knots = _moved_knots(document)
    net, all_knots = document.control_points, np.split(knots, [len(document.row_knots)], axis=1)
    before = build_patch(document).coefficients[0, 0]
    moved = document.formulation.build(net, *all_knots)
    has_surface = np.abs(moved).max(axis=(1, 2, 3)) <= _LARGEST
    moved, curve, all_knots = moved[has_surface], curve[has_surface], [family[has_surface] for family in all_knots]
    patches = np.concatenate([before[None], moved])
    rounding = np.concatenate([surface_rounding(document)[None], document.formulation.rounding(net, *all_knots)])
    boxes = _sampled_boxes(patches)
    edges = _edge_points(patches)
    size = float(np.ptp(before, axis=(0, 1)).max())
    scale, shift = _alignments(boxes, net, rounding)
    aligned = edges * scale[:, None, None] + shift[:, None, None]
    noise = rounding[1:] + rounding[0]
    aligned_rounding = scale * rounding + NOISE * np.abs(shift)
    return KnotMoves(
        names=curve_names(document),
        curve=curve,
        has_effect=(np.abs(moved - before).max(axis=(1, 2)) > noise).any(axis=1),
        box_keeps=(np.abs(boxes[1:] - boxes[0]).max(axis=2) <= noise).all(axis=1),
        raw=_motion(edges, size, noise),
        transformed=_motion(aligned, document.net_size, aligned_rounding[1:] + aligned_rounding[0]),
    )


def _moved_knots(document: Document) -> tuple[Indices, Array]:
    """Return, for each move, the number of the curve and the knots of all curves, (k,) and (k, curves, 4)."""
    knots = np.concatenate(window_arrays(document)[1:])
    up = np.where(knots + KNOT_STEP < 1, knots + KNOT_STEP, (knots + 1) / 2)
    down = np.where(knots - KNOT_STEP > 0, knots - KNOT_STEP, knots / 2)
    curves, names = np.divmod(np.arange(knots.size), knots.shape[1])
    moved = np.repeat(knots[None], 2 * knots.size, axis=0)
    for start, values in ((0, up), (knots.size, down)):
        moved[start + np.arange(knots.size), curves, names] = values.ravel()
    return np.tile(curves, 2), moved


def _sampled_boxes(patches: Array) -> Array:
    """Return the boxes of samples of patches (k, 7, 7, 3), as (k, 3, 2)."""
    basis_u, basis_v = (bernstein.basis(PATCH_DEGREE, np.linspace(0, 1, samples)) for samples in SAMPLES)
    coordinates = np.moveaxis(patches, 0, 2).reshape((PATCH_DEGREE + 1) ** 2, -1)
    points = np.kron(basis_u, basis_v) @ coordinates  # one product for all, rather than one for each
    boxes = np.stack([points.min(axis=0), points.max(axis=0)], axis=-1)
    return boxes.reshape(len(patches), 3, 2)


def _edge_points(patches: Array) -> Array:
    """Return samples of the four edges of patches (k, 7, 7, 3), in the order of ``Edge``, as (k, 4, n, 3)."""
    edges = np.stack([patches[:, *edge.position] for edge in Edge], axis=1)
    points: Array = bernstein.basis(PATCH_DEGREE, np.linspace(0, 1, SAMPLES[0])) @ edges
    return points


def _alignments(boxes: Array, net: Array, rounding: Array) -> tuple[Array, Array]:
    """Return scale and shift of the transformation T of each raw box, each (k, 3)."""
    control_box = bounding_box(net)
    matrices = np.array([align(*each).matrix for each in zip(boxes, [control_box] * len(boxes), rounding, strict=True)])
    return matrices[:, range(3), range(3)], matrices[:, :3, 3]


def _motion(edges: Array, size: float, noise: Array) -> EdgeMotion:
    """Compare the edges after each move with the first, which are those before; ``noise`` is (k, 3)."""
    motion = edges[1:] - edges[0]
    distances = np.linalg.norm(motion, axis=-1)
    is_still = (np.abs(motion) <= noise[:, None, None]).all(axis=-1)
    return EdgeMotion(
        parts=distances.max(axis=-1) / (size or 1.0),
        edge_keeps=is_still.all(axis=-1),
        corners=part_of(float(distances[:, :, [0, -1]].max()), size),
        corners_keep=bool(is_still[:, :, [0, -1]].all()),
    )
