"""Writing ``.stl`` (binary): triangles in 32 bits, moved to the origin where they would lose digits elsewhere."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np

from qovr_core.arrays import Array
from qovr_core.evaluation import Evaluation
from qovr_core.files import bspline
from qovr_core.files.atomic import replacing
from qovr_core.files.conventions import USUAL_UP
from qovr_core.files.mesh import MESHED, blocks, build_mesh, check_float32, float32_rounding
from qovr_core.files.options import DEFAULTS, ExportOptions
from qovr_core.files.progress import Progress
from qovr_core.files.provenance import origin

HEADER_BYTES = 80

REACH = 4.0
"""A surface farther from the origin than this many of its sizes is moved: nearer, it loses 3 of 24 bits at most."""

_FACET = np.dtype([("normal", "<f4", 3), ("points", "<f4", (3, 3)), ("attribute", "<u2")])


def write_stl(evaluation: Evaluation, path: Path, progress: Progress, options: ExportOptions = DEFAULTS) -> None:
    """Write the mesh of a surface; what was added to its coordinates stands in the header.

    Raises
    ------
    FileError : the surface has no area, the tolerance cannot be met, or the file cannot be written
    """
    mesh = build_mesh(evaluation, options, path, progress, float32_rounding(evaluation, options, REACH))
    points = (options.up or USUAL_UP[".stl"]).turned(mesh.points)
    check_float32(points, 1.0, path)
    offset = shift(points)
    with replacing(path) as (draft,), draft.open("wb") as file:
        file.write(_header(evaluation, options, offset))
        file.write(np.uint32(len(mesh.faces)).astype("<u4").tobytes())
        for part in blocks(len(mesh.faces)):
            corners = points[mesh.faces[part]] + offset
            facets = np.zeros(part.stop - part.start, dtype=_FACET)
            facets["normal"] = _facet_normals(corners)
            facets["points"] = corners
            file.write(facets.tobytes())
            progress(MESHED + (1 - MESHED) * part.stop / len(mesh.faces))


def shift(points: Array) -> Array:
    """Return what to add to points (k, 3) so that 32 bits hold them: (3,), zero where they lie well.

    Otherwise it is minus the middle of their box, rounded to a decimal of their size, short enough for the header.
    """
    size = bspline.diagonal(points)
    low, high = points.min(axis=0), points.max(axis=0)
    if max(np.abs(low).max(), np.abs(high).max()) <= REACH * size:
        return np.zeros(3)
    digits = -math.floor(math.log10(size))
    return np.array([-round(middle, digits) for middle in ((low + high) / 2).tolist()])


def _header(evaluation: Evaluation, options: ExportOptions, offset: Array) -> bytes:
    # Readers take a file that begins with "solid" for text, so it never does.
    moved = f"moved by {' '.join(f'{x:.15g}' for x in offset)}; " if offset.any() else ""
    text = moved + origin(evaluation, options)
    return text.encode("ascii")[:HEADER_BYTES].ljust(HEADER_BYTES)


def _facet_normals(corners: Array) -> Array:
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    lengths = np.linalg.norm(normals, axis=-1, keepdims=True)
    # The format lets a reader compute the normal of a facet that is too thin to have one: zeros say so.
    result: Array = np.divide(normals, lengths, out=np.zeros_like(normals), where=lengths > 0)
    return result
