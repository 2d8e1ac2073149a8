"""Quiet plots in the program's own colours, for the panels of the laboratory."""

from __future__ import annotations

from typing import TypeVar

from PySide6.QtCore import QEvent, QPointF, QSize, Qt, Signal
from PySide6.QtGui import QFont, QPen, QResizeEvent
from PySide6.QtWidgets import QFrame, QGraphicsObject, QLabel, QSizePolicy, QVBoxLayout, QWidget

from qovr_app.laboratory import pg
from qovr_app.style.fonts import small_number_font
from qovr_app.style.palette import theme_in_force
from qovr_app.style.spacing import SPACE
from qovr_app.style.theme import Theme
from qovr_app.widgets.parts import named

Line = pg.PlotCurveItem
Series = pg.PlotDataItem
Dots = pg.ScatterPlotItem
Text = pg.TextItem
Rule = pg.InfiniteLine

Item = TypeVar("Item", bound=QGraphicsObject)

_LABEL_MARGIN = 1
_GRID = 0.16
_PADDING = 0.04


class Plot(pg.PlotWidget):
    """A plot with two axes, numbers on them, and a faint grid. It has no menu and no buttons.

    Signals
    -------
    hovered : (x, y) under the mouse in the plot's own units; None when the mouse has gone
    """

    hovered = Signal(object)

    def __init__(self, name: str, spoken: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName(name)
        self.setAccessibleName(spoken)
        self.setFrameShape(QFrame.Shape.NoFrame)
        self.setAntialiasing(True)
        self.setMenuEnabled(False)
        self.hideButtons()
        self.view_box.setDefaultPadding(_PADDING)
        self.small_font = small_number_font(self.font())
        for side in ("left", "bottom"):
            axis = self.getAxis(side)
            axis.setStyle(tickFont=self.small_font, tickLength=4, tickTextOffset=3)
            axis.label.setFont(self.small_font)
            axis.enableAutoSIPrefix(False)
        self.getAxis("left").setStyle(autoExpandTextSpace=False, tickTextWidth=28)
        self.getAxis("bottom").setStyle(tickTextHeight=12)
        self.showGrid(x=True, y=True, alpha=_GRID)
        self.scene().sigMouseMoved.connect(self._on_mouse_moved)
        self.colours = theme_in_force()

    def minimumSizeHint(self) -> QSize:
        return QSize(100, 60)

    @property
    def view_box(self) -> pg.ViewBox:
        """What maps the plot's units to pixels."""
        return self.getPlotItem().getViewBox()

    def show_theme(self, theme: Theme) -> None:
        """Draw in other colours."""
        self.colours = theme
        self.setBackground(theme.background)
        for side in ("left", "bottom"):
            axis = self.getAxis(side)
            axis.setPen(self.pen(theme.axis))
            axis.setTextPen(self.pen(theme.quiet_ink))

    def pen(self, colour: pg.Colour, width: float = 1.0, style: Qt.PenStyle = Qt.PenStyle.SolidLine) -> QPen:
        """Return a pen that is so many logical pixels wide at any scale of the plot."""
        return pg.make_pen(colour, width * self.devicePixelRatioF(), style)

    def event(self, event: QEvent) -> bool:
        if event.type() == QEvent.Type.DevicePixelRatioChange:
            self.show_theme(self.colours)
        return super().event(event)

    def make_line(self, *, bounds: bool = True) -> Line:
        """Return a new line in the plot; without ``bounds`` the plot's range does not follow it."""
        return self._added(Line(), bounds=bounds)

    def make_dots(self, size: float) -> Dots:
        """Return new discs in the plot, so many pixels wide."""
        return self._added(Dots(size=size))

    def make_text(self) -> Text:
        """Return a new label in the plot, centred on its place."""
        text = Text(anchor=(0.5, 0.5))
        text.textItem.document().setDocumentMargin(_LABEL_MARGIN)
        text.setFont(self.small_font)
        return self._added(text)

    def make_upright(self) -> Rule:
        """Return a new line from bottom to top."""
        return self._added(Rule(angle=90))

    def settle(self) -> None:
        """Bring range and axes to what is drawn now; left to the next painting, they would ask for another one."""
        self.scene().prepareForPaint()

    def _added(self, item: Item, *, bounds: bool = False) -> Item:
        self.addItem(item, ignoreBounds=not bounds)
        return item

    def leaveEvent(self, event: QEvent) -> None:
        super().leaveEvent(event)
        self.hovered.emit(None)

    def _on_mouse_moved(self, position: QPointF) -> None:
        if self.view_box.sceneBoundingRect().contains(position):
            place = self.view_box.mapSceneToView(position)
            self.hovered.emit((place.x(), place.y()))
        else:
            self.hovered.emit(None)


class Captioned(QWidget):
    """A plot under one line of text."""

    def __init__(self, plot: QWidget, font: QFont, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._texts: tuple[str, ...] = ("",)
        self._label = named(QLabel(self), f"{plot.objectName()}.caption")
        self._label.setTextFormat(Qt.TextFormat.RichText)
        self._label.setFont(font)
        self._label.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)
        self._label.setContentsMargins(SPACE, 1, SPACE, 1)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(0)
        layout.addWidget(self._label)
        layout.addWidget(plot, 1)

    def say(self, *texts: str) -> None:
        """Show the first of several rich texts that the width has room for, the last one if none fits."""
        if texts != self._texts:  # another text makes everything around the label lay itself out
            self._texts = texts
            self._fit()

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._fit()

    def _fit(self) -> None:
        for text in self._texts:
            self._label.setText(text)
            if self._label.sizeHint().width() <= self.width():
                return
