"""The commands of the menu Net: windows, joints, knots of the whole net, which way it runs, another net."""

from __future__ import annotations

from collections.abc import Callable

from qovr_app.state import net_intents
from qovr_app.state.editor_state import EditorState
from qovr_app.state.focus import is_net
from qovr_app.state.intents import FormulationChosen, Intent
from qovr_app.state.names import AXES
from qovr_app.window.commands.command import Command, asking
from qovr_core.edits import knots_of
from qovr_core.formulations import Formulation
from qovr_core.geometry.knots import Direction
from qovr_core.geometry.nodes import Spacing
from qovr_core.joints import Joint
from qovr_core.structure.change import FEWEST_WHERE_CLOSED, MOST_WINDOWS

_NET, _APPEND, _WINDOW = "&Net", "&Net/&Append a window", "&Net/&Window in focus"
_JOINT, _KNOTS, _TURN = "&Net/&Joint after it", "&Net/&Knots by nodes", "&Net/&Turn"

_MEET = "Choose the interpolating formulation first (in the menu Net): windows of the others do not meet"

_SPACINGS = {
    Spacing.UNIFORM: "All knots 0.5, as if points were evenly spaced",
    Spacing.CHORD_LENGTH: "Knots as the distances of the points say",
    Spacing.CENTRIPETAL: "Knots as the roots of the points' distances say: neither loops nor overshoot",
}


_SPACING_TEXTS = {
    Spacing.UNIFORM: "&uniform",
    Spacing.CHORD_LENGTH: "&chord length",
    Spacing.CENTRIPETAL: "c&entripetal",
}


def net_commands() -> tuple[Command, ...]:
    """Return the commands of the menu Net; they act on the window in focus and the joint between it and the next."""
    both = tuple(Direction)
    return (
        Command(
            "make_interpolating",
            "&Interpolating formulation",
            asking(FormulationChosen(str(Formulation.INTERPOLATING))),
            _NET,
            tip="Choose the formulation whose windows meet, so that a net has one surface",
            is_enabled=lambda state: not _meets(state),
        ),
        *(command for direction in both for command in _appending(direction)),
        *(command for direction in both for command in _of_window(direction)),
        _extracting(),
        *(command for direction in both for command in _of_joint(direction)),
        *(_spacing(direction, spacing) for direction in both for spacing in Spacing),
        *_turning(),
        Command(
            "resample",
            "&Resample…",
            asking(net_intents.ResamplingAsked()),
            _NET,
            tip="Run another net, of more or fewer windows, through the surface",
            is_enabled=_meets,
            needs=_MEET,
        ),
    )


def _appending(direction: Direction) -> list[Command]:
    letter = direction.parameter

    def can_append(state: EditorState) -> bool:
        return _meets(state) and _has_room(state, direction) and not state.document.is_closed(direction)

    return [
        Command(
            f"append_{where}_{letter}",
            _marked(direction, f"Append a window {text} along {letter}"),
            asking(net_intents.WindowAppended(direction, at_start=at_start)),
            _APPEND,
            tip="The net goes on by two lines of points, turned about its end; no window there is moves",
            is_enabled=can_append,
            needs=f"{_MEET}; a net that closes along {letter} has no end, one of {MOST_WINDOWS} windows no room",
        )
        for where, text, at_start in (("after", "&after the last", False), ("before", "&before the first", True))
    ]


def _of_window(direction: Direction) -> list[Command]:
    letter = direction.parameter
    return [
        Command(
            f"insert_{letter}",
            _marked(direction, f"&Split the window along {letter}"),
            lambda state: net_intents.WindowInserted(direction, _window(state, direction)),
            _WINDOW,
            tip="Insert two lines of points; the others stay, and the surface nearly does",
            is_enabled=lambda state: _meets(state) and _has_room(state, direction),
            needs=f"{_MEET}; a net of {MOST_WINDOWS} windows has no room",
        ),
        Command(
            f"remove_{letter}",
            _marked(direction, f"&Join the window with the next along {letter}"),
            lambda state: net_intents.WindowRemoved(direction, _window(state, direction)),
            _WINDOW,
            tip="Remove two lines of points: what splitting a window inserted",
            is_enabled=lambda state: (
                _has_joint(state, direction)
                and not (
                    state.document.is_closed(direction)
                    and knots_of(state.document, direction).windows == FEWEST_WHERE_CLOSED
                )
            ),
            needs=f"Bring a window with another one after it along {letter} into focus; a closed net keeps two",
        ),
    ]


def _extracting() -> Command:
    return Command(
        "extract_window",
        "&Extract the window",
        lambda state: net_intents.WindowExtracted(state.window),
        _WINDOW,
        tip="Keep the window in focus alone; Undo brings the net back",
        is_enabled=is_net,
        begins_part=True,
        needs="The net is one window already",
    )


def _of_joint(direction: Direction) -> list[Command]:
    letter = direction.parameter
    where = f"the joint between this window and the next along {letter}"
    needs = f"Bring a window with another one after it along {letter} into focus"

    def asked(what: net_intents.Asked) -> Callable[[EditorState], Intent]:
        return lambda state: net_intents.JointAsked(direction, _window(state, direction), what)

    def can_be(state: EditorState, joint: Joint) -> bool:
        return _has_joint(state, direction) and _joint(state, direction) is not joint

    return [
        Command(
            f"smooth_{letter}",
            _marked(direction, f"Make {where} &smooth…"),
            asked(net_intents.Asked.SMOOTH),
            _JOINT,
            tip="One tangent plane on both sides; see first how far the surface moves",
            is_enabled=lambda state: _meets(state) and can_be(state, Joint.SMOOTH),
            begins_part=direction is Direction.COLUMNS,
            needs=f"{needs}, with a sharp joint. {_MEET}",
        ),
        Command(
            f"sharp_{letter}",
            _marked(direction, f"Make {where} s&harp"),
            lambda state: net_intents.JointSharpened(direction, _window(state, direction)),
            _JOINT,
            tip="Every curve has its own knots there; nothing moves yet",
            is_enabled=lambda state: can_be(state, Joint.SHARP),
            needs=f"{needs}, with a smooth joint",
        ),
        Command(
            f"crease_{letter}",
            _marked(direction, f"&Crease {where}…"),
            asked(net_intents.Asked.CREASE),
            _JOINT,
            tip="An edge across the surface, as sharp as is wanted",
            is_enabled=lambda state: _meets(state) and _has_joint(state, direction),
            needs=f"{needs}. {_MEET}",
        ),
    ]


def _spacing(direction: Direction, spacing: Spacing) -> Command:
    letter = direction.parameter
    return Command(
        f"knots_{spacing.replace(' ', '_')}_{letter}",
        _marked(direction, f"Knots along {letter}: {_SPACING_TEXTS[spacing]}"),
        asking(net_intents.KnotsSpaced(direction, spacing)),
        _KNOTS,
        tip=f"{_SPACINGS[spacing]}; all curves share them, and all joints along {letter} are smooth",
        is_enabled=lambda state: _meets(state) or not is_net(state),
        begins_part=direction is Direction.COLUMNS and spacing is Spacing.UNIFORM,
        needs=_MEET,
    )


def _turning() -> list[Command]:
    reversing = [
        Command(
            f"reverse_{direction.parameter}",
            _marked(direction, f"&Reverse along {direction.parameter}"),
            asking(net_intents.NetReversed(direction)),
            _TURN,
            tip="The curves run the other way; the interpolating surface is the same",
        )
        for direction in Direction
    ]
    transposing = Command(
        "transpose", "&Transpose", asking(net_intents.NetTransposed()), _TURN, tip="Rows become columns"
    )
    mirroring = [
        Command(
            f"mirror_{letter}",
            f"Mirror in &{letter}",
            asking(net_intents.NetMirrored(axis)),
            _TURN,
            tip=f"The net becomes its mirror image in {letter}, in the same box",
            begins_part=axis == 0,
        )
        for axis, letter in enumerate(AXES)
    ]
    return [*reversing, transposing, *mirroring]


def _marked(direction: Direction, text: str) -> str:
    """Return a text with the letter of its menu; of the two directions, that along u has it."""
    return text if direction is Direction.ROWS else text.replace("&", "")


def _meets(state: EditorState) -> bool:
    """Return whether the windows of the document's formulation meet along whole curves."""
    return state.document.formulation.is_continuous


def _window(state: EditorState, direction: Direction) -> int:
    """Return the number along the curves of a direction of the window in focus, and of the joint after it."""
    return state.window[1 if direction is Direction.ROWS else 0]


def _has_joint(state: EditorState, direction: Direction) -> bool:
    return _window(state, direction) < len(state.document.joints.along(direction))


def _joint(state: EditorState, direction: Direction) -> Joint:
    return state.document.joints.along(direction)[_window(state, direction)]


def _has_room(state: EditorState, direction: Direction) -> bool:
    return knots_of(state.document, direction).windows < MOST_WINDOWS
