"""The command palette: every command by a few letters of its name, with the keyboard alone."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import QEvent, QObject, QPoint, Qt
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import QDialog, QLineEdit, QListWidget, QListWidgetItem, QVBoxLayout, QWidget

from qovr_app.widgets.parts import named
from qovr_app.window.actions import Actions
from qovr_app.window.commands import Command

_WIDTH, _HEIGHT, _TOP = 560, 360, 60
_OWN = "palette"
"""The command that opens the palette, which is not listed in it."""

_STEPS = {Qt.Key.Key_Down: 1, Qt.Key.Key_Up: -1, Qt.Key.Key_PageDown: 10, Qt.Key.Key_PageUp: -10}


class Palette(QDialog):
    """A line to type into over the list of what matches; Enter does what is chosen, Escape leaves."""

    def __init__(self, actions: Actions, parent: QWidget) -> None:
        super().__init__(parent, Qt.WindowType.Popup)
        self.setObjectName("palette.list")
        self._actions = actions
        self._line = named(QLineEdit(self), "palette.line", "Command")
        self._line.setPlaceholderText("Type what you want to do")
        self._list = named(QListWidget(self), "palette.matches", "Commands")
        self._list.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(6, 6, 6, 6)
        layout.addWidget(self._line)
        layout.addWidget(self._list)
        self._line.textChanged.connect(self._fill)
        self._line.installEventFilter(self)
        self._line.returnPressed.connect(self._do_current)
        self._list.itemClicked.connect(lambda _item: self._do_current())
        width, height = min(_WIDTH, parent.width()), min(_HEIGHT, parent.height() - _TOP)
        self.resize(width, height)
        self.move(parent.mapToGlobal(QPoint((parent.width() - width) // 2, _TOP)))
        self._fill("")
        self._line.setFocus()

    def eventFilter(self, _watched: QObject, event: QEvent) -> bool:
        if not isinstance(event, QKeyEvent) or event.type() != QEvent.Type.KeyPress or event.key() not in _STEPS:
            return False
        last = self._list.count() - 1
        self._list.setCurrentRow(max(0, min(last, self._list.currentRow() + _STEPS[Qt.Key(event.key())])))
        return True

    def _fill(self, text: str) -> None:
        """List the commands in whose words all that is typed occurs, what can be done now first.

        Before anything is typed none is chosen but the one given last: Enter alone must not do what was not asked for.
        """
        words = text.lower().split()
        commands = [each for each in self._actions.commands if self._actions[each.name].isVisible()]
        found = [
            command for command in commands if command.name != _OWN and all(word in _words(command) for word in words)
        ]
        self._list.clear()
        for command in sorted(found, key=self._distance(text.lower())):
            self._list.addItem(self._item(command))
        is_known = bool(words or self._used())
        self._list.setCurrentRow(0 if is_known else -1)

    def _used(self) -> list[str]:
        """Return the names of the commands that were given and can be again, the latest first."""
        return [name for name in reversed(self._actions.used) if name != _OWN and self._actions[name].isEnabled()]

    def _distance(self, text: str) -> Callable[[Command], tuple[bool, bool, bool, int]]:
        """Return what commands are sorted by: possible, begins so, has it in its name, was given lately."""
        used = self._used()

        def distance(command: Command) -> tuple[bool, bool, bool, int]:
            name, is_enabled = self._name(command).lower(), self._actions[command.name].isEnabled()
            since = used.index(command.name) if command.name in used else len(used)
            return not is_enabled, not name.startswith(text), not all(word in name for word in text.split()), since

        return distance

    def _name(self, command: Command) -> str:
        return self._actions[command.name].text().replace("&", "")

    def _item(self, command: Command) -> QListWidgetItem:
        action = self._actions[command.name]
        mark = "✓ " if action.isChecked() else ""
        keys = action.shortcut().toString(action.shortcut().SequenceFormat.NativeText)
        aside = keys if action.isEnabled() else command.needs
        where = command.menu.replace("&", "").replace("/", " › ")
        item = QListWidgetItem("   ".join(part for part in (f"{mark}{self._name(command)}", where, aside) if part))
        item.setData(Qt.ItemDataRole.UserRole, command.name)
        item.setToolTip(action.toolTip())
        if not action.isEnabled():
            item.setForeground(self.palette().color(self.palette().ColorGroup.Disabled, self.foregroundRole()))
        return item

    def _do_current(self) -> None:
        item = self._list.currentItem()
        action = self._actions[item.data(Qt.ItemDataRole.UserRole)] if item is not None else None
        if action is None or not action.isEnabled():
            return
        self.close()
        action.trigger()


def _words(command: Command) -> str:
    return f"{command.text} {command.menu} {command.tip}".replace("&", "").lower()
