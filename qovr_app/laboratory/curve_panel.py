"""One curve of the surface with all its parts: the paper's Figure 1, live."""

from __future__ import annotations

from PySide6.QtWidgets import QCheckBox, QComboBox, QGridLayout, QHBoxLayout, QVBoxLayout, QWidget

from qovr_app.laboratory.curve_drawings import CurveDrawing, Drawing
from qovr_app.laboratory.curve_functions import WeightsPlot
from qovr_app.laboratory.curve_geometry import GeometryPlot
from qovr_app.laboratory.curve_transformations import TransformationsPlot
from qovr_app.laboratory.panel import LaboratoryPanel
from qovr_app.laboratory.plots import Captioned
from qovr_app.state.editor_state import EditorState, Focus
from qovr_app.state.intents import ValuesEdited
from qovr_app.state.requests import DrawingAsked
from qovr_app.store import Store
from qovr_app.style.palette import theme_in_force
from qovr_app.style.spacing import SPACE
from qovr_app.style.symbols import coloured, symbol_html
from qovr_app.style.theme import theme_of
from qovr_app.widgets.parts import CompactButton
from qovr_app.work.worker import Worker
from qovr_core import Document, QovrError
from qovr_core.document import NET_SIZE
from qovr_core.geometry.knots import Direction, KnotPlace
from qovr_core.laboratory.one_curve import SAMPLES, OneCurve, curve_of
from qovr_core.laboratory.planes import View
from qovr_core.number_texts import number_text

_CURVES = [(direction, k) for direction in Direction for k in range(NET_SIZE)]
_SUBSCRIPTS = "₀₁₂₃₄"
_VIEWS = {View.BEST: "Best plane", View.XY: "x, y", View.XZ: "x, z", View.YZ: "y, z"}

_TIPS = (
    """Thin: the parabolas Q_0, Q_1, Q_2 between their points
Broad: what of them is blended
Dashed: what is blended beyond their points
Rings: where the parameter is 0, its internal knot, and 1""",
    "How much each parabola counts: (1-u)^2, 2u(1-u) and u^2",
    "How much each point counts; the five weights sum to 1",
    """Drag the rings: r_ip on the left edge, s_ip and u_ip in the middle, t_ip on the right edge
While the middle ring lies in the shaded lens, s does not fold back""",
)
"""What each plot shows, in the order of the plots."""

_LEGENDS = ({}, {"decimals": 2}, {"decimals": 2, "named": False})
"""How values are written over a plot, at length and shorter."""


class CurvePanel(LaboratoryPanel):
    """Shows one of the ten curves: that of the knot in focus, or a chosen one."""

    def __init__(self, store: Store, worker: Worker, parent: QWidget | None = None) -> None:
        super().__init__(store, worker, parent)
        self._document: Document | None = None
        self._curve: OneCurve | None = None
        self._choice = QComboBox(self, objectName="laboratory.curve.choice", accessibleName="Curve")
        self._choice.setToolTip("Which of the ten curves; it follows the knot whose field has the keyboard")
        for direction, k in _CURVES:
            self._choice.addItem(f"{direction.letter}{_SUBSCRIPTS[k]}({direction.parameter})")
        self._choice.setCurrentIndex(NET_SIZE - 1)  # the one row that the published surface uses
        self._view = QComboBox(self, objectName="laboratory.curve.plane", accessibleName="Plane")
        self._view.setToolTip("The plane in which the curve is drawn; the best one runs through its points")
        self._view.addItems(_VIEWS.values())
        self._equal = QCheckBox("Equal scales", self, objectName="laboratory.curve.equal_scales")
        self._equal.setToolTip("Draw both directions of the plane at one scale")
        self._drawing = QComboBox(self, objectName="laboratory.curve.drawing", accessibleName="Figure to save")
        self._drawing.setToolTip(
            "What Save Figure writes: the curve as it is shown here, or as in the paper's Figures 1 and 2"
        )
        self._drawing.addItems(list(Drawing))
        self._geometry = GeometryPlot(self)
        weights = [symbol_html("w", str(p)) for p in range(3)]
        points = [symbol_html("b", str(k)) for k in range(5)]
        self._blends = WeightsPlot(
            "laboratory.curve.blends", "The weights of the three parabolas", weights, [1, 2, 3], self
        )
        self._weights = WeightsPlot(
            "laboratory.curve.weights", "The weights of the five points", points, [0, 1, 2, 3, 4], self
        )
        self._transformations = TransformationsPlot(self)
        for plot, tip in zip(self._plots, _TIPS, strict=True):
            plot.setToolTip(tip)
        self._arrange()
        self._connect()

    @property
    def curve(self) -> OneCurve | None:
        """The curve that is shown."""
        return self._curve

    def show_state(self, before: EditorState | None, after: EditorState) -> None:
        if before is None or before.display.theme != after.display.theme:
            for plot in self._plots:
                plot.show_theme(theme_of(after.display.theme))
            self._show_captions(None)
        if before is None or before.focus != after.focus:
            self._follow(after.focus)
        if after.differs(before, "shown_document"):
            self._document = after.shown_document
            self._show_curve()

    def _follow(self, focus: Focus) -> None:
        """Choose the curve of the knot in focus, or the curve of the same direction through the point in focus."""
        if focus is None:
            return
        direction, k = _CURVES[self._choice.currentIndex()]
        if isinstance(focus, KnotPlace):
            direction, k = focus.direction, focus.curve
        else:
            k = focus[0] if direction is Direction.ROWS else focus[1]
        self._choice.setCurrentIndex(_CURVES.index((direction, k)))

    @property
    def _chosen_view(self) -> View:
        return list(_VIEWS)[self._view.currentIndex()]

    @property
    def _functions(self) -> tuple:
        return self._blends, self._weights, self._transformations

    @property
    def _plots(self) -> tuple:
        return self._geometry, *self._functions

    def _arrange(self) -> None:
        save = CompactButton("Save Figure…", "laboratory.curve.figure", "Write it as PNG, SVG or PDF", self)
        save.clicked.connect(self._save_figure)
        head = QHBoxLayout()
        head.setContentsMargins(2 * SPACE, SPACE, 2 * SPACE, SPACE)
        head.setSpacing(2 * SPACE)
        for widget in (self._choice, self._view, self._equal):
            head.addWidget(widget)
        head.addStretch(1)
        head.addWidget(self._drawing)
        head.addWidget(save)
        grid = QGridLayout()
        grid.setSpacing(1)
        self._captions = {}
        for plot, place in zip(self._plots, ((0, 0, 2, 1), (0, 1, 1, 1), (1, 1, 1, 1), (0, 2, 2, 1)), strict=True):
            captioned = Captioned(plot, self)
            self._captions[plot] = captioned
            grid.addWidget(captioned, *place)
        for column, stretch in enumerate((5, 4, 4)):
            grid.setColumnStretch(column, stretch)
        for row in range(2):
            grid.setRowStretch(row, 1)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(0)
        layout.addLayout(head)
        layout.addLayout(grid, 1)

    def _connect(self) -> None:
        self._choice.currentIndexChanged.connect(self._show_curve)
        self._view.currentIndexChanged.connect(self._show_curve)
        self._equal.toggled.connect(self._geometry.setAspectLocked)
        self._geometry.hovered.connect(
            lambda place: self._show_hover(place and self._curve and self._geometry.nearest(place))
        )
        for plot in self._functions:
            plot.hovered.connect(lambda place: self._show_hover(place and min(max(place[0], 0.0), 1.0)))
        self._transformations.knots_moved.connect(self._on_knots_moved)

    # The curve

    def _show_curve(self) -> None:
        if self._document is None:
            return
        try:
            curve = curve_of(self._document, *_CURVES[self._choice.currentIndex()])
        except QovrError as error:
            self.tell(f"{error}.", is_refusal=True)
            return
        self._curve = curve
        self._geometry.show_curve(curve, self._chosen_view)
        self._blends.show_weights(curve.blends(SAMPLES), curve.knots.u)
        self._weights.show_weights(curve.weights(SAMPLES), curve.knots.u)
        self._transformations.show_curve(curve)
        self._show_hover(None)

    def _on_knots_moved(self, wanted: dict[str, float], gesture: int) -> None:
        direction, k = self._curve.direction, self._curve.number
        values = {KnotPlace(direction, k, name): value for name, value in wanted.items()}
        self.store.dispatch(ValuesEdited(values, gesture))

    # What stands over the plots

    def _show_hover(self, u: float | None) -> None:
        if self._curve is None:
            return
        for plot in self._plots:
            plot.show_hover(u)
        self._show_captions(u)

    def _show_captions(self, u: float | None) -> None:
        curve = self._curve
        if curve is None:
            return
        if u is None:
            self._captions[self._geometry].say(*self._what_it_is())
            notes = "of the parabolas", "of the points", self._how_s_runs()
            for plot, note in zip(self._functions, notes, strict=True):
                legend = "&nbsp; ".join(plot.legend())
                self._captions[plot].say(f"{legend}&nbsp;&nbsp; {note}", legend)
            return
        x, y, z = (number_text(round(value, 4)) for value in curve.at([u])[0].tolist())
        self._captions[self._geometry].say(f"<i>{curve.parameter}</i> = {u:.3f}&nbsp;&nbsp; {x}, {y}, {z}")
        for plot, values in zip(self._functions, (curve.blends, curve.weights, curve.transformed), strict=True):
            legends = (plot.legend(values([u])[0], **how) for how in _LEGENDS)
            self._captions[plot].say(*("&nbsp; ".join(legend) for legend in legends))

    def _what_it_is(self) -> tuple[str, ...]:
        """Return what stands over the curve, at length and shorter."""
        curve = self._curve
        name = f"<b>{symbol_html(curve.direction.letter, str(curve.number))}</b>(<i>{curve.parameter}</i>)"
        short = f"{name}, degree {curve.knots.degree}"
        formulation = self._document.formulation
        if not formulation.is_active(curve.direction, curve.number):
            return f"{name}: no effect on the {formulation} surface", f"{name}: no effect"
        return f"{short}&nbsp;&nbsp; broad: blended&nbsp;&nbsp; dashed: beyond its points", short

    def _how_s_runs(self) -> str:
        fold = self._curve.fold_back
        if fold is None:
            return f"over <i>{self._curve.parameter}</i>"
        low, high = fold.backward
        return coloured(f"<i>s</i> falls from {low:.3g} to {high:.3g}", theme_in_force().warn)

    def _save_figure(self) -> None:
        if self._curve is not None:
            kind, document = Drawing(self._drawing.currentText()), self._document
            drawing = CurveDrawing(kind, self._curve, document, self._chosen_view, self._equal.isChecked())
            self.store.dispatch(DrawingAsked(drawing.name, drawing.write))
