"""What the tab of a zone of fields says of them: that some were refused, or are not set."""

from __future__ import annotations

from qovr_app.state.editor_state import EditorState
from qovr_app.style.palette import theme_in_force
from qovr_app.style.theme import Rgb
from qovr_app.zones.zone import FieldZone


def tab_mark(zone: FieldZone, state: EditorState) -> tuple[Rgb | None, str]:
    """Return the colour of the dot on a zone's tab, None for no dot, and why it is there."""
    if bad := sum(bool(field.error) for field in zone.fields.values()) if state.texts else 0:
        return theme_in_force().bad, f"{bad} refused"
    if pending := state.count_pending(zone.fields):
        return theme_in_force().pending, f"{pending} not set"
    return None, ""
