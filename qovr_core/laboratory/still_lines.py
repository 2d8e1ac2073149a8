"""The isoparametric lines of a surface that a displacement leaves where they are."""

from __future__ import annotations

import numpy as np

from qovr_core.geometry import bernstein
from qovr_core.geometry.patch import PATCH_DEGREE, Patch

_STILL = 1e-9
"""Part of the largest coefficient up to which a line does not move: what the rounding of its parameter costs."""


def still_lines(displacement: Patch, axis: int, noise: float = 0.0) -> tuple[float, ...]:
    """Return the lines u = c (axis 0) or v = c (axis 1) along which a displacement vanishes.

    Along such a line every one of the 21 polynomials that make up the displacement has a root in c; so has their
    strongest combination, whose few roots are tried. None where it vanishes everywhere.

    Parameters
    ----------
    noise : what is no larger is rounding of the two surfaces between which the displacement is

    Returns
    -------
    the parameters c, growing, each in [0, 1]
    """
    table = np.moveaxis(displacement.coefficients[0, 0], axis, 0).reshape(PATCH_DEGREE + 1, -1)
    largest = np.abs(table).max()
    if largest == 0:
        return ()
    strongest = np.linalg.svd(table, full_matrices=False)[0][:, 0]
    candidates = np.concatenate([[0.0, 1.0], bernstein.roots(strongest)])
    on_line = np.abs(bernstein.basis(PATCH_DEGREE, candidates) @ table).max(axis=1)
    still: list[float] = []
    for c in candidates[on_line <= max(_STILL * largest, noise)].tolist():
        if all(abs(c - other) > bernstein.ROOT_TOLERANCE for other in still):
            still.append(c)
    return tuple(sorted(still))
