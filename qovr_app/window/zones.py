"""The four zones: told states while they are seen, and found by what is asked of them."""

from __future__ import annotations

from typing import TypeVar

from PySide6.QtWidgets import QApplication, QWidget

from qovr_app.state.editor_state import EditorState
from qovr_app.store import Listener, Store
from qovr_app.widgets.number_field import NumberField
from qovr_app.widgets.seen_part import SeenPart
from qovr_app.zones.knots_zone import KnotsZone
from qovr_app.zones.points_zone import PointsZone
from qovr_app.zones.surface_zone import SurfaceZone
from qovr_app.zones.zone import FieldZone
from qovr_core.edits import Place, zone_of
from qovr_core.geometry.knots import Direction

ZoneOfFields = TypeVar("ZoneOfFields", bound=FieldZone)


class Zones:
    """Makes the zones, which a layout places; ``by_name`` has all of them, ``of_fields`` those with a field a number.

    A zone that is not seen shows an older state: who asks something of it takes it from ``told``.
    """

    def __init__(self, store: Store, parent: QWidget) -> None:
        self.rows = KnotsZone(Direction.ROWS, store, parent)
        self.columns = KnotsZone(Direction.COLUMNS, store, parent)
        self.points = PointsZone(store, parent)
        self.surface = SurfaceZone(store, parent)
        self.of_fields: tuple[FieldZone, ...] = (self.rows, self.columns, self.points)
        self.by_name: dict[str, FieldZone | SurfaceZone] = {
            **{zone.zone: zone for zone in self.of_fields},
            "surface": self.surface,
        }
        self._seen = {zone: SeenPart(zone, zone.show_state, store) for zone in self.by_name.values()}

    @property
    def shows(self) -> tuple[Listener, ...]:
        """What shows states in them."""
        return (*(seen.show_state for seen in self._seen.values()), self._tell_of_texts)

    def told(self, zone: ZoneOfFields) -> ZoneOfFields:
        """Return a zone, which shows the state by now whether it is seen or not."""
        self._seen[zone].tell()
        return zone

    def current(self, alone: str) -> FieldZone:
        """Return the zone of fields that has the keyboard; where none has, the one seen alone, or the points."""
        widget = QApplication.focusWidget()
        for zone in self.of_fields:
            if (widget is not None and zone.isAncestorOf(widget)) or zone.zone == alone:
                return self.told(zone)
        return self.told(self.points)

    def field_at(self, place: Place) -> NumberField | None:
        """Return the field of a number; None where the number is not of the window in focus."""
        return self.told(next(zone for zone in self.of_fields if zone.zone is zone_of(place))).fields.get(place)

    def _tell_of_texts(self, before: EditorState | None, after: EditorState) -> None:
        """Tell the zones that are not seen what was typed there: on their tabs stands what of it was refused."""
        if after.differs(before, "texts", "window"):
            for zone in self.of_fields:
                self.told(zone)
