"""The controls of the panel of one curve: which curve, in which plane, and what Save Figure writes."""

from __future__ import annotations

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QCheckBox, QComboBox, QWidget

from qovr_app.laboratory.comb_choice import CombChoice
from qovr_app.laboratory.curve_drawings import Drawing
from qovr_app.state.editor_state import Focus
from qovr_app.style.spacing import SPACE
from qovr_app.widgets.flow import Flow, kept_together
from qovr_app.widgets.parts import CompactButton, named
from qovr_app.widgets.wheel import guard_from_wheels
from qovr_core.geometry.knots import Direction, KnotPlace
from qovr_core.geometry.windows import NET_SIZE
from qovr_core.laboratory.planes import View

_NAME = "laboratory.curve"
_CURVES = [(direction, number) for direction in Direction for number in range(NET_SIZE)]
_SUBSCRIPTS = str.maketrans("0123456789", "₀₁₂₃₄₅₆₇₈₉")
_VIEWS = {View.BEST: "Best plane", View.XY: "x, y", View.XZ: "x, z", View.YZ: "y, z"}


class CurveBar(QWidget):
    """Choices of one of a window's curves and of how it is drawn.

    Signals
    -------
    choice_changed : another curve or another plane
    scales_linked : whether both directions of the plane are drawn at one scale
    figure_requested : the button
    """

    choice_changed = Signal()
    scales_linked = Signal(bool)
    figure_requested = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._curve = named(QComboBox(self), f"{_NAME}.choice", "Curve")
        self._curve.setToolTip("Which of the curves; it follows the knot whose field has the keyboard")
        self._curve.addItems([f"{way.letter}{str(k).translate(_SUBSCRIPTS)}({way.parameter})" for way, k in _CURVES])
        self._curve.setCurrentIndex(NET_SIZE - 1)  # the last row is the one that the published surface uses
        self._view = named(QComboBox(self), f"{_NAME}.plane", "Plane")
        self._view.setToolTip("The plane in which the curve is drawn; the best one runs through its points")
        self._view.addItems(list(_VIEWS.values()))
        self._equal = named(QCheckBox("Equal scales", self), f"{_NAME}.equal_scales")
        self._equal.setToolTip("Draw both directions of the plane at one scale")
        self._comb = CombChoice(_NAME, self)
        self._drawing = named(QComboBox(self), f"{_NAME}.drawing", "Figure to save")
        self._drawing.setToolTip(
            "What Save Figure writes: the curve as it is shown here, or as in the paper's Figures 1 and 2"
        )
        self._drawing.addItems(list(Drawing))
        self._save = CompactButton("Save Figure…", f"{_NAME}.figure", "Write it as PNG, SVG or PDF", self)
        self._arrange()
        guard_from_wheels(self._curve, self._view, self._drawing)
        for box in (self._curve, self._view):
            box.currentIndexChanged.connect(lambda _index: self.choice_changed.emit())
        self._equal.toggled.connect(self.scales_linked)
        self._save.clicked.connect(lambda _checked: self.figure_requested.emit())

    @property
    def curve(self) -> tuple[Direction, int]:
        """The chosen curve."""
        return _CURVES[self._curve.currentIndex()]

    @property
    def view(self) -> View:
        """The chosen plane."""
        return list(_VIEWS)[self._view.currentIndex()]

    @property
    def has_equal_scales(self) -> bool:
        """Whether both directions of the plane are drawn at one scale."""
        return self._equal.isChecked()

    @property
    def comb(self) -> CombChoice:
        """Whether the curve has its comb, and how long the teeth are."""
        return self._comb

    @property
    def drawing(self) -> Drawing:
        """What Save Figure writes."""
        return Drawing(self._drawing.currentText())

    def follow(self, focus: Focus) -> None:
        """Choose the curve of the knot in focus, or the curve of the same direction through the point in focus."""
        if focus is None:
            return
        if isinstance(focus, KnotPlace):
            direction, k = focus.direction, focus.curve
        else:
            direction, _ = self.curve
            k = focus[0] if direction is Direction.ROWS else focus[1]
        self._curve.setCurrentIndex(_CURVES.index((direction, k)))

    def _arrange(self) -> None:
        layout = Flow(self, 2 * SPACE)
        layout.setContentsMargins(2 * SPACE, SPACE, 2 * SPACE, SPACE)
        saving = kept_together(self, SPACE, self._drawing, self._save)
        for widget in (self._curve, self._view, self._equal, self._comb, saving):
            layout.addWidget(widget)
