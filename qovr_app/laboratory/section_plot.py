"""The pieces of a section, drawn in their plane."""

from __future__ import annotations

from itertools import zip_longest

import numpy as np
from PySide6.QtWidgets import QWidget

from qovr_app.laboratory.plots import Line, Plot
from qovr_app.style.theme import Theme
from qovr_core.geometry.section import CuttingPlane, SectionCurve


class SectionPlot(Plot):
    """Draws every piece of a section."""

    def __init__(self, name: str, parent: QWidget | None = None) -> None:
        super().__init__(name, "The section in its plane", parent)
        self.setMouseEnabled(x=False, y=False)
        self.lines: list[Line] = []

    def show_theme(self, theme: Theme) -> None:
        super().show_theme(theme)
        for line in self.lines:
            line.setPen(self.pen(theme.section, 2.2))

    def show_section(self, plane: CuttingPlane | None, pieces: tuple[SectionCurve, ...]) -> None:
        """Draw pieces, and nothing else."""
        while len(self.lines) < len(pieces):
            self.lines.append(self.make_line())
            self.lines[-1].setPen(self.pen(self.colours.section, 2.2))
        for line, piece in zip_longest(self.lines, pieces):
            drawn = np.empty((0, 2)) if piece is None or plane is None else plane.drawn(piece.points)
            line.setData(drawn[:, 0], drawn[:, 1])
        for side, label in zip(("bottom", "left"), plane.labels if plane else ("", ""), strict=True):
            self.setLabel(side, f"<i>{label}</i>" if len(label) == 1 else label)
        self.settle()
