"""The net's structure in the next state: what is asked of windows and joints, and what follows them there."""

from __future__ import annotations

import numpy as np

from qovr_app.state import net_intents
from qovr_app.state.document_steps import with_document
from qovr_app.state.editor_state import EditorState, with_message
from qovr_app.state.focus import with_focus
from qovr_app.state.intents import Intent
from qovr_app.state.names import AXES
from qovr_app.state.readouts import motion_text
from qovr_app.state.renumbering import Renumbering, lines_kept, lines_of_origin
from qovr_core import Document, QovrError, build_patch
from qovr_core.arrays import Array
from qovr_core.checks import SAMPLES_RANGE
from qovr_core.document import Window
from qovr_core.edits import extract_window, knots_of
from qovr_core.geometry.knots import KNOT_NAMES, Direction
from qovr_core.geometry.windows import NET_SIZE, STEP
from qovr_core.structure.change import NetChange, check_continuous
from qovr_core.structure.joints import crease, make_sharp, make_smooth, space_knots
from qovr_core.structure.resampling import resample
from qovr_core.structure.turning import mirror_in_space, reverse, transpose
from qovr_core.structure.windows import append_window, insert_pair, remove_pair

_U = KNOT_NAMES.index("u")


def window_inserted(state: EditorState, intent: net_intents.WindowInserted) -> EditorState:
    change = insert_pair(state.document, intent.direction, intent.window)
    text = f"Split window {intent.window} along {intent.direction.parameter}"
    return _rebuilt(state, text, change, intent.direction, intent)


def window_removed(state: EditorState, intent: net_intents.WindowRemoved) -> EditorState:
    direction, joint = intent.direction, intent.joint
    change = remove_pair(state.document, direction, joint)
    after = (joint + 1) % knots_of(state.document, direction).windows
    return _rebuilt(state, f"Join windows {joint} and {after} along {direction.parameter}", change, direction, intent)


def window_appended(state: EditorState, intent: net_intents.WindowAppended) -> EditorState:
    change = append_window(state.document, intent.direction, at_start=intent.at_start)
    where = "before the first" if intent.at_start else "after the last"
    text = f"Append a window {where} along {intent.direction.parameter}"
    return _rebuilt(state, text, change, intent.direction, intent)


def window_extracted(state: EditorState, intent: net_intents.WindowExtracted) -> EditorState:
    _check_all_set(state)
    document = extract_window(state.document, intent.window)
    rows, columns = ({STEP * at + k: k for k in range(NET_SIZE)} for at in intent.window)
    text = "Extract window {},{}".format(*intent.window)
    state = with_focus(state, intent.window)
    after = with_document(state, text, document, intent, renumbering=Renumbering(rows, columns))
    return with_message(after, "The window is a net of its own, and T is made anew.", is_of_step=True)


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
    _check_all_set(state)
    document, direction = state.document, intent.direction
    lines, axis = lines_kept(document), _axis(direction)
    lines[axis] = {k: len(lines[axis]) - 1 - k for k in lines[axis]}
    text = f"Reverse along {direction.parameter}"
    after = with_document(
        state, text, reverse(document, direction), intent, renumbering=Renumbering(lines[0], lines[1])
    )
    if document.formulation.is_continuous:
        said = f"The same surface runs the other way along {direction.parameter}."
    else:
        said = f"The {document.formulation} surface is another one from the other end."
    return with_message(after, said, is_of_step=True)


def net_transposed(state: EditorState, intent: net_intents.NetTransposed) -> EditorState:
    _check_all_set(state)
    rows, columns = lines_kept(state.document)
    renumbering = Renumbering(rows, columns, is_transposed=True)
    after = with_document(state, "Transpose the net", transpose(state.document), intent, renumbering=renumbering)
    return with_message(after, "Rows and columns, u and v have changed places.", is_of_step=True)


def net_mirrored(state: EditorState, intent: net_intents.NetMirrored) -> EditorState:
    text = f"Mirror the net in {AXES[intent.axis]}"
    after = with_document(state, text, mirror_in_space(state.document, intent.axis), intent)
    return with_message(after, f"The net is its mirror image in {AXES[intent.axis]}.", is_of_step=True)


def net_resampled(state: EditorState, intent: net_intents.NetResampled) -> EditorState:
    _check_all_set(state)
    begun = state.document_before(intent.gesture)
    check_continuous(begun.formulation, "Resampling")
    patch = build_patch(begun)
    nodes = None if intent.is_even else _parts_of_nodes(begun, patch.breakpoints, intent.windows)
    change = resample(patch, intent.windows, nodes, closed=begun.closed, samples=begun.samples)
    return _moved(state, "Resample the net", begun, change, intent, gesture=intent.gesture)


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
    return with_message(after, motion_text(change.motion, begun), is_of_step=True)


def _rebuilt(state: EditorState, text: str, change: NetChange, direction: Direction, intent: Intent) -> EditorState:
    """Return the state after an edit that gives the net other windows along a direction."""
    _check_all_set(state)
    before, lines = state.document, lines_kept(state.document)
    if change.origin is not None:
        lines[_axis(direction)] = lines_of_origin(before, direction, change.origin)
    after = with_document(state, text, change.document, intent, renumbering=Renumbering(lines[0], lines[1]))
    said = motion_text(change.motion, before)
    if change.document.samples[1 - _axis(direction)] == SAMPLES_RANGE[1]:
        said += f" It has {SAMPLES_RANGE[1]} samples along {direction.parameter}, the most there may be."
    return with_message(after, said, is_of_step=True)


def _joint(intent: net_intents.JointSmoothed | net_intents.JointSharpened | net_intents.JointCreased) -> str:
    return f"joint {intent.joint} along {intent.direction.parameter}"


def _check_all_set(state: EditorState) -> None:
    """Raise QovrError where numbers wait in fields whose rows and columns would be other ones."""
    if state.has_pending or state.texts:
        raise QovrError("Numbers are typed that are not set; set them, or get the values back, before the net changes")


def _axis(direction: Direction) -> int:
    """Return the axis of the net, and of a window (a, b), that counts along the curves of a direction."""
    return 1 if direction is Direction.ROWS else 0
