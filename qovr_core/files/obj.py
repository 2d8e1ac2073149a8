"""Writing ``.obj``: shared points and exact normals, each with its own index, shortest round-trip decimals.

Written here because mesh libraries round to a fixed number of decimals.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from qovr_core.evaluation import Evaluation
from qovr_core.files.atomic import replacing
from qovr_core.files.conventions import USUAL_UP, Up
from qovr_core.files.mesh import MESHED, Mesh, blocks, build_mesh
from qovr_core.files.options import DEFAULTS, ExportOptions
from qovr_core.files.progress import Progress
from qovr_core.files.provenance import mesh_comments

_NORMAL = f"vn{3 * ' %.9g'}\n"
"""Every 32-bit number reads back as itself from 9 digits; a direction needs no more."""


def write_obj(evaluation: Evaluation, path: Path, progress: Progress, options: ExportOptions = DEFAULTS) -> None:
    """Write the mesh of a surface.

    Raises
    ------
    FileError : the surface has no area, the tolerance cannot be met, or the file cannot be written
    """
    mesh = build_mesh(evaluation, options, path, progress)
    up = options.up or USUAL_UP[".obj"]
    total = len(mesh.points) + len(mesh.normals) + len(mesh.faces)
    done = 0
    with replacing(path) as (draft,), draft.open("w", encoding="ascii", newline="\n") as file:
        file.writelines(f"# {line}\n" for line in mesh_comments(evaluation, options, mesh.deviation))
        file.write("o QOVR_surface\n")
        for text, count in _parts(mesh, up):
            file.write(text)
            done += count
            progress(MESHED + (1 - MESHED) * done / total)


def _parts(mesh: Mesh, up: Up) -> Iterator[tuple[str, int]]:
    """Yield the text of points, normals and faces, and how many lines it is."""
    for pattern, rows in (("v %r %r %r\n", mesh.points), (_NORMAL, mesh.normals)):
        for part in blocks(len(rows)):
            yield _lines(pattern, up.turned(rows[part]))
    for part in blocks(len(mesh.faces)):
        indices = np.stack([mesh.faces[part], mesh.corners[part]], axis=-1) + 1
        yield _lines("f %d//%d %d//%d %d//%d\n", indices.reshape(-1, 6))


def _lines(pattern: str, rows: npt.NDArray[Any]) -> tuple[str, int]:
    return pattern * len(rows) % tuple(rows.ravel().tolist()), len(rows)
