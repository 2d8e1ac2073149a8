"""The commands that select control points, and move those that are selected."""

from __future__ import annotations

import time
from collections.abc import Callable, Collection
from itertools import product

from qovr_app.state import point_intents, requests
from qovr_app.state.editor_state import EditorState
from qovr_app.state.intents import Intent
from qovr_app.state.looking_intents import Selected
from qovr_app.state.tools import nudge_step
from qovr_app.window.commands.command import Command, asking
from qovr_core.document import NetIndex
from qovr_core.geometry.knots import Direction
from qovr_core.net_edits import Align, Flatten, NetEdit, Plane, Smooth
from qovr_core.symmetry import Source

_SELECT, _POINTS, _SYMMETRY, _NUDGE = "&Edit/Se&lect", "&Points", "&Points/Make s&ymmetric", "&Points/&Nudge"

NEEDS_ONE = "Select a control point first"

_EDITS: dict[str, tuple[NetEdit, str, str]] = {
    "flatten_height": (Flatten(Plane.HEIGHT), "&Flatten to one height", "Give the selected points their mean z"),
    "flatten_plane": (Flatten(Plane.BEST), "Flatten to the &best plane", "Bring the selected points into one plane"),
    "align_x": (Align(0), "Align &x", "Give the selected points the x of the one picked last"),
    "align_y": (Align(1), "Align y", "Give the selected points the y of the one picked last"),
    "align_z": (Align(2), "Align &z", "Give the selected points the z of the one picked last"),
    "smooth_points": (Smooth(), "&Smooth", "Bring the selected points half the way to the mean of their neighbours"),
}
_PARTS = ("flatten_height", "align_x", "smooth_points")
"""The commands before which the menu has a line."""

_SOURCES = {
    Source.FIRST: ("from the first side", "The side of the low indices stays as it is"),
    Source.LAST: ("from the last side", "The side of the high indices stays as it is"),
    Source.MEAN: ("by the mean", "Both sides become their mean"),
}

_NUDGES: dict[str, tuple[str, int, int]] = {
    "nudge_left": ("Alt+Left", 0, -1),
    "nudge_right": ("Alt+Right", 0, 1),
    "nudge_back": ("Alt+Down", 1, -1),
    "nudge_on": ("Alt+Up", 1, 1),
    "nudge_down": ("Alt+PgDown", 2, -1),
    "nudge_up": ("Alt+PgUp", 2, 1),
}
"""The keys that move the selected points by one step, along which axis and which way."""


def selection_commands() -> tuple[Command, ...]:
    """Return the commands that select."""
    return (
        Command("select_all", "&All points", lambda state: _picking(state, _all(state)), _SELECT, "Ctrl+A"),
        Command(
            "select_invert",
            "&Invert",
            lambda state: _picking(state, _all(state) - state.selection.points),
            _SELECT,
            "Ctrl+I",
            "Select what is not selected, and nothing else",
        ),
        _more("select_rows", "&Rows", "Select all points in the rows of the selected ones", 0),
        _more("select_columns", "&Columns", "Select all points in the columns of the selected ones", 1),
        Command("select_none", "&None", asking(Selected(None)), _SELECT, "Ctrl+Shift+A"),
    )


def point_commands() -> tuple[Command, ...]:
    """Return the commands that move what is selected."""
    transform = Command(
        "transform_points",
        "&Move, scale, rotate…",
        asking(requests.TransformAsked()),
        _POINTS,
        "Ctrl+M",
        "Move the selected points by exact numbers, scale and rotate them",
        is_enabled=has_selection,
        needs=NEEDS_ONE,
    )
    edits = (
        Command(
            name, text, _editing(edit), _POINTS, None, tip, is_enabled=has_selection, needs=NEEDS_ONE,
            begins_part=name in _PARTS,
        )
        for name, (edit, text, tip) in _EDITS.items()
    )  # fmt: skip
    return (transform, *edits, *_nudges(), *_symmetries())


def repeat_command() -> Command:
    """Return the command that does the last edit of points again."""
    return Command(
        "repeat",
        "Rep&eat",
        lambda state: point_intents.PointsEdited(_last_edit(state) or Smooth(), state.selection.indices),
        "&Edit",
        "F4",
        "Do the last edit of points again, with what is selected now",
        is_enabled=lambda state: has_selection(state) and _last_edit(state) is not None,
        noun=lambda state: getattr(_last_edit(state), "verb", ""),
        needs="Move, scale, rotate, flatten, align or smooth points first, and select some",
    )


def _more(name: str, text: str, tip: str, axis: int) -> Command:
    def picking(state: EditorState) -> Intent:
        lines = {index[axis] for index in state.selection.points}
        return _picking(state, {index for index in _all(state) if index[axis] in lines})

    return Command(name, text, picking, _SELECT, None, tip, is_enabled=has_selection, needs=NEEDS_ONE)


def _nudges() -> list[Command]:
    def nudging(axis: int, way: int) -> Callable[[EditorState], Intent]:
        def nudge(state: EditorState) -> Intent:
            step = [0.0, 0.0, 0.0]
            step[axis] = way * nudge_step(state.tools, state.document)
            x, y, z = step
            return point_intents.PointsNudged(state.selection.indices, (x, y, z), time.monotonic())

        return nudge

    return [
        Command(
            name, f"{'xyz'[axis]} {'+' if way > 0 else '−'} one step", nudging(axis, way), _NUDGE, key,
            "Move the selected points by one step; quickly one after the other is one undo step",
            is_enabled=has_selection, needs=NEEDS_ONE,
        )
        for name, (key, axis, way) in _NUDGES.items()
    ]  # fmt: skip


def _symmetries() -> list[Command]:
    planes = Command(
        "symmetry_planes",
        "&Planes of symmetry…",
        asking(requests.SymmetryAsked()),
        _SYMMETRY,
        tip="Choose the axis and the place of the planes in which rows and columns mirror each other",
        begins_part=True,
    )
    ways = [
        Command(
            f"symmetric_{across.name.lower()}_{source}",
            f"Across {across.name.lower()}, {text}",
            asking(point_intents.MadeSymmetric(across, source)),
            _SYMMETRY,
            None,
            tip,
            begins_part=source is Source.FIRST and across is Direction.ROWS,
        )
        for across in (Direction.COLUMNS, Direction.ROWS)
        for source, (text, tip) in _SOURCES.items()
    ]
    return [*ways, planes]


def has_selection(state: EditorState) -> bool:
    return bool(state.selection.points)


def _all(state: EditorState) -> set[NetIndex]:
    rows, columns, _ = state.document.control_points.shape
    return set(product(range(rows), range(columns))) - state.put_away


def _picking(state: EditorState, points: Collection[NetIndex]) -> Intent:
    """Return what selects these points; the one picked last stays so where it is among them."""
    if not points:
        return Selected(None)
    last = state.selection.last
    first = last if last in points and last is not None else min(points)
    return Selected(first, tuple(sorted(set(points) - {first})))


def _editing(edit: NetEdit) -> Callable[[EditorState], Intent]:
    return lambda state: point_intents.PointsEdited(edit, state.selection.indices)


def _last_edit(state: EditorState) -> NetEdit | None:
    """Return the last edit of points that was done and not taken back."""
    done = reversed(state.history.steps[: state.history.index])
    return next((step.edit for step in done if step.edit is not None), None)
