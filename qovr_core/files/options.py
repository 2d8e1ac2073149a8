"""What may be chosen of an export: the surface, how closely a mesh follows it, and what the file's numbers mean."""

from __future__ import annotations

import math
from dataclasses import dataclass

from qovr_core.arrays import Array
from qovr_core.document import Document
from qovr_core.evaluation import Evaluation
from qovr_core.files.conventions import CsvDialect, Unit, Up
from qovr_core.geometry.patch import Patch
from qovr_core.layer import Layer


@dataclass(frozen=True)
class ExportOptions:
    """Choices that only some formats know.

    Parameters
    ----------
    layer : the surface that a format for one surface gets; None takes the one that lies on the net
    tolerance : largest distance between surface and mesh, in the document's unit, positive; None takes the
        document's samples as the mesh's vertices
    unit : what the document's numbers count
    up : the axis that points up in the file; None takes the one that readers of the format expect
    csv_dialect : how a table of text spells its cells
    single_face : whether an exact surface stays one face across its sharp joints, instead of one for each smooth part

    Raises
    ------
    ValueError : there is no such layer, unit, axis or dialect, or the tolerance is no positive number
    """

    layer: Layer | None = None
    tolerance: float | None = None
    unit: Unit = Unit.MILLIMETRE
    up: Up | None = None
    csv_dialect: CsvDialect = CsvDialect.COMMA
    single_face: bool = False

    def __post_init__(self) -> None:
        kinds = {"layer": Layer, "unit": Unit, "up": Up, "csv_dialect": CsvDialect}
        for name, kind in kinds.items():
            if getattr(self, name) is not None:
                object.__setattr__(self, name, kind(getattr(self, name)))
        if self.tolerance is not None and not 0 < self.tolerance < math.inf:
            raise ValueError(f"the tolerance is {self.tolerance}; expected a positive distance")

    def chosen_layer(self, document: Document) -> Layer:
        """Return the layer to write."""
        return self.layer or document.formulation.resting_layer

    def chosen_patch(self, evaluation: Evaluation) -> Patch:
        """Return the exact surface to write."""
        return evaluation.layer_patch(self.chosen_layer(evaluation.document))

    def chosen_samples(self, evaluation: Evaluation) -> Array:
        """Return the samples (n, m, 3) of the surface to write."""
        return evaluation.samples(self.chosen_layer(evaluation.document))


DEFAULTS = ExportOptions()
