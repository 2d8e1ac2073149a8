"""A surface that no document has: the paper's, under a control net of any shape."""

from types import SimpleNamespace

import numpy as np

from qovr_core import Evaluation, configure
from qovr_core.presets import preset


def net_on_surface(rows, columns):
    """Return a control net (rows, columns, 3) a little above the raw surface of the paper's example."""
    patch = configure(preset("fig5").document).patch
    points = patch.points(np.linspace(0, 1, columns), np.linspace(0, 1, rows)).transpose(1, 0, 2).copy()
    points[..., 2] += 0.02
    return points


class MadeUp:
    """The surface of the paper's example as if these control points (k, l, 3) had made it."""

    def __init__(self, points):
        self.points = points
        self._made_of: Evaluation = configure(preset("fig5").document)
        base = self._made_of.document
        self.document = SimpleNamespace(
            control_points=points, samples=base.samples, formulation=base.formulation, net_size=base.net_size
        )

    @property
    def control_box(self):
        flat = self.points.reshape(-1, 3)
        return np.stack([flat.min(axis=0), flat.max(axis=0)], axis=1)

    def __getattr__(self, name):
        return getattr(self._made_of, name)
