"""The sizes of the tools as fields of the toolbar: to what step a drag keeps, how far a soft move reaches."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtWidgets import QWidget

from qovr_app.state.editor_state import EditorState
from qovr_app.state.looking_intents import MessageOutdated, MessageShown, ToolChosen
from qovr_app.state.tools import SETTING_NAMES, checked_size
from qovr_app.store import Store
from qovr_app.widgets.number_field import NumberField
from qovr_core.number_texts import natural_step

_ROOM = "0.00000"

_TIPS = {
    "snap_step": "Multiples of this are what a drag keeps to with Ctrl, or with Snap on; a nudge is one of it.",
    "soft_radius": "After so many steps along the net a soft move has faded out; the wheel changes it in a drag.",
}


class ToolField(NumberField):
    """One size of the tools."""

    def __init__(self, setting: str, store: Store, parent: QWidget | None = None) -> None:
        super().__init__(SETTING_NAMES[setting], checked_size, _STEPS[setting], parent)
        self._setting, self._store = setting, store
        self.setObjectName(f"tools.{setting}")
        self.setAccessibleName(SETTING_NAMES[setting].removeprefix("the ").capitalize())
        self.set_tip(_TIPS[setting])
        self.set_width(self.fontMetrics().horizontalAdvance(_ROOM))
        self.value_edited.connect(lambda value, _gesture: self._choose(value))
        self.gesture_cancelled.connect(lambda _gesture: self._choose(self.value))
        self.refused.connect(self._refuse)
        store.subscribe(self.show_state)

    def show_state(self, before: EditorState | None, after: EditorState) -> None:
        """Show the size that is in force."""
        if after.differs(before, "tools"):
            self.show_value(getattr(after.tools, self._setting))

    def _choose(self, value: float) -> None:
        self._store.dispatch(ToolChosen(self._setting, value))

    def _refuse(self, reason: str) -> None:
        message = MessageShown(f"{reason}.", is_refusal=True) if reason else MessageOutdated(only_refusals=True)
        self._store.dispatch(message)


_STEPS: dict[str, Callable[[float], float]] = {
    "snap_step": lambda step: natural_step(step, 100 * step),
    "soft_radius": lambda _radius: 1.0,
}
"""By how much a key changes each: a step by its own first digit, a radius by one step along the net."""
