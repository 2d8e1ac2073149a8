"""The window's middle: the four zones in the paper's places, and the view beside them."""

from __future__ import annotations

from PySide6.QtCore import QByteArray, Qt
from PySide6.QtWidgets import QApplication, QSizePolicy, QToolBar, QVBoxLayout, QWidget

from qovr_app.controller import Controller, State
from qovr_app.panels.knots_zone import KnotsZone
from qovr_app.panels.points_zone import PointsZone
from qovr_app.panels.splitter import LineSplitter
from qovr_app.panels.surface_zone import SurfaceZone
from qovr_app.panels.zone import FieldZone
from qovr_app.view_place import ViewPlace
from qovr_core.edits import Direction

_LEFT, _MIDDLE = 264, 364
"""First widths of the two columns: as narrow as four digits stay readable, which leaves the view half of 1280."""

_LOWER = 260


class Workspace(LineSplitter):
    """Zones and view in splitters. It hands states to the zones and the zones' intents to the controller."""

    def __init__(self, controller: Controller, parent: QWidget | None = None) -> None:
        super().__init__("workspace", Qt.Orientation.Horizontal, parent)
        self.rows = KnotsZone(Direction.ROWS, self)
        self.columns = KnotsZone(Direction.COLUMNS, self)
        self.points = PointsZone(self)
        self.surface = SurfaceZone(self)
        self.place = ViewPlace(self)
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
        self.surface.show_state(state.document, state.result, is_stale=state.is_stale)
        self.place.set_stale(state.is_stale)

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
        for side, content in ((self._panels, inner), (self._view_side, self.place)):
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
