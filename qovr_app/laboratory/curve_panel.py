"""One curve of the surface, laid open: the paper's Figure 1, live."""

from __future__ import annotations

from qovr_app.laboratory.panel import LaboratoryPanel
from qovr_core import AlignedPatch


class CurvePanel(LaboratoryPanel):
    """Shows one of the ten curves."""

    def show_result(self, result: AlignedPatch) -> None:
        """Show the curve of a result."""
