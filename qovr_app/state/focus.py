"""The window of the net in focus: which fields look into it, and how it follows points, knots and documents."""

from __future__ import annotations

from dataclasses import replace

from qovr_app.state.editor_state import EditorState, Selection
from qovr_core import Document
from qovr_core.document import NetIndex, Window
from qovr_core.edits import CoordinatePlace, Place
from qovr_core.geometry.knots import Direction, KnotPlace
from qovr_core.geometry.windows import NET_SIZE, STEP
from qovr_core.laboratory.comparison import DEFAULT_POINT


def in_window(place: Place, window: Window) -> Place:
    """Return the place in a window (a, b) of a net that lies in it as another one does in window (0, 0)."""
    a, b = window
    if isinstance(place, CoordinatePlace):
        return replace(place, i=place.i + STEP * a, j=place.j + STEP * b)
    across, along = (a, b) if place.direction is Direction.ROWS else (b, a)
    return replace(place, curve=place.curve + STEP * across, window=place.window + along)


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


def is_net(state: EditorState) -> bool:
    """Return whether the document has more windows than one."""
    m, n = state.document.windows
    return m * n > 1


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
    return replace(state, window=window, fields=fields, knot=knot if isinstance(knot, KnotPlace) else None)


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
