"""The five steps of the tour: what each says, when it is done, and what does it for somebody who only looks."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from qovr_app.state.editor_state import EditorState
from qovr_app.state.intents import Configured, Intent, LiveSwitched, PointsMoved, ZoneSet
from qovr_app.state.knot_intents import KnotsSet
from qovr_app.state.looking_intents import DisplayChosen, Selected
from qovr_app.state.requests import ExportAsked
from qovr_core.document import NetIndex
from qovr_core.edits import Zone
from qovr_core.fields import Field
from qovr_core.geometry.knots import Direction

_RAISED = 0.5
"""Part of the net's height by which the tour pulls its point: much, and still in sight."""

_KNOT, _OTHER_KNOT = 0.7, 0.35
"""Away from the middle, where every preset of the paper begins, to either side."""


@dataclass(frozen=True)
class TourStep:
    """One step.

    Parameters
    ----------
    text : what is to be done, and what it is good for
    target : the object name of the part that it speaks of
    part : the zone that has to be seen for it, or the view
    is_done : whether it was done, of the state in which it began and the present one
    doing : what does it, of the state
    """

    text: str
    target: str
    part: str
    is_done: Callable[[EditorState, EditorState], bool]
    doing: Callable[[EditorState], tuple[Intent, ...]]


def _middle(state: EditorState) -> NetIndex:
    rows, columns = state.document.control_points.shape[:2]
    return rows // 2, columns // 2


def _pull(state: EditorState) -> tuple[Intent, ...]:
    index, heights = _middle(state), state.document.control_points[..., 2]
    return Selected(index), PointsMoved((index,), ((0.0, 0.0, _RAISED * float(np.ptp(heights))),))


def _turn(value: float) -> Callable[[EditorState], tuple[Intent, ...]]:
    def doing(state: EditorState) -> tuple[Intent, ...]:
        _, along_rows = state.window
        return (KnotsSet(Direction.ROWS, _middle(state)[0], along_rows, "u", value),)

    return doing


def _stage(state: EditorState) -> tuple[Intent, ...]:
    return LiveSwitched(is_live=False), *_turn(_OTHER_KNOT)(state), ZoneSet(Zone.ROW_KNOTS, {}), Configured()


def _is_staged(before: EditorState, now: EditorState) -> bool:
    return not now.is_live and not now.is_stale and now.evaluation is not before.evaluation


TOUR = (
    TourStep(
        "Pull: take a control point in the view and drag it up. Only its height changes, until X, Y or Z is tapped.",
        "view_frame",
        "view",
        lambda before, now: now.document.control_points is not before.document.control_points,
        _pull,
    ),
    TourStep(
        f"Knots: give the row-wise curves another u, typed or with the slider below: say {_KNOT}. "
        "A knot says where a point lies on its curve.",
        "zone.row_knots",
        Zone.ROW_KNOTS,
        lambda before, now: now.document.row_knots != before.document.row_knots,
        _turn(_KNOT),
    ),
    TourStep(
        "In stages, as in the paper: switch Live off, type a number, press Set Values, then Configure QOVR Surface. "
        "Get Values brings back what is set.",
        "surface.configure",
        "surface",
        _is_staged,
        _stage,
    ),
    TourStep(
        "Colours: choose a curvature under Colour by, over the view. The bar beside the surface says what they mean.",
        "view_bar",
        "view",
        lambda before, now: now.display.colour_by != before.display.colour_by,
        lambda _state: (DisplayChosen("colour_by", Field.GAUSSIAN.name),),
    ),
    TourStep(
        "Export Data: the exact surface for CAD, a mesh, or tables; each format says what it keeps and loses.",
        "surface.export",
        "surface",
        lambda _before, _now: False,
        lambda _state: (ExportAsked(),),
    ),
)
