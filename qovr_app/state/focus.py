"""The window of the net in focus: which fields look into it, and how it follows points, knots and documents."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from functools import lru_cache
from typing import overload

from qovr_app.state.editor_state import EditorState, Focus, Selection
from qovr_app.state.renumbering import Renumbering
from qovr_core import Document, DocumentError
from qovr_core.document import NetIndex, Window
from qovr_core.edits import CoordinatePlace, Place, Zone, check_points, extract_window, knots_of
from qovr_core.geometry.knots import KNOT_NAMES, Direction, KnotPlace
from qovr_core.geometry.windows import NET_SIZE, STEP
from qovr_core.laboratory.comparison import DEFAULT_POINT


@overload
def in_window(place: KnotPlace, window: Window) -> KnotPlace: ...


@overload
def in_window(place: Place, window: Window) -> Place: ...


def in_window(place: Place, window: Window) -> Place:
    """Return the place in a window (a, b) of a net that lies in it as another one does in window (0, 0)."""
    if isinstance(place, CoordinatePlace):
        i, j = point_in_window((place.i, place.j), window)
        return replace(place, i=i, j=j)
    a, b = window
    across, along = (a, b) if place.direction is Direction.ROWS else (b, a)
    return replace(place, curve=place.curve + STEP * across, window=place.window + along)


def check_places(document: Document, places: Iterable[Place]) -> None:
    """Raise DocumentError where a net has no such numbers."""
    for place in places:
        if isinstance(place, CoordinatePlace):
            check_points(document, [(place.i, place.j)])
            continue
        knots = knots_of(document, place.direction)
        if not (0 <= place.curve < len(knots) and 0 <= place.window < knots.windows):
            last = replace(place, curve=len(knots) - 1, window=knots.windows - 1)
            raise DocumentError("the knot", place.text(place.window + 1), f"one of a net whose last is {last}")


def opposite(window: Window) -> Window:
    """Return what brings a place of a window back to window (0, 0)."""
    return -window[0], -window[1]


def point_in_window(index: NetIndex, window: Window) -> NetIndex:
    """Return the point (i, j) of a net that lies in a window as another one does in window (0, 0)."""
    (i, j), (a, b) = index, window
    return i + STEP * a, j + STEP * b


def has_window(document: Document, window: Window) -> bool:
    """Return whether a net has a window."""
    return all(0 <= at < count for at, count in zip(window, document.windows, strict=True))


def has_point(window: Window, index: NetIndex) -> bool:
    """Return whether a window holds a control point."""
    return all(0 <= k - STEP * w < NET_SIZE for k, w in zip(index, window, strict=True))


def nearest_window(document: Document, window: Window, place: Place | NetIndex) -> Window:
    """Return the window that holds a point or a knot and lies nearest to another one."""
    rows, columns = document.windows
    a, b = window
    if isinstance(place, KnotPlace):
        if place.direction is Direction.ROWS:
            return _nearest(a, place.curve, rows), place.window
        return place.window, _nearest(b, place.curve, columns)
    i, j = (place.i, place.j) if isinstance(place, CoordinatePlace) else place
    return _nearest(a, i, rows), _nearest(b, j, columns)


def _nearest(window: int, line: int, windows: int) -> int:
    """Return which of the windows along a direction that hold a line of points is nearest to one."""
    first = max(-((NET_SIZE - 1 - line) // STEP), 0)
    last = min(line // STEP, windows - 1)
    return min(max(window, first), last)


def places_in(zone: Zone, window: Window) -> list[Place]:
    """Return every place of a zone in a window."""
    lines = range(NET_SIZE)
    if zone is Zone.CONTROL_POINTS:
        return [in_window(CoordinatePlace(i, j, axis), window) for i in lines for j in lines for axis in range(3)]
    direction = Direction(zone.value)
    return [in_window(KnotPlace(direction, curve, name), window) for curve in lines for name in KNOT_NAMES]


def focused_document(state: EditorState) -> Document | None:
    """Return what is shown of the window in focus, as a document of its own; the same object while it is the same."""
    shown = state.shown_document
    return shown if shown is None or shown.is_one_window else _alone(shown, window_shown(state))


def window_shown(state: EditorState) -> Window:
    """Return the window of the surface in the view that is in focus: of an older one of another shape, the nearest."""
    (a, b), document = state.window, state.shown_document
    m, n = state.document.windows if document is None else document.windows
    return min(a, m - 1), min(b, n - 1)


@lru_cache(maxsize=2)
def _alone(document: Document, window: Window) -> Document:
    return extract_window(document, window)


def focus_in_window(state: EditorState) -> Focus:
    """Return the knot or point that is turned to, as the window in focus counts it; None where it lies elsewhere."""
    focus, back = state.focus, opposite(state.window)
    if focus is None or isinstance(focus, KnotPlace):
        return focus and in_window(focus, back)
    return point_in_window(focus, back) if has_point(state.window, focus) else None


def measured_in_window(state: EditorState) -> NetIndex:
    """Return the point that is measured, as the window in focus counts it: its middle where it lies elsewhere."""
    point = state.measured_point
    return point_in_window(point, opposite(state.window)) if has_point(state.window, point) else DEFAULT_POINT


def is_net(state: EditorState) -> bool:
    """Return whether the document has more windows than one."""
    return not state.document.is_one_window


def beside(state: EditorState, step: Window) -> Window | None:
    """Return the window so many windows from the one in focus; round the seam where the net is closed, else None.

    Examples
    --------
    >>> from qovr_app.state.display import DisplaySettings
    >>> from qovr_app.state.editor_state import DocumentFile, first_state
    >>> from qovr_core.presets import preset
    >>> state = first_state(preset("fig5").document, DocumentFile("fig5"), DisplaySettings())
    >>> beside(state, (0, 0)), beside(state, (0, 1))
    ((0, 0), None)
    """
    document, found = state.document, []
    along = Direction.COLUMNS, Direction.ROWS
    for at, by, count, direction in zip(state.window, step, document.windows, along, strict=True):
        if not (0 <= at + by < count or document.is_closed(direction)):
            return None
        found.append((at + by) % count)
    return found[0], found[1]


def with_focus(state: EditorState, window: Window) -> EditorState:
    """Return the state with another window in focus; the fields that had the keyboard stand at its numbers."""
    if window == state.window:
        return state
    by = window[0] - state.window[0], window[1] - state.window[1]
    fields = {zone: in_window(place, by) for zone, place in state.fields.items()}
    knot = None if state.knot is None else in_window(state.knot, by)
    return replace(state, window=window, fields=fields, knot=knot)


def renumbered(state: EditorState, renumbering: Renumbering) -> EditorState:
    """Return the state on a net whose rows and columns have other numbers: points and focus follow."""

    def moved(points: frozenset[NetIndex]) -> frozenset[NetIndex]:
        return frozenset(now for index in points if (now := renumbering.point(index)) is not None)

    points, last = moved(state.selection.points), state.selection.last
    latest = None if last is None else renumbering.point(last)
    state = replace(
        state,
        selection=Selection(latest or min(points, default=None), points),
        put_away=moved(state.put_away),
        measured_point=renumbering.point(state.measured_point) or DEFAULT_POINT,
    )
    return with_focus(state, renumbering.window(state.window) or state.window)


def fitted(state: EditorState) -> EditorState:
    """Return the state on a net of another shape: without what has no place there, and in the nearest window."""
    m, n = state.document.windows
    a, b = state.window
    state = with_focus(state, (min(a, m - 1), min(b, n - 1)))
    rows, columns, _ = state.document.control_points.shape

    def exists(index: NetIndex) -> bool:
        return bool(index[0] < rows and index[1] < columns)

    points = frozenset(filter(exists, state.selection.points))
    last = state.selection.last
    if last not in points:
        last = min(points, default=None)
    return replace(
        state,
        selection=Selection(last, points),
        put_away=frozenset(filter(exists, state.put_away)),
        measured_point=state.measured_point if exists(state.measured_point) else DEFAULT_POINT,
    )
