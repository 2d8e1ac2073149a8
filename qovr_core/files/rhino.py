"""Writing and reading ``.3dm``: the exact surface, its control net, and the document as user text."""

from __future__ import annotations

import base64
import mmap
import struct
import zlib
from dataclasses import replace
from datetime import datetime
from hashlib import sha256
from operator import itemgetter
from pathlib import Path
from typing import Any
from uuid import UUID, uuid5

from qovr_core.document import Document
from qovr_core.evaluation import Evaluation
from qovr_core.files import parts
from qovr_core.files.atomic import LOGGER, replacing
from qovr_core.files.bspline import SplineSurface
from qovr_core.files.conventions import Unit
from qovr_core.files.options import DEFAULTS, ExportOptions
from qovr_core.files.parts import Sheet
from qovr_core.files.progress import Progress
from qovr_core.files.provenance import PROGRAM, origin, timestamp
from qovr_core.files.qovr_document import LARGEST_FILE, document_from_json, document_to_json
from qovr_core.files.reading import reading
from qovr_core.files.rhino_points import moved_points, own_points

DOCUMENT_KEY = "qovr.document"

_MAGIC = b"3D Geometry File Format "
_KEY_IN_FILE = f"{DOCUMENT_KEY}\0".encode("utf-16-le")
"""openNURBS writes a string as a count of its 16-bit characters, then these, the last one a zero."""

_HISTORY_BYTES = 81
_HISTORY = struct.pack("<Iq", 0x20008021, _HISTORY_BYTES)
"""How the record of a revision history begins whose names are empty: its code and its length."""
_TIMES = (5, 41)
"""Where in it the times stand, of its making and of its last change, each eight 32-bit numbers; zeros are no time."""

_IDS = UUID("5d1a6bfe-6f0c-4e0f-9a53-6d0f1f4e7c11")
"""Of which the ids of layers and objects are made, with their names and the document: openNURBS takes any at random."""

_LONGEST_IDENTITY = 1 << 16
"""Characters of a document that go into every id; of a longer one its digest does, since a large net has many ids."""

SURFACE_LAYER, NET_LAYER, POINTS_LAYER = "Surface", "Control net", "Control points"


def write_3dm(evaluation: Evaluation, path: Path, progress: Progress, options: ExportOptions = DEFAULTS) -> None:
    """Write the exact surface of its true degree, the net's lines and points, and the document, in its numbers' unit.

    Each smooth part is a surface of its own. Of the points that are one on a closed net the first is written.

    Raises
    ------
    FileError : the surface has no area, or the file cannot be written
    """
    sheets = parts.sheets(evaluation, options, path)
    progress(0.0)
    content = _dated(base64.b64decode(_model(evaluation, sheets, options).Encode()))
    progress(0.5)
    with replacing(path) as (draft,):
        draft.write_bytes(content)
        progress(1.0)


def _dated(content: bytes) -> bytes:
    """Return a file with both times of its revision history set to the one that it is to tell, or to none.

    openNURBS writes the present time there and gives no way to set another.
    """
    start = content.index(_HISTORY) + len(_HISTORY)
    history = bytearray(content[start : start + _HISTORY_BYTES])
    made = timestamp()
    for place in _TIMES:
        struct.pack_into("<8i", history, place, *(_calendar(made) if made else (0,) * 8))
    struct.pack_into("<I", history, len(history) - 4, zlib.crc32(history[:-4]))
    return content[:start] + bytes(history) + content[start + len(history) :]


def _calendar(time: datetime) -> tuple[int, ...]:
    """Return a time as C has it: months count from 0, years from 1900, days of the week from Sunday."""
    year, month, day, hour, minute, second, weekday, yearday, _ = time.timetuple()
    return second, minute, hour, day, month - 1, year - 1900, (weekday + 1) % 7, yearday - 1


def read_3dm(path: Path) -> Document:
    """Return the document that this program put into a ``.3dm`` file, its points as they stand in the file now.

    Where another program has moved the named points, these count, which is told; the rest of the geometry is not
    looked at.

    Raises
    ------
    FileError : the file cannot be read, is no Rhino file, or holds no valid document
    """
    with reading(path) as file:
        if file.read(len(_MAGIC)) != _MAGIC:
            raise ValueError("is no Rhino file (.3dm)")
        with mmap.mmap(file.fileno(), 0, access=mmap.ACCESS_READ) as content:
            document = document_from_json(_document_text(content))
            net, moved = moved_points(content, document)
        if not moved:
            return document
        document = replace(document, control_points=net)
    points = "1 control point was" if moved == 1 else f"{moved} control points were"
    LOGGER.warning("%s: %s moved after this program wrote the file; they count as they stand there now", path, points)
    return document


def _document_text(content: mmap.mmap) -> str:
    """Return the document's user text, found by its key: openNURBS goes astray for minutes in damaged files."""
    start = content.find(_KEY_IN_FILE)
    if start < 0:
        raise ValueError(f"has no user text '{DOCUMENT_KEY}'; expected a file that this program exported")
    start += len(_KEY_IN_FILE)
    length = 2 * int.from_bytes(content[start : start + 4], "little")
    if not 0 < length <= 2 * LARGEST_FILE:
        raise ValueError(f"its user text '{DOCUMENT_KEY}' is {length} bytes long; expected a document")
    return content[start + 4 : start + 4 + length].decode("utf-16-le").rstrip("\0")


def _model(evaluation: Evaluation, sheets: tuple[Sheet, ...], options: ExportOptions) -> Any:
    import rhino3dm

    document = evaluation.document
    text = document_to_json(document)
    identity = text if len(text) <= _LONGEST_IDENTITY else sha256(text.encode()).hexdigest()
    model = rhino3dm.File3dm()
    model.ApplicationName = PROGRAM
    model.Settings.ModelUnitSystem = getattr(rhino3dm.UnitSystem, _UNIT_SYSTEMS[options.unit])
    model.Settings.ModelAbsoluteTolerance = parts.uncertainty(sheets)
    layers = {name: model.Layers.AddLayer(name, colour) for name, colour in _LAYERS.items()}
    for name, index in layers.items():
        model.Layers[index].Id = uuid5(_IDS, f"{name}{identity}")

    def named(name: str, layer: str) -> Any:
        attributes = rhino3dm.ObjectAttributes()
        attributes.Name, attributes.Id = name, uuid5(_IDS, f"{layer}/{name}{identity}")
        attributes.LayerIndex = layers[layer]
        return attributes

    surfaces = list(parts.surfaces(sheets))
    for k, surface in enumerate(surfaces, 1):
        attributes = named("QOVR surface" if len(surfaces) == 1 else f"QOVR surface {k}", SURFACE_LAYER)
        attributes.SetUserString("qovr.origin", origin(evaluation, options))
        model.Objects.AddSurface(_nurbs_surface(surface), attributes)
    net = [[rhino3dm.Point3d(*point) for point in row] for row in document.control_points.tolist()]
    lines = [(i, "row", row) for i, row in enumerate(net)]
    lines += [(j, "column", list(column)) for j, column in enumerate(zip(*net, strict=True))]
    for k, kind, line in sorted(lines, key=itemgetter(0)):
        model.Objects.AddCurve(rhino3dm.PolylineCurve(rhino3dm.Point3dList(line)), named(f"{kind} {k}", NET_LAYER))
    for i, j in own_points(document):
        model.Objects.Add(rhino3dm.Point(net[i][j]), named(f"P{i},{j}", POINTS_LAYER))
    model.Strings[DOCUMENT_KEY] = text
    model.Strings["qovr.origin"] = origin(evaluation, options)
    model.Strings["qovr.formulation"] = str(document.formulation)
    return model


_UNIT_SYSTEMS = {
    Unit.MILLIMETRE: "Millimeters",
    Unit.CENTIMETRE: "Centimeters",
    Unit.METRE: "Meters",
    Unit.INCH: "Inches",
}
"""What openNURBS calls each unit."""

_LAYERS = {
    SURFACE_LAYER: (60, 120, 200, 255),
    NET_LAYER: (120, 120, 120, 255),
    POINTS_LAYER: (0, 0, 255, 255),
}
"""Colours as red, green, blue, alpha."""


def _nurbs_surface(spline: SplineSurface) -> Any:
    import rhino3dm

    count_u, count_v = spline.points.shape[:2]
    surface = rhino3dm.NurbsSurface.Create(3, False, spline.u.degree + 1, spline.v.degree + 1, count_u, count_v)
    for knots, vector in ((surface.KnotsU, spline.u), (surface.KnotsV, spline.v)):
        for k, knot in enumerate(vector.repeated[1:-1]):  # openNURBS leaves out the first and the last knot
            knots[k] = knot
    points = surface.Points
    for i, row in enumerate(spline.points.tolist()):
        for j, (x, y, z) in enumerate(row):
            points[i, j] = rhino3dm.Point4d(x, y, z, 1.0)
    return surface
