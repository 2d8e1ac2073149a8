"""The one table of the window's commands: name, text, shortcut, menu, and what it calls."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from PySide6.QtCore import QObject
from PySide6.QtGui import QAction, QActionGroup, QKeySequence

SEPARATOR = "-"


@dataclass(frozen=True)
class Command:
    """One command.

    Parameters
    ----------
    name : the action's object name, by which tests and other programs find it
    text : what the menu says
    call : what it does; checkable commands are called with whether they are checked
    menu : the menu it stands in, as "View/Show"
    shortcut : a standard key or a sequence as text
    group : commands of one group exclude each other
    checked : None where the command has no check mark, else how it starts
    tip : one sentence for the status bar
    """

    name: str
    text: str
    call: Callable[..., Any]
    menu: str
    shortcut: QKeySequence.StandardKey | str | None = None
    group: str = ""
    checked: bool | None = None
    tip: str = ""


def make_actions(commands: list[Command], parent: QObject) -> dict[str, QAction]:
    """Return an action for every command, by name."""
    groups: dict[str, QActionGroup] = {}
    actions = {}
    for command in commands:
        action = QAction(command.text, parent)
        action.setObjectName(command.name)
        if command.shortcut is not None:
            action.setShortcut(QKeySequence(command.shortcut))
        tip = command.tip or command.text.replace("&", "").rstrip(".…")
        action.setStatusTip(tip)
        action.setToolTip(tip)
        if command.checked is None:
            action.triggered.connect(lambda _checked, call=command.call: call())
        else:
            action.setCheckable(True)
            action.setChecked(command.checked)
            action.triggered.connect(command.call)
        if command.group:
            groups.setdefault(command.group, QActionGroup(parent)).addAction(action)
        actions[command.name] = action
    return actions
