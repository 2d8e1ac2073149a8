"""The comparison in pieces of some ten milliseconds, for work that is done while nothing else is to do."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from qovr_core.geometry.closest import closest_points
from qovr_core.geometry.rounding import in_own_unit
from qovr_core.laboratory.comparison import REFERENCE, ComparisonInput, Measures, compared_names, motion_between
from qovr_core.laboratory.shape_measures import bending_energy, joints, largest_distance


def comparison_pieces(of: ComparisonInput) -> Iterator[tuple[str, Measures] | None]:
    """Measure as ``compare`` does: yield None after each piece, and name and measures of each surface at its end."""
    pieces = _pieces(of)
    while True:
        with np.errstate(all="ignore"):  # what overflows has no number, and is shown so
            try:
                found = next(pieces)
            except StopIteration:
                return
        yield found


def _pieces(of: ComparisonInput) -> Iterator[tuple[str, Measures] | None]:
    reference = of.surface(REFERENCE)
    inner = of.document.control_points[1:-1, 1:-1].reshape(-1, 3)
    for name in compared_names():
        surface = of.surface(name)
        motion = motion_between(surface, of.surface(name, moved=True))
        yield None
        from_points = float(closest_points(surface, inner).distance.max())
        jumps, energy = joints(surface), bending_energy(in_own_unit(surface)[0])
        yield None
        from_qovr = 0.0 if name == REFERENCE else largest_distance(surface, reference)
        yield None
        of_qovr = 0.0 if name == REFERENCE else largest_distance(reference, surface)
        yield (
            name,
            Measures(
                **vars(motion),
                distance_from_points=from_points,
                joints=jumps,
                bending_energy=energy,
                distance_from_qovr=from_qovr,
                distance_of_qovr=of_qovr,
            ),
        )
