"""Which formulation a published workbook was computed with, decided by computing it again."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from qovr_core.arrays import Array
from qovr_core.errors import EvaluationError
from qovr_core.evaluation import configure
from qovr_core.files.workbook_read import PublishedNumbers, read_published_numbers
from qovr_core.formulations import FORMULATIONS, Formulation

RAW_TOLERANCE = 1e-8
"""Raw coordinates stand at full precision in the workbooks."""

TRANSFORMED_TOLERANCE = 5.1e-6
"""Transformed coordinates stand there rounded to 5 decimals."""


@dataclass(frozen=True)
class Difference:
    """Largest absolute differences between a workbook and one formulation of its inputs; infinite where none exists."""

    raw: float
    box: float
    matrix: float
    transformed: float

    @property
    def meets(self) -> bool:
        """Whether the formulation is the one that the workbook holds."""
        return self.raw <= RAW_TOLERANCE and self.transformed <= TRANSFORMED_TOLERANCE


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
        return Difference(np.inf, np.inf, np.inf, np.inf)
    return Difference(
        raw=_largest(surface.raw, published.raw),
        box=max(
            _largest(surface.raw_box, published.raw_box),
            _largest(surface.control_box, published.control_box),
        ),
        matrix=_largest(surface.matrix, published.matrix),
        transformed=_largest(surface.transformed, published.transformed),
    )


def _largest(computed: Array, published: Array) -> float:
    return float(np.abs(computed - published).max())
