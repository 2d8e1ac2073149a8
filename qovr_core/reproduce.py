"""Which formulation a published workbook was computed with, decided by computing it again."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from qovr_core.arrays import Array
from qovr_core.errors import EvaluationError
from qovr_core.evaluation import configure
from qovr_core.files import published_layout as layout
from qovr_core.files.workbook_read import PublishedNumbers, read_published_numbers
from qovr_core.formulations import FORMULATIONS, Formulation

RAW_TOLERANCE = 1e-8
"""Part of the largest raw number on an axis: raw coordinates stand at full precision in the workbooks."""

TRANSFORMED_TOLERANCE = 0.51
"""Units of the last decimal written on an axis: transformed coordinates are rounded."""

TRANSFORMED_ROUNDING = 1e-12
"""Part of the largest transformed number on an axis that may be added to it: large numbers have few decimals."""

_CELL_DIGITS = 2e-15
"""Cells hold 16 digits: a number is one of so many decimals where it differs from it by no more than this part."""

_MOST_DECIMALS = 300
"""Beyond, the unit of a decimal is no number in double precision; such numbers count as written in full."""


@dataclass(frozen=True)
class Difference:
    """Largest absolute differences between a workbook and one formulation of its inputs; infinite where none exists.

    Parameters
    ----------
    meets : whether the formulation is the one that the workbook holds: axis by axis, raw and transformed coordinates
        are within the tolerances above
    """

    raw: float
    box: float
    matrix: float
    transformed: float
    meets: bool


@dataclass(frozen=True)
class Reproduction:
    """A workbook held against every formulation."""

    path: Path
    samples: tuple[int, int]
    differences: dict[Formulation, Difference]

    @property
    def met_by(self) -> tuple[Formulation, ...]:
        """The formulations that meet the workbook."""
        return tuple(formulation for formulation, difference in self.differences.items() if difference.meets)


def reproduce(path: Path) -> Reproduction:
    """Read a workbook in the published layout and compute its inputs under every formulation.

    Raises
    ------
    FileError : the workbook cannot be read or lacks a number
    """
    published = read_published_numbers(path)
    differences = {formulation: _difference(published, formulation) for formulation in FORMULATIONS.values()}
    return Reproduction(path, published.document.samples, differences)


def _difference(published: PublishedNumbers, formulation: Formulation) -> Difference:
    try:
        surface = configure(replace(published.document, formulation=formulation))
    except EvaluationError:
        return Difference(np.inf, np.inf, np.inf, np.inf, meets=False)
    raw, transformed = (
        np.abs(computed - there).reshape(-1, 3).max(axis=0)
        for computed, there in ((surface.raw, published.raw), (surface.transformed, published.transformed))
    )
    boxes = (surface.raw_box - published.raw_box, surface.control_box - published.control_box)
    within_raw = raw <= RAW_TOLERANCE * _largest(published.raw)
    within_transformed = transformed <= _transformed_tolerance(published.transformed)
    return Difference(
        raw=float(raw.max()),
        box=float(np.abs(boxes).max()),
        matrix=float(np.abs(surface.matrix - published.matrix).max()),
        transformed=float(transformed.max()),
        meets=bool(within_raw.all() and within_transformed.all()),
    )


def _largest(points: Array) -> Array:
    """Return the largest magnitude on each axis, (3,)."""
    largest: Array = np.abs(points).reshape(-1, 3).max(axis=0)
    return largest


def _transformed_tolerance(points: Array) -> Array:
    """Return how far computed coordinates may be from those of a workbook on each axis, (3,)."""
    units = [_last_decimal(points[..., axis]) for axis in range(3)]
    return TRANSFORMED_TOLERANCE * np.array(units) + TRANSFORMED_ROUNDING * _largest(points)


def _last_decimal(numbers: Array) -> float:
    """Return the unit of the last decimal that numbers are written with, at most the published layout's."""
    for decimals in range(layout.TRANSFORMED_DECIMALS, _MOST_DECIMALS):
        with np.errstate(over="ignore", invalid="ignore"):
            misses = np.abs(numbers.round(decimals) - numbers)
        if (misses <= _CELL_DIGITS * np.abs(numbers)).all():
            return 10.0**-decimals
    return 0.0
