"""What every number of the document is called: on the screen, by a screen reader, in a message, in an object name."""

from __future__ import annotations

import re
from collections.abc import Collection

from qovr_core.document import NetIndex, Window
from qovr_core.edits import CoordinatePlace, Place, Zone
from qovr_core.geometry.knots import Direction, KnotPlace
from qovr_core.geometry.windows import STEP
from qovr_core.laboratory.one_curve import PARABOLA_LETTERS

AXES = "xyz"
HEIGHT = AXES.index("z")
"""The axis along which this method shapes."""

ZONE_TITLES = {
    Zone.ROW_KNOTS: "Row-wise knots",
    Zone.COLUMN_KNOTS: "Column-wise knots",
    Zone.CONTROL_POINTS: "Control points",
}


def window_words(window: Window, windows: Window) -> str:
    """Return which window of so many there are is in focus; nothing where there is one.

    Examples
    --------
    >>> window_words((0, 1), (2, 3))
    'window 0,1 of 2 × 3'
    """
    (a, b), (m, n) = window, windows
    return f"window {a},{b} of {m} × {n}" if m * n > 1 else ""


def object_name(place: Place) -> str:
    """Return the object name of the field at a place."""
    if isinstance(place, CoordinatePlace):
        return f"{Zone.CONTROL_POINTS}.P_{place.i}_{place.j}.{AXES[place.axis]}"
    return f"{place.direction}.{place.direction.curve_name(place.curve)}.{place.letter}"


def label(place: Place, *, in_net: bool = False) -> str:
    """Return a place in one line of plain text, as messages say it; in a net, with the window along the curve."""
    if isinstance(place, CoordinatePlace):
        return f"{AXES[place.axis].upper()} of P {place.i},{place.j}"
    window = f" in window {place.window} along {place.direction.parameter}" if in_net else ""
    return f"{place.letter}_ip of {place.direction.curve_name(place.curve)}{window}"


def in_window_words(text: str) -> str:
    """Return a message in which places are called as the window calls them, and not as a document does.

    Examples
    --------
    >>> in_window_words("column_knots[2].u is 1; control_points[0][4][2] is 2")
    'v_ip of K_2 is 1; Z of P 0,4 is 2'
    """
    return _PLACE.sub(lambda found: label(_place(found), in_net=found["window"] is not None), text)


_PLACE = re.compile(
    r"\b(row_knots|column_knots)\[(\d+)\](?:\[(?P<window>\d+)\])?\.([rsutv])\b|\bcontrol_points\[(\d+)\]\[(\d+)\]\[([012])\]"
)


def _place(found: re.Match[str]) -> Place:
    family, curve, window, letter, *indices = found.groups()
    if family:
        return KnotPlace(Direction(family), int(curve), "u" if letter == "v" else letter, int(window or 0))
    i, j, axis = map(int, indices)
    return CoordinatePlace(i, j, axis)


def spoken(place: Place, *, in_net: bool = False) -> str:
    """Return a place as a screen reader can say it; in a net, with the window along the curve."""
    if isinstance(place, CoordinatePlace):
        return f"{AXES[place.axis]} of control point P {place.i} {place.j}"
    window = f" in window {place.window}" if in_net else ""
    return f"{place.letter} internal knot of curve {place.direction.letter} {place.curve}{window}"


def knot_meaning(place: KnotPlace) -> str:
    """Return what a knot does, in one sentence."""
    curve = place.direction.curve_name(place.curve)
    points = [_point(place, k) for k in range(5)]
    parameter = place.direction.parameter
    if place.name == "u":
        return f"{parameter}_ip: the parameter {parameter} at which {curve} passes through {points[2]}."
    first = PARABOLA_LETTERS.index(place.name)
    through, middle = ", ".join(points[first : first + 3]), points[first + 1]
    nth = ("first", "middle", "last")[first]
    return f"{place.name}_ip: where on the {nth} parabola, which runs through {through}, the point {middle} lies."


def _point(place: KnotPlace, k: int) -> str:
    along = k + STEP * place.window
    return f"P {place.curve},{along}" if place.direction is Direction.ROWS else f"P {along},{place.curve}"


def points_text(indices: Collection[NetIndex]) -> str:
    """Return control points as a step names them: "P 2,3", or "4 points"."""
    return "P {},{}".format(*next(iter(indices))) if len(indices) == 1 else f"{len(indices)} points"


def edit_text(places: list[Place]) -> str:
    """Return the name of the step that changes these places, as "Set s_ip of C_0..C_4" or "Move P 2,3"."""
    points = {(place.i, place.j) for place in places if isinstance(place, CoordinatePlace)}
    if points:
        return "Move control points" if len(points) > 1 else "Move P {},{}".format(*points.pop())
    knots = [place for place in places if isinstance(place, KnotPlace)]
    parts = []
    for direction in Direction:
        family = [place for place in knots if place.direction is direction]
        curves = sorted({place.curve for place in family})
        names = {place.letter for place in family}
        if not family:
            continue
        if len(names) > 1:
            return "Set knots"
        letter = direction.letter
        span = f"{letter}_{curves[0]}" + (f"..{letter}_{curves[-1]}" if len(curves) > 1 else "")
        parts.append(f"{names.pop()}_ip of {span}")
    return "Set " + " and ".join(parts)
