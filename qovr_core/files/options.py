"""What may be chosen of an export: which of the two surfaces, and how closely a mesh follows it."""

from __future__ import annotations

import math
from dataclasses import dataclass

from qovr_core.arrays import Array
from qovr_core.document import Document
from qovr_core.evaluation import Evaluation
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

    Raises
    ------
    ValueError : there is no such layer, or the tolerance is no positive number
    """

    layer: Layer | None = None
    tolerance: float | None = None

    def __post_init__(self) -> None:
        if self.layer is not None:
            object.__setattr__(self, "layer", Layer(self.layer))
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
