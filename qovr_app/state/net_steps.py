"""The net's structure in the next state: what is asked of windows and joints, and what follows them there."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from qovr_app.state import net_intents
from qovr_app.state.document_steps import with_document
from qovr_app.state.editor_state import EditorState, Selection, with_message
from qovr_app.state.focus import with_focus
from qovr_app.state.intents import Intent
from qovr_app.state.names import AXES
from qovr_app.state.readouts import motion_text
from qovr_core import Document, build_patch
from qovr_core.arrays import Array, Indices
from qovr_core.checks import SAMPLES_RANGE
from qovr_core.document import NetIndex, Window
from qovr_core.edits import extract_window, knots_of
from qovr_core.geometry.knots import KNOT_NAMES, Direction
from qovr_core.geometry.windows import STEP
from qovr_core.structure.change import NetChange, check_continuous
from qovr_core.structure.joints import crease, make_sharp, make_smooth, space_knots
from qovr_core.structure.resampling import resample
from qovr_core.structure.turning import mirror_in_space, reverse, transpose
from qovr_core.structure.windows import append_window, insert_pair, remove_pair

Renumbering = Mapping[int, int]
"""Where rows, or columns, are afterwards, by where they were; those that are gone are missing."""

_U = KNOT_NAMES.index("u")


def window_inserted(state: EditorState, intent: net_intents.WindowInserted) -> EditorState:
    direction = intent.direction
    change = insert_pair(state.document, direction, intent.window)
    at = _along(state.window, direction)
    text = f"Split window {intent.window} along {direction.parameter}"
    return _rebuilt(state, text, change, direction, intent, window=at + (at > intent.window))


def window_removed(state: EditorState, intent: net_intents.WindowRemoved) -> EditorState:
    direction, joint = intent.direction, intent.joint
    change = remove_pair(state.document, direction, joint)
    at, last = _along(state.window, direction), knots_of(state.document, direction).windows - 1
    at = at - (at > joint) if joint < last else at % last  # at the seam, the last one joins the first
    after = (joint + 1) % (last + 1)
    text = f"Join windows {joint} and {after} along {direction.parameter}"
    return _rebuilt(state, text, change, direction, intent, window=at)


def window_appended(state: EditorState, intent: net_intents.WindowAppended) -> EditorState:
    direction = intent.direction
    change = append_window(state.document, direction, at_start=intent.at_start)
    where = "before the first" if intent.at_start else "after the last"
    text = f"Append a window {where} along {direction.parameter}"
    return _rebuilt(state, text, change, direction, intent, window=_along(state.window, direction) + intent.at_start)


def window_extracted(state: EditorState, intent: net_intents.WindowExtracted) -> EditorState:
    document = extract_window(state.document, intent.window)
    maps = [
        {STEP * at + k: k for k in range(document.control_points.shape[axis])} for axis, at in enumerate(intent.window)
    ]
    state = _renumbered(state, maps[0], maps[1], (0, 0))
    return with_document(state, "Extract window {},{}".format(*intent.window), document, intent)


def joint_smoothed(state: EditorState, intent: net_intents.JointSmoothed) -> EditorState:
    begun = state.document_before(intent.gesture)
    change = make_smooth(begun, intent.direction, intent.joint)
    return _moved(state, f"Make {_joint(intent)} smooth", begun, change, intent, gesture=intent.gesture)


def joint_sharpened(state: EditorState, intent: net_intents.JointSharpened) -> EditorState:
    text = f"Make {_joint(intent)} sharp"
    after = with_document(state, text, make_sharp(state.document, intent.direction, intent.joint), intent)
    return with_message(after, "Every curve has its own knots at this joint now; nothing moves yet.")


def joint_creased(state: EditorState, intent: net_intents.JointCreased) -> EditorState:
    begun = state.document_before(intent.gesture)
    change = crease(begun, intent.direction, intent.joint, intent.strength)
    return _moved(state, f"Crease {_joint(intent)}", begun, change, intent, gesture=intent.gesture)


def knots_spaced(state: EditorState, intent: net_intents.KnotsSpaced) -> EditorState:
    change = space_knots(state.document, intent.direction, intent.spacing)
    text = f"Space knots along {intent.direction.parameter}, {intent.spacing}"
    return _moved(state, text, state.document, change, intent)


def net_reversed(state: EditorState, intent: net_intents.NetReversed) -> EditorState:
    document, direction = state.document, intent.direction
    turned = reverse(document, direction)
    counts = document.control_points.shape
    maps = [{k: k for k in range(count)} for count in counts[:2]]
    axis = _axis(direction)
    maps[axis] = {k: counts[axis] - 1 - k for k in range(counts[axis])}
    last = knots_of(document, direction).windows - 1
    focus = _with_along(state.window, direction, last - _along(state.window, direction))
    state = _renumbered(state, maps[0], maps[1], focus)
    after = with_document(state, f"Reverse along {direction.parameter}", turned, intent)
    if document.formulation.is_continuous:
        return with_message(after, f"The same surface runs the other way along {direction.parameter}.")
    return with_message(after, f"The {document.formulation} surface is another one from the other end.")


def net_transposed(state: EditorState, intent: net_intents.NetTransposed) -> EditorState:
    document = transpose(state.document)
    state = _with_points(state, {(i, j): (j, i) for i, j in _points(state)})
    state = with_focus(state, (state.window[1], state.window[0]))
    return with_document(state, "Transpose the net", document, intent)


def net_mirrored(state: EditorState, intent: net_intents.NetMirrored) -> EditorState:
    text = f"Mirror the net in {AXES[intent.axis]}"
    return with_document(state, text, mirror_in_space(state.document, intent.axis), intent)


def net_resampled(state: EditorState, intent: net_intents.NetResampled) -> EditorState:
    begun = state.document_before(intent.gesture)
    check_continuous(begun.formulation, "Resampling")
    patch = build_patch(begun)
    nodes = None if intent.is_even else _parts_of_nodes(begun, patch.breakpoints, intent.windows)
    change = resample(patch, intent.windows, nodes, closed=begun.closed, samples=begun.samples)
    if begun.windows != intent.windows:
        state = _with_points(state, {})
    after = with_document(state, "Resample the net", change.document, intent, intent.gesture)
    return with_message(after, motion_text(change.motion, begun))


def _parts_of_nodes(document: Document, breakpoints: tuple[Array, Array], windows: Window) -> tuple[Array, Array]:
    """Return the nodes of a document along u and v, spread over other windows: as many windows have the same nodes."""
    u, v = (
        _spread(knots_of(document, direction).array[..., _U].mean(axis=0), ends, count)
        for direction, ends, count in zip(Direction, breakpoints, reversed(windows), strict=True)
    )
    return u, v


def _spread(u: Array, ends: Array, windows: int) -> Array:
    """Return nodes (2 windows + 1,): of windows with these ends and these u they are every end and every middle."""
    nodes = np.empty(2 * len(u) + 1)
    nodes[::STEP], nodes[1::STEP] = ends, ends[:-1] + u * np.diff(ends)
    return np.interp(np.linspace(0, len(nodes) - 1, STEP * windows + 1), np.arange(len(nodes)), nodes)


def _moved(
    state: EditorState, text: str, begun: Document, change: NetChange, intent: Intent, *, gesture: int = 0
) -> EditorState:
    """Return the state after an edit that moves the surface, and how far it did."""
    after = with_document(state, text, change.document, intent, gesture)
    return with_message(after, motion_text(change.motion, begun))


def _rebuilt(
    state: EditorState, text: str, change: NetChange, direction: Direction, intent: Intent, *, window: int
) -> EditorState:
    """Return the state after an edit that gives the net other windows along a direction; one stays in focus."""
    before, axis = state.document, _axis(direction)
    maps: list[Renumbering] = [{k: k for k in range(count)} for count in before.control_points.shape[:2]]
    if change.origin is not None:
        maps[axis] = _inverse(change.origin)
    state = _renumbered(state, maps[0], maps[1], _with_along(state.window, direction, window))
    after = with_document(state, text, change.document, intent)
    said = motion_text(change.motion, before)
    k = 1 - axis
    if change.document.samples[k] == SAMPLES_RANGE[1]:
        said += f" It has {SAMPLES_RANGE[1]} samples along {direction.parameter}, the most there may be."
    return with_message(after, said)


def _renumbered(state: EditorState, rows: Renumbering, columns: Renumbering, window: Window) -> EditorState:
    """Return the state on a net whose rows and columns have other numbers: what is selected and in focus follows."""
    points = {(i, j): (rows[i], columns[j]) for i, j in _points(state) if rows.get(i) is not None and j in columns}
    return with_focus(_with_points(state, points), window)


def _points(state: EditorState) -> set[NetIndex]:
    """Return the points of which the state says something."""
    return {*state.selection.points, *state.put_away, state.measured_point}


def _with_points(state: EditorState, now: Mapping[NetIndex, NetIndex]) -> EditorState:
    """Return the state with points at other places of the net, without those that have none."""

    def moved(points: frozenset[NetIndex]) -> frozenset[NetIndex]:
        return frozenset(now[index] for index in points if index in now)

    points, last = moved(state.selection.points), state.selection.last
    latest = now.get(last) if last is not None else None
    return replace(
        state,
        selection=Selection(latest if latest is not None else min(points, default=None), points),
        put_away=moved(state.put_away),
        measured_point=now.get(state.measured_point, state.measured_point),
    )


def _inverse(origin: Indices) -> Renumbering:
    return {old: new for new, old in reversed(list(enumerate(origin.tolist()))) if old >= 0}


def _joint(intent: net_intents.JointSmoothed | net_intents.JointSharpened | net_intents.JointCreased) -> str:
    return f"joint {intent.joint} along {intent.direction.parameter}"


def _axis(direction: Direction) -> int:
    """Return the axis of the net, and of a window (a, b), that counts along the curves of a direction."""
    return 1 if direction is Direction.ROWS else 0


def _along(window: Window, direction: Direction) -> int:
    return window[_axis(direction)]


def _with_along(window: Window, direction: Direction, number: int) -> Window:
    return (window[0], number) if direction is Direction.ROWS else (number, window[1])
