"""The window's middle: zones, view and laboratory, arranged by the room there is."""

from __future__ import annotations

from PySide6.QtCore import QByteArray, Qt
from PySide6.QtGui import QFontInfo, QResizeEvent
from PySide6.QtWidgets import QApplication, QWidget

from qovr_app.laboratory.dock import LaboratoryDock
from qovr_app.laboratory.floating import FloatingWindow
from qovr_app.laboratory.panels import PANELS
from qovr_app.state.editor_state import EditorState
from qovr_app.state.focus import is_net
from qovr_app.state.looking_intents import PanelShown, ZonesShown
from qovr_app.store import Listener, Store
from qovr_app.widgets.number_field import NumberField
from qovr_app.widgets.seen_part import SeenPart
from qovr_app.widgets.splitter import LineSplitter
from qovr_app.window.column import LABORATORY, Column
from qovr_app.window.room import Dock, Form, Room, room_of
from qovr_app.window.view_frame import ViewFrame
from qovr_app.window.zones import Zones
from qovr_app.work.worker import Worker
from qovr_app.zones.net_map import NetMap
from qovr_app.zones.tab_marks import tab_mark
from qovr_app.zones.zone import FieldZone

_USUAL_TEXT = 13
"""Pixels of the largest text that systems use by themselves; where it is larger, everything needs as much more room."""

_LEAST_VIEW = 240
"""Narrower, a picture of the surface says nothing."""

_VIEW = 10_000
"""First size of the view in a splitter: what others leave."""

_OPEN = "_open"
"""What is added to the name of an arrangement in which the laboratory takes the zones' place."""

_OF_ZONES = ("workspace", "columns", "left", "middle")
_KEPT = (
    *(f"{name}.{form}{more}" for name in _OF_ZONES for form in Form for more in ("", _OPEN)),
    *(f"laboratory.{dock}" for dock in Dock),
)
"""What is remembered: the sizes in every splitter, apart for every arrangement."""


class Layout(LineSplitter):
    """Zones, view and laboratory in splitters, in the arrangement that ``room_of`` finds for the window."""

    def __init__(self, store: Store, worker: Worker, parent: QWidget | None = None) -> None:
        super().__init__("workspace", Qt.Orientation.Horizontal, parent)
        self._store = store
        self.zones = Zones(store, self)
        self.view_frame = ViewFrame(store, self)
        self.laboratory = LaboratoryDock(store, worker, self)
        self._map = NetMap(store, self)
        self._map_seen = SeenPart(self._map, self._map.show_state, store)
        self._left = self._splitter("left", Qt.Orientation.Vertical, self.zones.rows, self.zones.columns)
        self._middle = self._splitter("middle", Qt.Orientation.Vertical, self.zones.points, self.zones.surface)
        self._columns = self._splitter("columns", Qt.Orientation.Horizontal, self._left, self._middle)
        self._column = Column(self.zones.by_name, self._columns, self._map, self)
        self._view_side = self._splitter("laboratory", Qt.Orientation.Vertical, self.view_frame, self.laboratory)
        self._view_side.setChildrenCollapsible(False)
        self._view_side.setStretchFactor(0, 1)
        self._floating = FloatingWindow(self)
        self._floating.close_asked.connect(lambda: store.dispatch(PanelShown("")))
        self._room: Room | None = None
        self._kept: dict[str, QByteArray] = {}
        self._was_opened = False
        self.addWidget(self._column)
        self.addWidget(self._view_side)
        for splitter in (self, self._view_side, self._columns, self._left, self._middle):
            splitter.splitterMoved.connect(lambda _position, _index: self._keep_sizes())

    @property
    def shows(self) -> tuple[Listener, ...]:
        """What shows states in every part, the view first: what is waited for is its frame."""
        beside_view = (*self.zones.shows, self._map_seen.show_state)
        return (self.view_frame.show_state, self.laboratory.show_state, *beside_view, self._show_state)

    def commit_typed(self) -> None:
        """Take what is typed in the field that has the keyboard, as leaving the field would."""
        widget = QApplication.focusWidget()
        if isinstance(widget, NumberField) and self.isAncestorOf(widget):
            widget.commit()

    def current_zone(self) -> FieldZone:
        """Return the zone of fields that is meant: see ``Zones.current``."""
        return self.zones.current(self._column.current)

    def focus_part(self, name: str) -> None:
        """Bring the keyboard to a zone, which is then seen, or to the view."""
        if name == "view":
            self.view_frame.focus_view()
            return
        self._store.dispatch(ZonesShown(are_shown=True))
        self._store.flush()
        self._column.bring(name)
        self.zones.by_name[name].focus_first()
        if (focused := QApplication.focusWidget()) is not None:
            self._column.bring_into_sight(focused)

    # What is remembered

    def layout_states(self) -> dict[str, QByteArray]:
        """Return the sizes that were chosen in each arrangement, and the place of the laboratory's own window."""
        return {
            **{name: self._kept.get(name, QByteArray()) for name in _KEPT},
            "floating": self._floating.saveGeometry(),
        }

    def restore_layout(self, name: str, state: QByteArray) -> None:
        """Have an arrangement come back as it was."""
        if name == "floating":
            self._floating.restoreGeometry(state)
        elif not state.isEmpty():
            self._kept[name] = state

    # The arrangement

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._arrange()

    def _show_state(self, before: EditorState | None, after: EditorState) -> None:
        self._map.setVisible(is_net(after))
        if after.differs(before, "shows_zones", "panel", "display"):
            self._arrange()
        if before is not None and after.panel and after.panel != before.panel:
            self._column.bring(LABORATORY)
        marked = "document", "draft", "texts", "message", "display", "window", "shows_zones", "panel"
        if after.shows_zones and after.differs(before, *marked):
            self._mark_zones()

    def _arrange(self) -> None:
        """Bring zones, view and laboratory into the arrangement that the window has room for."""
        state, window = self._store.shown, self.window()
        scale = max(1.0, QFontInfo(self.font()).pixelSize() / _USUAL_TEXT)
        size = round(window.width() / scale), round(window.height() / scale)
        room = room_of(*size, state.display.laboratory_place, is_open=bool(state.panel))
        most = round(room.most_zones * scale)
        self._column.setMaximumWidth(most)
        if not room.is_below and self.sizes()[0] > most:
            self.setSizes([most, self.width() - most])  # a splitter leaves a gap beside what has shrunk by itself
        self._column.offer(
            zones=state.shows_zones,
            one_at_a_time=room.has_tabs,
            laboratory=room.dock is Dock.COLUMN and bool(state.panel),
        )
        self._floating.setVisible(room.dock is Dock.FLOATING and bool(state.panel))
        is_other = self._room is None or self._remembered(room).keys() != self._remembered(self._room).keys()
        if is_other:
            self._room = room
            self._turn(room, scale)
            self._mark_zones()
        if room.opens_laboratory and not self._was_opened:
            self._was_opened = True
            if not state.panel:
                self._store.dispatch(PanelShown(next(iter(PANELS))))

    def _turn(self, room: Room, scale: float) -> None:
        """Take up an arrangement, with the sizes that it had last."""
        vertical, horizontal = Qt.Orientation.Vertical, Qt.Orientation.Horizontal
        self._middle.setOrientation(horizontal if room.is_below else vertical)
        for zone in self.zones.of_fields:
            for field in zone.fields.values():
                field.set_least_text(zone.longest if room.has_all_digits else "")
        self._column.keep_width(is_kept=room.has_all_digits)
        self._give_laboratory_its_place(room.dock)
        self.insertWidget(int(room.is_below), self._column)
        self.setOrientation(vertical if room.is_below else horizontal)
        self._view_side.setMinimumWidth(_LEAST_VIEW)
        for number, part in enumerate((self._column, self._view_side)):
            self.setStretchFactor(self.indexOf(part), number)
            self.setCollapsible(self.indexOf(part), number == 0)
        for name, splitter in self._remembered(room).items():
            if not splitter.restoreState(self._kept.get(name, QByteArray())):
                splitter.setSizes(self._first_sizes(splitter, room, scale))
        self._middle.setOrientation(horizontal if room.is_below else vertical)  # a state brings its own back
        self.setOrientation(vertical if room.is_below else horizontal)

    def _first_sizes(self, splitter: LineSplitter, room: Room, scale: float) -> list[int]:
        if splitter is self:
            return [round(room.zones * scale), _VIEW][:: -1 if room.is_below else 1]
        if splitter is self._view_side:
            return [_VIEW, round(room.laboratory * scale)]
        parts: dict[LineSplitter, tuple[QWidget, QWidget]] = {
            self._columns: (self._left, self._middle),
            self._left: (self.zones.rows, self.zones.columns),
            self._middle: (self.zones.points, self.zones.surface),
        }
        hints = [part.sizeHint() for part in parts[splitter]]
        is_row = splitter.orientation() is Qt.Orientation.Horizontal
        return [hint.width() if is_row else hint.height() for hint in hints]

    def _give_laboratory_its_place(self, dock: Dock) -> None:
        self._view_side.setOrientation(Qt.Orientation.Horizontal if dock is Dock.RIGHT else Qt.Orientation.Vertical)
        home = {Dock.COLUMN: self._column.drawer, Dock.FLOATING: self._floating}.get(dock, self._view_side)
        if self.laboratory.parentWidget() is home:
            return
        if home is self._view_side:
            self._view_side.addWidget(self.laboratory)
        elif (place := home.layout()) is not None:
            place.addWidget(self.laboratory)
        self.laboratory.setVisible(bool(self._store.shown.panel))

    def _remembered(self, room: Room) -> dict[str, LineSplitter]:
        """Return the splitters whose sizes belong to an arrangement, by the names under which they are kept."""
        splitters = zip(_OF_ZONES, (self, self._columns, self._left, self._middle), strict=True)
        of_zones = {f"{name}.{room.form}{_OPEN * room.has_drawer}": splitter for name, splitter in splitters}
        return {**of_zones, f"laboratory.{room.dock}": self._view_side}

    def _keep_sizes(self) -> None:
        """Keep what the user has chosen: a window that is only resized chooses nothing."""
        if self._room is not None:
            self._kept.update({key: splitter.saveState() for key, splitter in self._remembered(self._room).items()})

    def _mark_zones(self) -> None:
        """Say on the tabs which zones hold what was refused, or is not set."""
        for zone in self.zones.of_fields:
            self._column.mark(zone.zone, *tab_mark(zone, self._store.shown))

    def _splitter(self, name: str, orientation: Qt.Orientation, *parts: QWidget) -> LineSplitter:
        splitter = LineSplitter(f"splitter.{name}", orientation, self)
        for part in parts:
            splitter.addWidget(part)
        return splitter
