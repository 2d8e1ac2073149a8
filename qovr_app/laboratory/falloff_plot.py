"""Displacement against distance: every sample, the envelope, and the best exponential."""

from __future__ import annotations

import numpy as np
import pyqtgraph as pg
from PySide6.QtCore import QEvent, QPointF, Qt, Signal
from PySide6.QtGui import QColor, QFont
from PySide6.QtWidgets import QWidget

from qovr_app.laboratory.influence_numbers import DISTANCE
from qovr_app.view3d.theme import Theme
from qovr_core.arrays import Array
from qovr_core.laboratory.influence import Influence

_EVERY = 4
"""Each fourth sample along u and v is a dot: as many as can be told apart in a plot of this size."""

_FLOOR = 1e-5
"""The logarithmic scale ends at this part of the largest displacement: below it is nothing to see."""

_CURVE_POINTS = 121
_FONT_PIXELS = 11
_WARN = {True: (240, 180, 80), False: (176, 104, 0)}


class FalloffPlot(pg.PlotWidget):
    """Shows how an influence falls off with the distance from the place of the largest displacement.

    Signals
    -------
    hovered : the distance under the pointer; None when it has left the plot
    """

    hovered = Signal(object)

    def __init__(self, name: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName(name)
        self.setAccessibleName("Displacement against distance")
        self.setMinimumSize(150, 110)
        self.setMenuEnabled(False)
        self.setMouseEnabled(x=False, y=False)
        self.hideButtons()
        self._influence: Influence | None = None
        self._is_logarithmic = False
        self._samples = self.plot(pen=None, symbol="o", symbolSize=2.5, pxMode=True, symbolPen=None)
        self.exponential = self.plot(antialias=True)
        self.envelope = self.plot(antialias=True)
        self._reading = pg.InfiniteLine(angle=90)
        self._reading.setVisible(False)
        self.addItem(self._reading, ignoreBounds=True)
        self.setToolTip(f"Displacement of the surface against the distance d. {DISTANCE}")
        self.setLabel("bottom", "<i>d</i> in <i>u</i>, <i>v</i>")
        self.scene().sigMouseMoved.connect(self._on_mouse_moved)

    @property
    def envelope_colour(self) -> str:
        """The colour of the envelope, as rich text names it."""
        return self._colours[0].name()

    @property
    def exponential_colour(self) -> str:
        """The colour of the exponential, as rich text names it."""
        return self._colours[1].name()

    def show_theme(self, theme: Theme) -> None:
        """Draw in other colours."""
        is_dark = sum(theme.background) < sum(theme.ink)
        self._colours = (QColor(*theme.accent), QColor(*_WARN[is_dark]))
        self.setBackground(QColor(*theme.background))
        font = QFont(self.font())
        font.setPixelSize(_FONT_PIXELS)
        for side in ("left", "bottom"):
            axis = self.getAxis(side)
            axis.enableAutoSIPrefix(False)
            axis.setPen(QColor(*theme.axis))
            axis.setTextPen(QColor(*theme.quiet_ink))
            axis.setStyle(tickFont=font, tickLength=-4, autoExpandTextSpace=True)
            axis.label.setFont(font)
        self._samples.setSymbolBrush(QColor(*theme.quiet_ink, 110))
        self.envelope.setPen(pg.mkPen(self._colours[0], width=2))
        self.exponential.setPen(pg.mkPen(self._colours[1], width=2, style=Qt.PenStyle.DashLine))
        self._reading.setPen(pg.mkPen(QColor(*theme.axis), width=1))

    def show_logarithmic(self, is_logarithmic: bool) -> None:
        """Choose the scale of the displacement."""
        self._is_logarithmic = is_logarithmic
        self.setLogMode(x=False, y=is_logarithmic)
        if self._influence is not None:
            self.show_influence(self._influence)

    def show_influence(self, influence: Influence) -> None:
        """Show an influence in which something moves."""
        self._influence = influence
        fall = influence.falloff
        distances = np.linspace(0.0, fall.envelope[-1, 0], _CURVE_POINTS)
        thinned = (slice(None, None, _EVERY),) * 2
        self._put(self._samples, fall.distance[thinned].ravel(), influence.magnitude[thinned].ravel())
        self._put(self.envelope, *fall.envelope.T)
        self._put(self.exponential, distances, fall.exponential.at(distances))
        top = max(influence.largest, fall.exponential.amplitude)
        low, high = (np.log10([_FLOOR * top, 2 * top])) if self._is_logarithmic else (0.0, 1.04 * top)
        self.setXRange(0.0, float(distances[-1]), padding=0.01)
        self.setYRange(float(low), float(high), padding=0)

    def _put(self, item: pg.PlotDataItem, distance: Array, displacement: Array) -> None:
        """Show a series; what is nothing has no place on a logarithmic scale."""
        if self._is_logarithmic:
            kept = displacement > _FLOOR * self._influence.largest
            distance, displacement = distance[kept], displacement[kept]
        item.setData(distance, displacement)

    def _on_mouse_moved(self, at: QPointF) -> None:
        box = self.getViewBox()
        distance = box.mapSceneToView(at).x() if box.sceneBoundingRect().contains(at) else -1.0
        is_inside = self._influence is not None and 0 <= distance <= self._influence.falloff.envelope[-1, 0]
        self._read(distance if is_inside else None)

    def leaveEvent(self, event: QEvent) -> None:
        super().leaveEvent(event)
        self._read(None)

    def _read(self, distance: float | None) -> None:
        self._reading.setVisible(distance is not None)
        if distance is not None:
            self._reading.setValue(distance)
        self.hovered.emit(distance)
