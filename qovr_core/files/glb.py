"""Writing ``.glb`` (glTF 2.0, binary): metres, Y up, linear colours, centred so that 32 bits lose nothing."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any, BinaryIO

import numpy as np

from qovr_core.arrays import Array
from qovr_core.colours import height_colours, linear
from qovr_core.evaluation import Evaluation
from qovr_core.files.atomic import replacing
from qovr_core.files.conventions import Unit, Up
from qovr_core.files.mesh import MESHED, Mesh, blocks, build_mesh, check_float32, float32_rounding
from qovr_core.files.options import DEFAULTS, ExportOptions
from qovr_core.files.progress import Progress
from qovr_core.files.provenance import PROGRAM, origin
from qovr_core.files.qovr_document import document_to_json

_FLOAT, _UNSIGNED_SHORT, _UNSIGNED_INT = 5126, 5123, 5125
_ARRAY_BUFFER, _ELEMENT_ARRAY_BUFFER = 34962, 34963
_JSON_CHUNK, _BINARY_CHUNK = 0x4E4F534A, 0x004E4942
_HEADER_BYTES, _CHUNK_HEADER_BYTES = 12, 8

_REACH = 0.5
"""Centred, no coordinate is larger than half the surface's size."""


def write_glb(evaluation: Evaluation, path: Path, progress: Progress, options: ExportOptions = DEFAULTS) -> None:
    """Write the mesh of a surface as one node, whose translation puts it in its place.

    Raises
    ------
    FileError : the surface has no area, the tolerance cannot be met, or the file cannot be written
    """
    mesh = build_mesh(evaluation, options, path, progress, float32_rounding(evaluation, options, _REACH))
    check_float32(mesh.points, options.unit.metres, path)
    centre = (mesh.points.min(axis=0) + mesh.points.max(axis=0)) / 2
    tree = _tree(mesh, centre, evaluation, options)
    text = json.dumps(tree, separators=(",", ":")).encode("ascii")
    text += b" " * (-len(text) % 4)
    length = tree["buffers"][0]["byteLength"]
    total = _HEADER_BYTES + 2 * _CHUNK_HEADER_BYTES + len(text) + length
    with replacing(path) as (draft,), draft.open("wb") as file:
        file.write(b"glTF" + np.array([2, total, len(text), _JSON_CHUNK], "<u4").tobytes())
        file.write(text)
        file.write(np.array([length, _BINARY_CHUNK], "<u4").tobytes())
        _write_buffer(file, mesh, centre, options.unit, progress)


def _positions(points: Array, centre: Array, unit: Unit) -> np.ndarray[Any, np.dtype[np.float32]]:
    return (Up.Y.turned(points - centre) * unit.metres).astype("<f4")


def _write_buffer(file: BinaryIO, mesh: Mesh, centre: Array, unit: Unit, progress: Progress) -> None:
    vertices = mesh.vertices
    low, high = vertices[:, 2].min(), vertices[:, 2].max()
    opaque = np.iinfo(np.uint16).max
    total, done = 3 * len(vertices) + len(mesh.corners), 0

    def put(content: np.ndarray[Any, Any]) -> None:
        nonlocal done
        file.write(content.tobytes())
        done += len(content)
        progress(MESHED + (1 - MESHED) * done / total)

    for part in blocks(len(vertices)):
        put(_positions(vertices[part], centre, unit))
    for part in blocks(len(vertices)):
        put(Up.Y.turned(mesh.normals[part]).astype("<f4"))
    for part in blocks(len(vertices)):
        colours = np.full((part.stop - part.start, 4), opaque, dtype="<u2")
        colours[:, :3] = np.rint(opaque * linear(height_colours(vertices[part, 2], low, high)))
        put(colours)
    for part in blocks(len(mesh.corners)):
        put(mesh.corners[part].astype("<u4"))


def _tree(mesh: Mesh, centre: Array, evaluation: Evaluation, options: ExportOptions) -> dict[str, Any]:
    """Return the JSON part; attributes first, then the triangles, in the order of ``_write_buffer``."""
    count = len(mesh.normals)
    ends = [mesh.points.min(axis=0), mesh.points.max(axis=0)]
    corners = np.array([_positions(end, centre, options.unit) for end in ends])
    box = {"min": corners.min(axis=0).tolist(), "max": corners.max(axis=0).tolist()}
    accessors = [
        {"componentType": _FLOAT, "count": count, "type": "VEC3", **box},
        {"componentType": _FLOAT, "count": count, "type": "VEC3"},
        {"componentType": _UNSIGNED_SHORT, "count": count, "type": "VEC4", "normalized": True},
        {"componentType": _UNSIGNED_INT, "count": mesh.corners.size, "type": "SCALAR"},
    ]
    views, length = _views([12 * count, 12 * count, 8 * count, 4 * mesh.corners.size])
    primitive = {"attributes": {"POSITION": 0, "NORMAL": 1, "COLOR_0": 2}, "indices": 3, "material": 0}
    matte = {"metallicFactor": 0.0, "roughnessFactor": 0.6}
    place = Up.Y.turned(centre) * options.unit.metres
    extras: dict[str, Any] = {
        "origin": origin(evaluation, options),
        "document": json.loads(document_to_json(evaluation.document)),
    }
    if mesh.deviation is not None:
        extras |= {"tolerance": options.tolerance, "deviation": mesh.deviation}
    return {
        "asset": {"version": "2.0", "generator": PROGRAM, "extras": extras},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"name": "QOVR surface", "mesh": 0, "translation": place.tolist()}],
        "meshes": [{"name": "QOVR surface", "primitives": [primitive]}],
        "materials": [{"name": "height", "pbrMetallicRoughness": matte, "doubleSided": True}],
        "accessors": [{"bufferView": k, **accessor} for k, accessor in enumerate(accessors)],
        "bufferViews": views,
        "buffers": [{"byteLength": length}],
    }


def _views(lengths: list[int]) -> tuple[list[dict[str, int]], int]:
    views, offset = [], 0
    for k, length in enumerate(lengths):
        is_index = k == len(lengths) - 1
        target = _ELEMENT_ARRAY_BUFFER if is_index else _ARRAY_BUFFER
        views.append({"buffer": 0, "byteOffset": offset, "byteLength": length, "target": target})
        offset += length
    return views, offset
