"""The control points' part of the next state: moves by hand and by numbers, and what the tools let follow."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from qovr_app.state import intents, point_intents
from qovr_app.state.document_steps import edited, with_document
from qovr_app.state.editor_state import EditorState, Gesture
from qovr_app.state.names import points_text
from qovr_app.state.tools import ToolSettings
from qovr_core import Document, DocumentError, edits
from qovr_core.arrays import Array
from qovr_core.document import NetIndex
from qovr_core.geometry.knots import Direction
from qovr_core.net_moves import mirrored, softened
from qovr_core.number_texts import summed_all
from qovr_core.symmetry import make_symmetric

NUDGE_SECONDS = 1.0
"""Nudges closer together than this are one movement of the hand, and so one undo step."""


def points_moved(state: EditorState, intent: intents.PointsMoved) -> EditorState:
    """Move points of the document even where edits wait; what is pending over them stays pending."""
    begun = state.document_before(intent.gesture)
    net = _moved(begun, intent.indices, _triples(intent.displacements), state.tools, is_soft=state.tools.soft)
    moved = _with_net(state, f"Move {points_text(intent.indices)}", net, intent, intent.gesture)
    return replace(moved, gesture=_gesture(state, intent.gesture))


def points_nudged(state: EditorState, intent: point_intents.PointsNudged) -> EditorState:
    """Move points by a step; steps that follow each other quickly become one."""
    displacements = _triples((intent.displacement,) * len(intent.indices))
    net = _moved(state.document, intent.indices, displacements, state.tools, is_soft=state.tools.soft)
    return _with_net(state, f"Move {points_text(intent.indices)}", net, intent, _burst(state, intent))


def points_edited(state: EditorState, intent: point_intents.PointsEdited) -> EditorState:
    """Bring points to where an edit has them; of the document even where edits wait, as by hand."""
    document, edit = state.document_before(intent.gesture), intent.edit
    edits.check_points(document, intent.indices)
    indices = np.array(intent.indices, dtype=np.intp).reshape(-1, 2)
    displacements = edit.of(document.control_points, indices) - document.control_points[tuple(indices.T)]
    is_soft = state.tools.soft and edit.is_soft
    net = _moved(document, intent.indices, displacements, state.tools, is_soft=is_soft)
    return _with_net(state, f"{edit.verb} {points_text(intent.indices)}", net, intent, intent.gesture)


def made_symmetric(state: EditorState, intent: point_intents.MadeSymmetric) -> EditorState:
    across = "rows" if intent.across is Direction.ROWS else "columns"
    text = f"Make symmetric across {across}"
    mirror = state.tools.mirror(intent.across)
    return edited(state, text, lambda document: make_symmetric(document, intent.across, intent.source, mirror), intent)


def _with_net(state: EditorState, text: str, net: Array, intent: intents.Intent, gesture: int = 0) -> EditorState:
    return with_document(state, text, edits.set_points(state.document, net), intent, gesture)


def _moved(
    document: Document, indices: tuple[NetIndex, ...], displacements: Array, tools: ToolSettings, *, is_soft: bool
) -> Array:
    """Return the net after a move of some points: with their mirror images, and softly what is around.

    Raises
    ------
    DocumentError : the net has no such point, or there is not one displacement a point
    """
    edits.check_points(document, indices)
    if displacements.shape != (len(indices), 3):
        raise DocumentError(
            "the count of displacements", str(len(displacements)), f"{len(indices)}, one for each point"
        )
    net = document.control_points
    field, moved = np.zeros_like(net), np.zeros(net.shape[:2], dtype=bool)
    if not indices:
        return net
    places = tuple(np.array(indices, dtype=np.intp).T)
    field[places], moved[places] = displacements, True
    moves = field, moved
    for direction in tools.symmetries:
        moves = mirrored(moves, tools.mirror(direction), indices[0])
    field, _ = softened(moves, tools.soft_radius) if is_soft else moves
    result = net.copy()
    changed = np.nonzero(field)
    result[changed] = summed_all(net[changed], field[changed])
    return result


def _triples(displacements: tuple[tuple[float, float, float], ...]) -> Array:
    return np.array(displacements, dtype=np.float64).reshape(-1, 3)


def _burst(state: EditorState, intent: point_intents.PointsNudged) -> int:
    """Return the gesture of a nudge: that of the nudge of the same points just before it, or one of its own.

    Its numbers are negative: those of drags are not.
    """
    history = state.history
    before = history.latest
    if not isinstance(before, point_intents.PointsNudged) or before.indices != intent.indices:
        return -1 - history.last_serial
    is_soon = 0 <= intent.at - before.at <= NUDGE_SECONDS
    return history.steps[-1].gesture if is_soon else -1 - history.last_serial


def _gesture(state: EditorState, number: int) -> Gesture | None:
    """Return the gesture of a number: the one in hand, one that begins here, or none."""
    if not number or (state.gesture is not None and state.gesture.number == number):
        return state.gesture if number else None
    return Gesture(number, state.history, state.draft)
