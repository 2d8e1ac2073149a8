"""The commands as Qt knows them: actions whose marks follow the state."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from PySide6.QtCore import QObject, Qt
from PySide6.QtGui import QAction, QActionGroup, QKeySequence
from PySide6.QtWidgets import QWidget

from qovr_app.state.editor_state import EditorState
from qovr_app.store import Store
from qovr_app.style.symbols import symbols_in_plain
from qovr_app.widgets.plain import menu_text, plain_tip
from qovr_app.window.commands import Command


class _Marks(NamedTuple):
    """What a state makes of a command."""

    is_shown: bool
    is_enabled: bool
    is_checked: bool
    noun: str


class Actions(QObject):
    """An action for every command; pressing one dispatches its intent, and nothing else ever sets its mark.

    ``used`` are the names of the commands that were given, the latest last.
    """

    def __init__(self, commands: Sequence[Command], store: Store, parent: QObject) -> None:
        super().__init__(parent)
        self.commands, self.store = tuple(commands), store
        self._varying = tuple(command for command in self.commands if command.varies)
        self.used: list[str] = []
        self._marks: dict[str, _Marks] = {}
        self._groups: dict[str, QActionGroup] = {}
        self._actions = {command.name: self._action(command) for command in self.commands}

    def __getitem__(self, name: str) -> QAction:
        return self._actions[name]

    def begun_with(self, prefix: str) -> list[QAction]:
        """Return the actions whose names begin so, in the table's order."""
        return [action for name, action in self._actions.items() if name.startswith(prefix)]

    def give_single_keys(self, widget: QWidget) -> None:
        """Let shortcuts of a single key act while a widget, or a part of it, has the keyboard."""
        widget.addActions([action for action in self._actions.values() if is_single_key(action.shortcut())])

    def show_state(self, before: EditorState | None, state: EditorState) -> None:
        """Bring check marks, enabled and the texts that say a noun to a state; all of them without one before."""
        for command in self.commands if before is None else self._varying:
            marks = _marks_of(command, state)
            if before is None or marks != self._marks[command.name]:
                self._marks[command.name] = marks
                _mark(self._actions[command.name], command, marks)

    def _action(self, command: Command) -> QAction:
        action = QAction(command.text, self.parent())
        action.setObjectName(command.name)
        if command.shortcut is not None:
            action.setShortcut(QKeySequence(command.shortcut))
            if is_single_key(action.shortcut()):
                action.setShortcutContext(Qt.ShortcutContext.WidgetWithChildrenShortcut)
        tip = command.tip or command.text.replace("&", "").rstrip(".…")
        action.setStatusTip(tip)
        action.setToolTip(tip)
        action.setCheckable(command.is_checked is not None)
        action.triggered.connect(lambda _checked: self._on_triggered(command))
        if command.group:
            self._groups.setdefault(command.group, QActionGroup(self)).addAction(action)
        return action

    def _on_triggered(self, command: Command) -> None:
        self.used = [*(name for name in self.used if name != command.name), command.name]
        self.store.dispatch(command.intent(self.store.state))
        # Qt has turned the mark by itself, and a refused intent leaves the state as it was.
        self.show_state(None, self.store.state)


def _marks_of(command: Command, state: EditorState) -> _Marks:
    return _Marks(
        command.is_shown(state),
        command.is_enabled(state),
        command.is_checked is not None and command.is_checked(state),
        "" if command.noun is None else command.noun(state),
    )


def _mark(action: QAction, command: Command, marks: _Marks) -> None:
    action.setVisible(marks.is_shown)
    action.setEnabled(marks.is_enabled)
    if command.needs:
        tip = action.statusTip()
        action.setToolTip(tip if marks.is_enabled else f"{tip}.\n{command.needs}.")
    if command.is_checked is not None:
        action.setChecked(marks.is_checked)
    if command.noun is not None:
        _name(action, command.text, marks.noun)


def is_single_key(keys: QKeySequence) -> bool:
    """Return whether a shortcut is what typing a text could be: such a key acts only with the keyboard in the view."""
    text = keys.toString(QKeySequence.SequenceFormat.PortableText).removeprefix("Shift+")
    return len(text) == 1


def _name(action: QAction, verb: str, noun: str) -> None:
    noun = symbols_in_plain(noun)
    text = f"{verb} {menu_text(noun)}".strip()
    if action.text() != text:
        action.setText(text)
        action.setToolTip(plain_tip(f"{verb.replace('&', '')} {noun}".strip()))
