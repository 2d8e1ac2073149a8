"""Writing ``.obj``: shared points and exact normals, each with its own index, shortest round-trip decimals.

Written here because mesh libraries round to a fixed number of decimals.
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TextIO

import numpy as np
import numpy.typing as npt

from qovr_core.arrays import Array
from qovr_core.files.atomic import replacing
from qovr_core.files.mesh import MESHED, blocks, build_mesh
from qovr_core.files.options import DEFAULTS, ExportOptions
from qovr_core.files.progress import Progress
from qovr_core.files.provenance import mesh_comments
from qovr_core.pipeline import Surface

_NORMAL_DIGITS = 9
"""Every 32-bit number reads back as itself from 9 digits; a direction needs no more."""


def write_obj(surface: Surface, path: Path, progress: Progress, options: ExportOptions = DEFAULTS) -> None:
    """Write the mesh of a surface.

    Raises
    ------
    FileError : the surface has no area, the tolerance cannot be met, or the file cannot be written
    """
    mesh = build_mesh(surface, options, path, progress)
    indices = np.stack([mesh.faces, mesh.corners], axis=-1).reshape(-1, 6)
    total = len(mesh.points) + len(mesh.normals) + len(indices)
    done = 0

    def advance(lines: int) -> None:
        nonlocal done
        done += lines
        progress(MESHED + (1 - MESHED) * done / total)

    with replacing(path) as (draft,), draft.open("w", encoding="ascii", newline="\n") as file:
        file.writelines(f"# {line}\n" for line in mesh_comments(surface, options, mesh.deviation))
        file.write("o QOVR_surface\n")
        _write_rows(file, "v %r %r %r\n", mesh.points, advance)
        _write_rows(file, f"vn{3 * f' %.{_NORMAL_DIGITS}g'}\n", mesh.normals, advance)
        _write_rows(file, "f %d//%d %d//%d %d//%d\n", indices + 1, advance)


def _write_rows(
    file: TextIO, pattern: str, rows: Array | npt.NDArray[np.int32], advance: Callable[[int], None]
) -> None:
    for part in blocks(len(rows)):
        block = rows[part]
        file.write(pattern * len(block) % tuple(block.ravel().tolist()))
        advance(len(block))
