"""Writing ``.npz``: every array of a surface under its own name."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from qovr_core.files.atomic import replacing
from qovr_core.files.progress import Progress
from qovr_core.knots import knot_array
from qovr_core.pipeline import Surface


def surface_arrays(surface: Surface) -> dict[str, Any]:
    """Return the arrays of a surface by their public names; knots (5, 4) in the order r s u t and r s v t."""
    document = surface.document
    return {
        "control_points": document.control_points,
        "row_knots": knot_array(document.row_knots),
        "column_knots": knot_array(document.column_knots),
        "u": surface.u,
        "v": surface.v,
        "raw": surface.raw,
        "transformed": surface.transformed,
        "control_box": surface.control_box,
        "raw_box": surface.raw_box,
        "matrix": surface.matrix,
        "formulation": str(document.formulation),
    }


def write_npz(surface: Surface, path: Path, progress: Progress) -> None:
    """Write all arrays of a surface, whole or not at all.

    Raises
    ------
    FileError : the file cannot be written
    """
    with replacing(path) as (draft,), draft.open("wb") as file:
        np.savez(file, **surface_arrays(surface))
        progress(1.0)
