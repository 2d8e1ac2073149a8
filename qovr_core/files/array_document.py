"""A document as the named arrays of ``.npz`` and ``.mat``, checked entry by entry."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from qovr_core.arrays import Array
from qovr_core.checks import LARGEST_MAGNITUDE, Verbatim, checked_knot, checked_number, described
from qovr_core.document import Document
from qovr_core.errors import LONGEST_QUOTE, DocumentError, FileError, one_line
from qovr_core.geometry.knots import KNOT_NAMES, Direction
from qovr_core.geometry.windows import NET_SIZE, window_count
from qovr_core.joints import Joint, Joints, joint_count

INPUTS = ("control_points", "row_knots", "column_knots", "formulation", "u", "v")
"""The arrays that make a document; the samples are the lengths of ``u`` and ``v``."""

NET_INPUTS = ("smooth_u", "smooth_v", "closed")
"""What a net of more than one window may have besides: 1 where a joint is smooth, and for u and v whether it is closed.
Without them its joints are as smooth as the knots allow."""

LARGEST_INPUT = 1_000_000
"""Bytes; the longest input, a net of 203 x 203 points, takes 990 kB."""


def document_from_arrays(arrays: Mapping[str, Any], path: Path) -> Document:
    """Return the document that named arrays hold.

    Raises
    ------
    FileError : an array is missing, of another shape or kind, or holds a value that a document cannot hold
    """
    try:
        for name in INPUTS:
            if name not in arrays:
                raise DocumentError(name, "missing", "the arrays " + ", ".join(INPUTS))
        net = _net(arrays["control_points"])
        closed = _flags(arrays, "closed", len(Direction))
        is_closed = dict(zip(Direction, closed or (False, False), strict=True))
        return Document(
            control_points=net,
            row_knots=_knots(arrays["row_knots"], Direction.ROWS, net),
            column_knots=_knots(arrays["column_knots"], Direction.COLUMNS, net),
            formulation=_text(arrays["formulation"]),
            samples=(np.size(arrays["u"]), np.size(arrays["v"])),
            joints=_joints(arrays, net, is_closed),
            closed=[direction.parameter for direction in Direction if is_closed[direction]],
        )
    except DocumentError as error:
        raise FileError(f"{path}: {error}") from error


def _net(value: Any) -> Array:
    array = np.asarray(value)
    if array.ndim != 3 or array.shape[2] != 3 or min(array.shape[:2]) < NET_SIZE:
        raise _other_shape("control_points", value, f"{NET_SIZE} x {NET_SIZE} x 3, or more rows and columns")
    net = _numbers(value, "control_points", array.shape)
    for indices in np.argwhere(~(np.abs(net) <= LARGEST_MAGNITUDE)).tolist():
        checked_number(array[tuple(indices)].item(), _place("control_points", indices))
    return net


def _knots(value: Any, direction: Direction, net: Array) -> Array:
    """Return the knots of a direction as (curves, windows, 4)."""
    rows, columns = net.shape[:2]
    curves, points = (rows, columns) if direction is Direction.ROWS else (columns, rows)
    shape = (curves, window_count(points), len(KNOT_NAMES))
    is_one_window = rows == columns == NET_SIZE
    knots = _numbers(value, direction, (NET_SIZE, len(KNOT_NAMES)) if is_one_window else shape)
    for indices in np.argwhere(~((knots > 0) & (knots < 1))).tolist():
        checked_knot(np.asarray(value)[tuple(indices)].item(), _place(direction, indices))
    return knots.reshape(shape)


def _joints(arrays: Mapping[str, Any], net: Array, is_closed: Mapping[Direction, bool]) -> Joints | None:
    rows, columns = net.shape[:2]
    counts = (
        joint_count(window_count(points), is_closed[direction])
        for direction, points in ((Direction.ROWS, columns), (Direction.COLUMNS, rows))
    )
    along_u, along_v = (_flags(arrays, name, count) for name, count in zip(NET_INPUTS, counts, strict=False))
    if along_u is None or along_v is None:
        return None
    u, v = (tuple(Joint.SMOOTH if is_smooth else Joint.SHARP for is_smooth in along) for along in (along_u, along_v))
    return Joints(u, v)


def _flags(arrays: Mapping[str, Any], name: str, count: int) -> list[bool] | None:
    """Return so many numbers, each 0 or 1, as flags; None where there is no such array."""
    if name not in arrays:
        return None
    array = np.asarray(arrays[name])
    if array.size != count or (count and array.dtype.kind not in "bfiu"):
        raise _other_shape(name, arrays[name], str(count))
    flags: list[Any] = array.ravel().tolist()
    for k, flag in enumerate(flags):
        if flag not in (0, 1):
            raise DocumentError(_place(name, [k]), described(flag), "0 or 1")
    return [bool(flag) for flag in flags]


def _numbers(value: Any, name: str, shape: tuple[int, ...]) -> Array:
    array = np.asarray(value)
    if array.shape != shape or array.dtype.kind not in "fiu":
        raise _other_shape(name, value, " x ".join(map(str, shape)))
    return array.astype(np.float64)


def _other_shape(name: str, value: Any, expected: str) -> DocumentError:
    array = np.asarray(value)
    kind = f"{array.dtype} in {' x '.join(map(str, array.shape)) or 'no dimension'}"
    found = described(value) if isinstance(value, Verbatim) else one_line(kind, LONGEST_QUOTE)
    return DocumentError(name, found, f"numbers in {expected}")


def _place(name: str, indices: list[int]) -> str:
    return name + "".join(f"[{k}]" for k in indices)


def _text(value: Any) -> Any:
    """Return the text of an array of one string; what is no text is told by the document's own check."""
    array = np.asarray(value)
    if isinstance(value, Verbatim):
        return value
    is_text = array.dtype.kind == "U" and array.size == 1
    return str(array.reshape(-1)[0]) if is_text else Verbatim(described(array))
