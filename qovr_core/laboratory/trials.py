"""The documents on which claims are tried besides the one at hand."""

from __future__ import annotations

import numpy as np

from qovr_core.document import Document
from qovr_core.formulations import Formulation
from qovr_core.geometry.knots import Knots
from qovr_core.geometry.windows import NET_SIZE

TRIAL_SEED = 20
"""The random documents are drawn from this seed, so that everybody sees the same."""

TRIALS = 2
"""How many random documents a claim must stand."""

SAMPLES = (31, 31)
"""Samples of whatever the laboratory makes: enough to meet a box within a hundredth of its size."""

_OFF_THE_GRID = 0.4
"""Points lie up to this far from the unit grid, so that the net does not fold."""

_KNOT_MARGIN = 0.2
"""Random knots keep this far from 0 and 1: ordinary surfaces, not extreme ones."""


def random_documents(formulation: Formulation) -> tuple[Document, ...]:
    """Return the random documents of a formulation; their nets and knots are the same for every one."""
    rng = np.random.default_rng(TRIAL_SEED)
    return tuple(_random_document(rng, formulation) for _ in range(TRIALS))


def _random_document(rng: np.random.Generator, formulation: Formulation) -> Document:
    y, x = np.mgrid[:NET_SIZE, :NET_SIZE]
    net = np.stack([x, y, 0 * x], axis=-1) + rng.uniform(-_OFF_THE_GRID, _OFF_THE_GRID, (NET_SIZE, NET_SIZE, 3))
    knots = rng.uniform(_KNOT_MARGIN, 1 - _KNOT_MARGIN, (2, NET_SIZE, 4)).tolist()
    rows, columns = (tuple(Knots(*curve) for curve in family) for family in knots)
    return Document(net, rows, columns, formulation, SAMPLES)
