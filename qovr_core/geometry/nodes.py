"""Nodes: what the knots of a smooth family of curves say, namely where the points lie along the parameter.

To every row of points belongs one node, and the nodes increase. In a window with the nodes X_0..X_4

    u = s = (X_2 - X_1) / (X_3 - X_1)    r = (X_1 - X_0) / (X_2 - X_0)    t = (X_3 - X_2) / (X_4 - X_2)

Neighbouring windows then share t and r to the last bit, so their joints are smooth.
"""

from __future__ import annotations

from enum import StrEnum

import numpy as np
import numpy.typing as npt

from qovr_core.arrays import Array, read_only
from qovr_core.errors import QovrError
from qovr_core.geometry.windows import NET_SIZE, STEP


class Spacing(StrEnum):
    """How far apart the nodes of neighbouring points are."""

    UNIFORM = "uniform"
    CHORD_LENGTH = "chord length"
    CENTRIPETAL = "centripetal"

    @property
    def power(self) -> float:
        """The power of the points' distance that it is."""
        return {Spacing.UNIFORM: 0.0, Spacing.CENTRIPETAL: 0.5, Spacing.CHORD_LENGTH: 1.0}[self]


def knots_of_steps(steps: npt.ArrayLike) -> Array:
    """Return the knots (windows, 4) that belong to the differences (2 windows + 2,) of an increasing node sequence.

    Raises
    ------
    ValueError : their number is that of no net, or one is not positive
    """
    d = np.asarray(steps, dtype=np.float64)
    if d.ndim != 1 or len(d) < NET_SIZE - 1 or len(d) % STEP or not (d > 0).all():
        raise ValueError(f"{d.shape} steps between nodes; expected 4, 6, 8, ... of them, all positive")
    part = d[:-1] / (d[:-1] + d[1:])  # the same division left and right of a joint: t and r are alike to the last bit
    r, u, t = part[:-2:STEP], part[1:-1:STEP], part[2::STEP]
    return read_only(np.stack([r, u, u, t], axis=1))


def steps_of_points(net: Array, spacing: Spacing) -> Array:
    """Return how far apart the nodes along the row curves of a net are: the mean of what each curve says, as parts.

    Parameters
    ----------
    net : (curves, 2 windows + 3, 3)

    Returns
    -------
    (2 windows + 2,) float64, all positive, their sum 1

    Raises
    ------
    QovrError : neighbouring points coincide on every curve, so that their nodes would
    """
    largest = np.abs(net).max() or 1.0  # so that no square overflows
    steps = np.linalg.norm(np.diff(net / largest, axis=1), axis=2) ** spacing.power
    totals = steps.sum(axis=1)
    parts = steps[totals > 0] / totals[totals > 0, None]
    mean = parts.mean(axis=0) if len(parts) else np.zeros(steps.shape[1])
    for k in np.nonzero(mean == 0)[0].tolist():
        raise QovrError(f"The points {k} and {k + 1} of every curve coincide; expected points apart, or uniform knots")
    return read_only(mean)
