"""The window's middle: the four zones in the paper's places, and the view beside them."""

from __future__ import annotations

from PySide6.QtCore import QByteArray, Qt, Signal
from PySide6.QtWidgets import QApplication, QSizePolicy, QToolBar, QVBoxLayout, QWidget

from qovr_app.laboratory.dock import LaboratoryPlace
from qovr_app.laboratory.panel import Focus
from qovr_app.widgets.number_field import NumberField
from qovr_app.widgets.splitter import LineSplitter
from qovr_app.window.controller import Controller, State
from qovr_app.window.view_frame import ViewPlace
from qovr_app.work.worker import Worker
from qovr_app.zones.knots_zone import KnotsZone
from qovr_app.zones.points_zone import PointsZone
from qovr_app.zones.surface_zone import SurfaceZone
from qovr_app.zones.zone import FieldZone
from qovr_core.edits import Direction, KnotPlace

_LEFT, _MIDDLE = 264, 364
"""First widths of the two columns: as narrow as four digits stay readable, which leaves the view half of 1280."""

_LOWER = 260

_VIEW, _LABORATORY = 4000, 330
"""First heights on the view's side: the laboratory keeps its own, and the view gets what is left."""


class Workspace(LineSplitter):
    """Zones, view and laboratory in splitters. It hands states to the zones and their intents to the controller.

    Signals
    -------
    focus_changed : the KnotPlace whose field has the keyboard, or the (i, j) of the point selected, whichever came last
    """

    focus_changed = Signal(object)

    def __init__(self, controller: Controller, worker: Worker, parent: QWidget | None = None) -> None:
        super().__init__("workspace", Qt.Orientation.Horizontal, parent)
        self.rows = KnotsZone(Direction.ROWS, self)
        self.columns = KnotsZone(Direction.COLUMNS, self)
        self.points = PointsZone(self)
        self.surface = SurfaceZone(self)
        self.place = ViewPlace(self)
        self.laboratory = LaboratoryPlace(worker, self)
        self.focus: Focus = None
        self.field_zones: tuple[FieldZone, ...] = (self.rows, self.columns, self.points)
        self._splitters: dict[str, LineSplitter] = {"workspace": self}
        self._panels = QWidget(self)
        self._view_side = QWidget(self)
        self._arrange()
        self._connect(controller)

    def add_bars(self, edit_bar: QToolBar, view_bar: QToolBar) -> None:
        """Put the bars over what they belong to."""
        for bar, side in ((edit_bar, self._panels), (view_bar, self._view_side)):
            bar.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)
            side.layout().insertWidget(0, bar)

    def show_state(self, state: State) -> None:
        """Show a state in all zones."""
        for zone in self.field_zones:
            zone.show_documents(state.document, state.draft)
        self.surface.show_state(state.document, state.evaluation, is_stale=state.is_stale)
        self.place.set_stale(state.is_stale)
        self.laboratory.set_stale(state.is_stale)

    def set_focus(self, focus: Focus) -> None:
        """Take note of what the user has turned to; letting go of a point leaves a knot in focus."""
        if focus != self.focus and not (focus is None and isinstance(self.focus, KnotPlace)):
            self.focus = focus
            self.focus_changed.emit(focus)

    def commit_typed(self) -> None:
        """Take what is typed in the field that has the keyboard, as leaving the field would."""
        widget = QApplication.focusWidget()
        if isinstance(widget, NumberField) and self.isAncestorOf(widget):
            widget.commit()

    def drop_text(self) -> None:
        """Drop what is typed in any zone and was never taken."""
        for zone in (*self.field_zones, self.surface):
            zone.drop_text()

    def current_zone(self) -> FieldZone:
        """Return the zone of fields that has the keyboard; the control points where none has."""
        widget = QApplication.focusWidget()
        return next(
            (zone for zone in self.field_zones if widget is not None and zone.isAncestorOf(widget)), self.points
        )

    def show_panels(self, is_shown: bool) -> None:
        """Show or hide the four zones."""
        self._panels.setVisible(is_shown)

    def layout_states(self) -> dict[str, QByteArray]:
        """Return the states of all splitters by name."""
        return {name: splitter.saveState() for name, splitter in self._splitters.items()}

    def restore_layout(self, name: str, state: QByteArray) -> None:
        """Bring a splitter into a state it had."""
        self._splitters[name].restoreState(state)

    def _arrange(self) -> None:
        left = self._column("left", self.rows, self.columns)
        middle = self._column("middle", self.points, self.surface)
        inner = self._splitter("columns", Qt.Orientation.Horizontal, left, middle)
        inner.setSizes([_LEFT, _MIDDLE])
        inner.setStretchFactor(1, 1)
        outer = self._splitter("laboratory", Qt.Orientation.Vertical, self.place, self.laboratory)
        outer.setChildrenCollapsible(False)
        outer.setSizes([_VIEW, _LABORATORY])
        outer.setStretchFactor(0, 1)
        for side, content in ((self._panels, inner), (self._view_side, outer)):
            layout = QVBoxLayout(side)
            layout.setContentsMargins(0, 0, 0, 0)
            layout.setSpacing(0)
            layout.addWidget(content, 1)
        self.addWidget(self._panels)
        self.addWidget(self._view_side)
        self.setCollapsible(1, False)
        self.setStretchFactor(1, 1)
        self.setSizes([_LEFT + _MIDDLE, 10 * _MIDDLE])

    def _column(self, name: str, upper: QWidget, lower: QWidget) -> LineSplitter:
        column = self._splitter(name, Qt.Orientation.Vertical, upper, lower)
        column.setSizes([self.points.sizeHint().height(), _LOWER])
        column.setStretchFactor(1, 1)
        return column

    def _splitter(self, name: str, orientation: Qt.Orientation, *parts: QWidget) -> LineSplitter:
        splitter = LineSplitter(f"splitter.{name}", orientation, self)
        for part in parts:
            splitter.addWidget(part)
        self._splitters[name] = splitter
        return splitter

    def _connect(self, controller: Controller) -> None:
        for zone in self.field_zones:
            zone.values_edited.connect(controller.edit)
            zone.values_pasted.connect(controller.paste)
            zone.set_requested.connect(lambda typed, zone=zone: controller.set_zone(zone.zone, typed))
            zone.get_requested.connect(lambda zone=zone: controller.get_zone(zone.zone))
            zone.refused.connect(controller.refused)
        self.rows.formulation_requested.connect(controller.set_formulation)
        self.surface.formulation_edited.connect(controller.set_formulation)
        self.surface.samples_edited.connect(controller.set_samples)
        self.surface.configure_requested.connect(controller.configure)
        self.surface.refused.connect(controller.refused)
        controller.state_changed.connect(self.show_state)
        for knots in (self.rows, self.columns):
            knots.knot_focused.connect(self.set_focus)
        self.points.point_focused.connect(lambda i, j: self.set_focus((i, j)))
        controller.evaluation_changed.connect(lambda _evaluation, document: self.laboratory.show_document(document))
        self.focus_changed.connect(self.laboratory.show_focus)
        self.laboratory.values_edited.connect(controller.edit)
