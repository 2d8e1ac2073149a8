"""Writing ``.ply`` (binary, little-endian): points in double precision, exact normals, colours by height.

Written here because mesh libraries cut the points to 32 bits.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np

from qovr_core.colours import height_colours
from qovr_core.evaluation import Evaluation
from qovr_core.files.atomic import replacing
from qovr_core.files.conventions import USUAL_UP
from qovr_core.files.mesh import MESHED, Mesh, blocks, build_mesh
from qovr_core.files.options import DEFAULTS, ExportOptions
from qovr_core.files.progress import Progress
from qovr_core.files.provenance import mesh_comments

_VERTEX = np.dtype([("point", "<f8", 3), ("normal", "<f4", 3), ("colour", "u1", 3)])
_FACE = np.dtype([("count", "u1"), ("corners", "<i4", 3)])
_PROPERTIES = (
    *(f"property double {axis}" for axis in "xyz"),
    *(f"property float n{axis}" for axis in "xyz"),
    *(f"property uchar {colour}" for colour in ("red", "green", "blue")),
)


def write_ply(evaluation: Evaluation, path: Path, progress: Progress, options: ExportOptions = DEFAULTS) -> None:
    """Write the mesh of a surface.

    Raises
    ------
    FileError : the surface has no area, the tolerance cannot be met, or the file cannot be written
    """
    mesh = build_mesh(evaluation, options, path, progress)
    with replacing(path) as (draft,), draft.open("wb") as file:
        file.write(_header(mesh, mesh_comments(evaluation, options, mesh.deviation)).encode("ascii"))
        up = options.up or USUAL_UP[".ply"]
        vertices, total = mesh.vertices, len(mesh.normals) + len(mesh.faces)
        low, high = vertices[:, 2].min(), vertices[:, 2].max()
        for part in blocks(len(vertices)):
            block = np.empty(part.stop - part.start, dtype=_VERTEX)
            block["point"] = up.turned(vertices[part])
            block["normal"] = up.turned(mesh.normals[part])
            block["colour"] = np.rint(255 * height_colours(vertices[part, 2], low, high))
            file.write(block.tobytes())
            progress(MESHED + (1 - MESHED) * part.stop / total)
        for part in blocks(len(mesh.corners)):
            faces = np.empty(part.stop - part.start, dtype=_FACE)
            faces["count"] = 3
            faces["corners"] = mesh.corners[part]
            file.write(faces.tobytes())
            progress(MESHED + (1 - MESHED) * (len(vertices) + part.stop) / total)


def _header(mesh: Mesh, comments: list[str]) -> str:
    lines = [
        "ply",
        "format binary_little_endian 1.0",
        *(f"comment {line}" for line in comments),
        f"element vertex {len(mesh.normals)}",
        *_PROPERTIES,
        f"element face {len(mesh.faces)}",
        "property list uchar int vertex_indices",
        "end_header",
    ]
    return "\n".join(lines) + "\n"
