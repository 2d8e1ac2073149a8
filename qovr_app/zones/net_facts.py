"""What is said of a net as a whole: its windows, its points, and the joints of the window in focus."""

from __future__ import annotations

from qovr_core import Document
from qovr_core.document import Window
from qovr_core.geometry.knots import Direction
from qovr_core.geometry.windows import NET_SIZE, STEP
from qovr_core.joints import Joint


def structure_of(document: Document) -> tuple[object, ...]:
    """Return what is said of a net as a whole, and which no move of a point or a knot changes."""
    return document.windows, document.joints, document.closed, document.formulation


def joint_before(document: Document, direction: Direction, window: int) -> Joint | None:
    """Return the joint at which a window begins along the curves of a direction; None where the net begins there."""
    joints = document.joints.along(direction)
    if not window and not document.is_closed(direction):
        return None
    return joints[window - 1]


def joint_after(document: Document, direction: Direction, window: int) -> Joint | None:
    """Return the joint at which a window ends along the curves of a direction; None where the net ends there."""
    joints = document.joints.along(direction)
    return joints[window] if window < len(joints) else None


def net_text(document: Document) -> str:
    """Return the size of a net, as "7 × 9 points, 2 × 3 windows"."""
    (rows, columns, _), (m, n) = document.control_points.shape, document.windows
    closed = f", closed along {' and '.join(document.closed)}" if document.closed else ""
    return f"{rows} × {columns} points, {m} × {n} windows{closed}"


def joint_line(direction: Direction, joint: int) -> str:
    """Return the line of points on which a joint lies, as "column 3" for the first along u."""
    return f"{'column' if direction is Direction.ROWS else 'row'} {STEP * (joint + 1) + 1}"


def joints_text(document: Document, window: Window) -> str:
    """Return the joints of a window, as "joints smooth at u = 0, u = 1, sharp at v = 0", or that all are alike.

    Examples
    --------
    >>> net = [[[j, i, 0] for j in range(9)] for i in range(5)]
    >>> net_text(Document(net)), joints_text(Document(net), (0, 1))
    ('5 × 9 points, 1 × 3 windows', 'all joints smooth')
    """
    a, b = window
    found = {
        f"{direction.parameter} = {end}": joint
        for direction, along in ((Direction.ROWS, b), (Direction.COLUMNS, a))
        for end, find in enumerate((joint_before, joint_after))
        if (joint := find(document, direction, along)) is not None
    }
    if len(found) > 1 and len(set(found.values())) == 1:
        return f"all joints {found.popitem()[1]}"
    alike = {kind: ", ".join(place for place, joint in found.items() if joint is kind) for kind in Joint}
    return "joints " + ", ".join(f"{kind} at {places}" for kind, places in alike.items() if places)


def net_note(document: Document, window: Window) -> str:
    """Return the size of a net and the joints of a window, or that its windows do not meet."""
    if not document.formulation.is_continuous:
        return f"{net_text(document)}; under {document.formulation} the windows do not meet: choose interpolating"
    a, b = window
    return f"{net_text(document)}; window {a},{b}: {joints_text(document, window)}"


def points_text(window: Window) -> str:
    """Return which rows and columns of points a window holds."""
    (i, j), more = (STEP * k for k in window), NET_SIZE - 1
    return f"rows {i} to {i + more}, columns {j} to {j + more}"
