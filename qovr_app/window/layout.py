"""The window's middle: the four zones in the paper's places, and the view beside them."""

from __future__ import annotations

from PySide6.QtCore import QByteArray, QSize, Qt
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QApplication, QFrame, QScrollArea, QSizePolicy, QToolBar, QVBoxLayout, QWidget

from qovr_app.laboratory.dock import LaboratoryDock
from qovr_app.state.editor_state import EditorState
from qovr_app.store import Listener, Store
from qovr_app.widgets.number_field import NumberField
from qovr_app.widgets.splitter import LineSplitter
from qovr_app.window.view_frame import ViewFrame
from qovr_app.work.worker import Worker
from qovr_app.zones.knots_zone import KnotsZone
from qovr_app.zones.points_zone import PointsZone
from qovr_app.zones.surface_zone import SurfaceZone
from qovr_app.zones.zone import FieldZone
from qovr_core.edits import Zone
from qovr_core.geometry.knots import Direction

_LEFT, _MIDDLE = 264, 364
"""First widths of the two columns: as narrow as four digits stay readable, which leaves the view half of 1280."""

_STACKED_BELOW = 2 * (_LEFT + _MIDDLE) - _LEFT // 2
"""Where two columns would leave the view much less than half, the zones stand in one."""

_LOWER = 260
_LEAST_VIEW = 240
"""Narrower, a picture of the surface says nothing."""

_VIEW, _LABORATORY = 4000, 330
"""First heights on the view's side: the laboratory keeps its own, and the view gets what is left."""


class Layout(LineSplitter):
    """Zones, view and laboratory in splitters."""

    def __init__(self, store: Store, worker: Worker, parent: QWidget | None = None) -> None:
        super().__init__("workspace", Qt.Orientation.Horizontal, parent)
        self.rows = KnotsZone(Direction.ROWS, store, self)
        self.columns = KnotsZone(Direction.COLUMNS, store, self)
        self.points = PointsZone(store, self)
        self.surface = SurfaceZone(store, self)
        self.view_frame = ViewFrame(store, self)
        self.laboratory = LaboratoryDock(store, worker, self)
        self._zones: dict[str, FieldZone | SurfaceZone] = {
            Zone.ROW_KNOTS: self.rows,
            Zone.COLUMN_KNOTS: self.columns,
            Zone.CONTROL_POINTS: self.points,
            "surface": self.surface,
        }
        self.field_zones: tuple[FieldZone, ...] = (self.rows, self.columns, self.points)
        self._splitters: dict[str, LineSplitter] = {"workspace": self}
        self._zones_side = QWidget(self)
        self._view_side = QWidget(self)
        self._arrange()

    def add_bars(self, edit_bar: QToolBar, view_bar: QToolBar) -> None:
        """Put the bars over what they belong to."""
        for bar, side in zip((edit_bar, view_bar), self._sides, strict=True):
            bar.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)
            side.insertWidget(0, bar)

    @property
    def shows(self) -> tuple[Listener, ...]:
        """What shows states in every part, the view first: what is waited for is its frame."""
        zones = (zone.show_state for zone in self._zones.values())
        return (self.view_frame.show_state, self.laboratory.show_state, *zones, self._show_sides)

    def _show_sides(self, _before: EditorState | None, after: EditorState) -> None:
        self._zones_side.setVisible(after.shows_zones)

    def commit_typed(self) -> None:
        """Take what is typed in the field that has the keyboard, as leaving the field would."""
        widget = QApplication.focusWidget()
        if isinstance(widget, NumberField) and self.isAncestorOf(widget):
            widget.commit()

    def current_zone(self) -> FieldZone:
        """Return the zone of fields that has the keyboard; the control points where none has."""
        widget = QApplication.focusWidget()
        return next(
            (zone for zone in self.field_zones if widget is not None and zone.isAncestorOf(widget)), self.points
        )

    def focus_part(self, name: str) -> None:
        """Bring the keyboard to a zone or to the view."""
        if name == "view":
            self.view_frame.focus_view()
        else:
            self._zones[name].focus_first()
            if (focused := QApplication.focusWidget()) is not None and self._area.isAncestorOf(focused):
                self._area.ensureWidgetVisible(focused)

    def layout_states(self) -> dict[str, QByteArray]:
        """Return the states of all splitters by name."""
        return {name: splitter.saveState() for name, splitter in self._splitters.items()}

    def restore_layout(self, name: str, state: QByteArray) -> None:
        """Bring a splitter into a state it had."""
        self._splitters[name].restoreState(state)

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        if self._splitters["columns"].orientation() != self._orientation:
            self._turn_columns()

    @property
    def _orientation(self) -> Qt.Orientation:
        """Whether the columns of zones stand beside or below each other."""
        return Qt.Orientation.Vertical if self.width() < _STACKED_BELOW else Qt.Orientation.Horizontal

    def _turn_columns(self) -> None:
        """Bring the columns beside or below each other; below, every zone has its whole height, and they scroll."""
        is_stacked = self._orientation == Qt.Orientation.Vertical
        columns, policy = self._splitters["columns"], QSizePolicy.Policy
        columns.setOrientation(self._orientation)
        for zone in self._zones.values():
            zone.setSizePolicy(policy.Preferred, policy.Minimum if is_stacked else policy.Preferred)
        columns.setSizes([_MIDDLE, _MIDDLE] if is_stacked else [_LEFT, _MIDDLE])
        for name in ("left", "middle"):
            self._splitters[name].setSizes([self.points.sizeHint().height(), _LOWER])
        needed = max(columns.minimumSizeHint().width(), _MIDDLE if is_stacked else _LEFT + _MIDDLE)
        width = needed + self._area.verticalScrollBar().sizeHint().width() * is_stacked
        self.setSizes([width, max(self.width() - width, width)])

    def _arrange(self) -> None:
        left = self._column("left", self.rows, self.columns)
        middle = self._column("middle", self.points, self.surface)
        inner = self._splitter("columns", Qt.Orientation.Horizontal, left, middle)
        inner.setSizes([_LEFT, _MIDDLE])
        inner.setStretchFactor(1, 1)
        self._area = _ZonesArea(inner, self._zones_side)
        outer = self._splitter("laboratory", Qt.Orientation.Vertical, self.view_frame, self.laboratory)
        outer.setChildrenCollapsible(False)
        outer.setSizes([_VIEW, _LABORATORY])
        outer.setStretchFactor(0, 1)
        sides = (self._zones_side, self._area), (self._view_side, outer)
        self._sides = [_side(side, content) for side, content in sides]
        self._view_side.setMinimumWidth(_LEAST_VIEW)
        self.addWidget(self._zones_side)
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


class _ZonesArea(QScrollArea):
    """Lets the zones scroll where the window is low or narrow."""

    def __init__(self, zones: QWidget, parent: QWidget) -> None:
        super().__init__(parent)
        self._content = zones
        self.setWidget(zones)
        self.setObjectName("zones")
        self.setFrameShape(QFrame.Shape.NoFrame)
        self.setWidgetResizable(True)
        self.setFocusPolicy(Qt.FocusPolicy.NoFocus)

    def minimumSizeHint(self) -> QSize:
        return QSize(_LEFT, _LOWER)

    def sizeHint(self) -> QSize:
        """Return the size of the zones, not Qt's guess."""
        return self._content.sizeHint()


def _side(side: QWidget, content: QWidget) -> QVBoxLayout:
    """Return the layout of one side of the window, with room for a bar over its content."""
    layout = QVBoxLayout(side)
    layout.setContentsMargins(0, 0, 0, 0)
    layout.setSpacing(0)
    layout.addWidget(content, 1)
    return layout
