"""Headings of rows and columns of fields: clicked, they select points; dragged, they change all their numbers."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

from qovr_app.state.field_intents import ValuesShifted
from qovr_app.state.focus import in_window, point_in_window
from qovr_app.state.looking_intents import Picking, Selected
from qovr_app.state.scrubbing import Scrub
from qovr_app.store import Store
from qovr_app.widgets.header_label import HeaderLabel
from qovr_app.widgets.number_field import PIXEL, NumberField
from qovr_app.zones.gestures import dispatch_gestures
from qovr_core.document import NetIndex, Window
from qovr_core.edits import Place, value_at


class Headings:
    """Makes the headings of a zone.

    Parameters
    ----------
    fields : those of the zone, which may still be made
    window : gives the window of the net that the zone shows
    """

    def __init__(self, store: Store, fields: Mapping[Place, NumberField], window: Callable[[], Window]) -> None:
        self._store, self._fields, self._window = store, fields, window

    def heading(self, html: str, name: str, places: Sequence[Place], points: Sequence[NetIndex]) -> HeaderLabel:
        """Return a heading of some numbers of a window, and of the points that it selects."""

        def shown() -> tuple[Place, ...]:
            return tuple(in_window(place, self._window()) for place in places)

        result = HeaderLabel(html, name, lambda: self._taken(shown()), lambda: self._snaps(shown()))
        result.setToolTip(
            "Click: select its points, Shift adds them, Ctrl toggles. Drag sideways: change its numbers together."
        )
        result.scrubbed.connect(lambda amount, gesture: self._store.dispatch(ValuesShifted(shown(), amount, gesture)))
        dispatch_gestures(result, self._store.dispatch)
        result.clicked.connect(lambda picking: self._select(points, picking))
        return result

    def _select(self, points: Sequence[NetIndex], picking: Picking) -> None:
        last, *others = (point_in_window(point, self._window()) for point in reversed(points))
        self._store.dispatch(Selected(last, tuple(others), picking))

    def _snaps(self, places: Sequence[Place]) -> bool:
        return self._fields[places[0]].snapping.is_on()

    def _taken(self, places: Sequence[Place]) -> Scrub:
        """Return the change of numbers as the mouse takes it: such that each may be one of its field."""
        numbers = [(self._fields[place], value_at(self._store.state.draft, place)) for place in places]
        step = max(field.step_size for field, _ in numbers)

        def may_be(amount: float) -> bool:
            return all(field.may_be(value + amount) for field, value in numbers)

        return Scrub(0.0, step * PIXEL, numbers[0][0].snapping.step(), may_be)
