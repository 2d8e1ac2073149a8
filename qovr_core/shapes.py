"""New documents to begin with: nets made by formulas, all of them interpolating."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from qovr_core.arrays import Array
from qovr_core.document import Document
from qovr_core.formulations import Formulation
from qovr_core.geometry.windows import NET_SIZE
from qovr_core.presets import network_case

Height = Callable[[Array, Array], Array]
"""Heights over x and y, both from -1 to 1."""


@dataclass(frozen=True)
class Shape:
    """A net to begin with.

    Parameters
    ----------
    title : what menus say
    document : makes it
    """

    title: str
    document: Callable[[], Document]


def _over_grid(height: Height) -> Callable[[], Document]:
    """Return what makes a net over the paper's grid, x = j and y = i."""

    def make() -> Document:
        y, x = np.mgrid[:NET_SIZE, :NET_SIZE].astype(np.float64)
        half = (NET_SIZE - 1) / 2
        z = np.broadcast_to(height(x / half - 1, y / half - 1), x.shape)
        return Document(np.stack([x, y, z], axis=-1), formulation=Formulation.INTERPOLATING)

    return make


def _papers_net() -> Document:
    return Document(network_case().document.control_points, formulation=Formulation.INTERPOLATING)


SHAPES = {
    "paper": Shape("Paper's net", _papers_net),
    "flat": Shape("Flat", _over_grid(lambda x, _y: 0 * x)),
    "dome": Shape("Dome", _over_grid(lambda x, y: 2 - x**2 - y**2)),
    "saddle": Shape("Saddle", _over_grid(lambda x, y: x**2 - y**2)),
    "wave": Shape("Wave", _over_grid(lambda x, _y: np.sin(np.pi * x) / 2)),
}
"""What File, New offers, by name."""
