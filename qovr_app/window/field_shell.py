"""What is asked of one field: its menu, and the clipboard."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import QPoint
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QMenu, QWidget

from qovr_app.state import requests
from qovr_app.state.field_facts import current_place
from qovr_app.state.focus import is_net
from qovr_app.state.looking_intents import MessageShown
from qovr_app.state.names import label
from qovr_app.store import Store
from qovr_app.widgets.number_field import NumberField
from qovr_app.window.actions import Actions
from qovr_app.window.layout import Layout
from qovr_app.window.shell import Answers
from qovr_core.number_texts import number_text

_COMMANDS = (
    "field_revert", "field_reset", "", "field_copy", "field_paste", "", "field_set_curves", "field_set_directions", "",
    "copy_zone", "copy_plane", "paste_zone", "", "get_values", "set_values",
)  # fmt: skip


class FieldShell:
    """Answers what is asked of the field that has, or had last, the keyboard.

    Parameters
    ----------
    actions : gives the window's actions, which are made after the shell
    """

    def __init__(self, store: Store, layout: Layout, actions: Callable[[], Actions], window: QWidget) -> None:
        self._store, self._layout, self._actions, self._window = store, layout, actions, window
        self.answers: Answers = {
            requests.FieldMenuAsked: self._show_menu,
            requests.FieldCopyAsked: lambda _request: self._copy(),
            requests.FieldPasteAsked: lambda _request: self._paste(),
        }

    def _field(self) -> NumberField | None:
        place = current_place(self._store.state)
        return None if place is None else self._layout.zones.field_at(place)

    def _show_menu(self, request: requests.FieldMenuAsked) -> None:
        """Show the commands for the field, and those for its zone."""
        # a line edit takes a menu of its own for no reason to finish what is typed
        menu, actions = QMenu(self._field() or self._window), self._actions()
        menu.setObjectName("context.field")
        menu.setToolTipsVisible(True)
        actions.show_state(None, self._store.state)
        for name in _COMMANDS:
            if name:
                menu.addAction(actions[name])
            else:
                menu.addSeparator()
        menu.aboutToHide.connect(menu.deleteLater)
        menu.popup(QPoint(*request.at))

    def _copy(self) -> None:
        """Copy the number, or what is typed over it."""
        field, place = self._field(), current_place(self._store.state)
        if field is None or place is None:
            return
        text = field.text() if field.has_own_text else number_text(field.value)
        QGuiApplication.clipboard().setText(text)
        self._store.dispatch(MessageShown(f"Copied {label(place, in_net=is_net(self._store.state))}: {text}"))

    def _paste(self) -> None:
        """Paste over the whole number, and take it as leaving the field would."""
        if (field := self._field()) is not None:
            field.selectAll()
            field.paste()
            field.commit()
