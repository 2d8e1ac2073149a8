"""What the probe says: a mark on the surface, and a table in the corner that never moves."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterable, Iterator

import numpy as np

from qovr_app.view3d.painter.note import plate
from qovr_app.view3d.painter.text import SMALL, lettered, plain, text_size, with_subscripts
from qovr_app.view3d.scene.camera import Size
from qovr_app.view3d.scene.frame import Frame
from qovr_app.view3d.scene.marks import Box, Discs, Ink, Mark, Pen
from qovr_app.view3d.scene.picture import Picture
from qovr_app.view3d.scene.probing import Parameters, Reading, reading_at
from qovr_core.number_texts import significant_text

_CORNER = (10.0, 34.0)
"""Below the caption that tells two viewports apart."""

_PAD, _ROW, _LABEL, _COLUMN = 8.0, 16.0, 62.0, 68.0
_GAP = 8.0
_DIGITS, _MOST_DIGITS = 5, 16
_COORDINATES = "x, y, z"
_RING = 5.0

Rows = list[tuple[str, tuple[float, ...]]]


def readout_rows(reading: Reading) -> Rows:
    """Return what each line says: names, the letters after ``_`` being a subscript, and their numbers."""
    rows: Rows = [] if reading.window is None else [("window", reading.window)]
    rows += [
        ("u, v", (reading.u, reading.v)),
        (_COORDINATES, tuple(reading.point.tolist())),
        ("normal", tuple(reading.normal.tolist())),
    ]
    of_curvature = [(field.symbol, value) for field, value in reading.curvatures.items()]
    for (first, a), (second, b) in zip(of_curvature[::2], of_curvature[1::2], strict=True):
        rows.append((f"{first}, {second}", (a, b)))
    return rows + [(field.symbol, (value,)) for field, value in reading.others.items()]


def readout_text(reading: Reading) -> str:
    """Return a reading for the clipboard: a name and its numbers a line, at full precision, between tabs."""
    lines = ("\t".join([name.replace("_", ""), *map(repr, numbers)]) for name, numbers in readout_rows(reading))
    return "".join(f"{line}\n" for line in lines)


def readout(picture: Picture, probed: Parameters, size: Size) -> Iterator[Mark]:
    """Yield the mark and the table of the point of the surface that is probed."""
    (u, v), scene, theme = probed, picture.scene, picture.theme
    x, y, _ = picture.camera.project(scene.patch.points([u], [v])[0, 0], size).tolist()
    if math.isfinite(x):
        for colour, width in ((theme.rim, 4.0), (theme.ink, 1.6)):
            yield Discs(np.array([[x, y]]), _RING, Pen(Ink(colour), width), None)
    rows = readout_rows(reading_at(scene, probed, picture.settings.colour_by))
    texts = [
        [_number(*each) for each in zip(numbers, _digits(name, scene.frame), strict=False)] for name, numbers in rows
    ]
    widths = [max(_COLUMN, *(text_size(plain(text), SMALL)[0] + _GAP for text in column)) for column in _columns(texts)]
    left, top = _CORNER
    yield plate(Box(left, top, 2 * _PAD + _LABEL + sum(widths), 2 * _PAD + len(rows) * _ROW), theme)
    for k, ((name, _), numbers) in enumerate(zip(rows, texts, strict=True)):
        middle = top + _PAD + (k + 0.5) * _ROW
        yield lettered(with_subscripts(name), (left + _PAD, middle), (0, 0.5), theme.quiet_ink)
        for text, right in zip(numbers, itertools.accumulate(widths), strict=False):
            place = left + _PAD + _LABEL + right, middle
            yield lettered(plain(text), place, (1, 0.5), theme.ink, pixels=SMALL)


def _columns(texts: list[list[str]]) -> list[list[str]]:
    """Return the texts below one another, of rows that are not equally long."""
    return [[row[k] for row in texts if k < len(row)] for k in range(max(map(len, texts)))]


def _digits(name: str, frame: Frame) -> Iterable[int]:
    """Return how many digits the numbers of a row have: coordinates far from 0 more, which tell neighbours apart."""
    if name != _COORDINATES:
        return itertools.repeat(_DIGITS)
    shared = np.log10(np.abs(frame.limits).max(axis=1) / np.ptp(frame.limits, axis=1))
    return [min(_DIGITS + max(0, int(more)), _MOST_DIGITS) for more in shared.tolist()]


def _number(value: float, digits: int) -> str:
    """Return a number with as many digits as can be told from its neighbours."""
    if math.isnan(value):
        return "undefined"
    return significant_text(value, digits)
