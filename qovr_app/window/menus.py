"""Menus and the view bar, built from the table of commands."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QSize, Qt
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QMenu, QMenuBar, QToolBar, QToolButton, QWidget

from qovr_app.state.display import LayerChoice
from qovr_app.window.actions import Command

if TYPE_CHECKING:
    from qovr_app.window.desk import Desk

_SEPARATED = {
    "save",
    "export",
    "close",
    "copy_zone",
    "get_values",
    "live",
    "scaling_each",
    "probe",
    "pin_reference",
    "camera_paper",
    "go_row_knots",
}
"""Commands before which a menu has a line."""

_BAR_CAMERAS = {
    "camera_paper": "Paper",
    "camera_top": "Top",
    "camera_front": "Front",
    "camera_right": "Right",
    "fit": "Fit",
}
_BAR_CHOICES = {
    "Style": ["style_"],
    "Colour by": ["colour_by_", "colour_range_", "colour_map_"],
    "Show": ["show_"],
    "Scales": ["scaling_"],
}
"""The commands of each drop-down, by how their names begin; a line parts one kind from the next."""

_BAR_EDITS = {
    "live": "Live",
    "link_curves": "Link curves",
    "link_directions": "Link directions",
    "": "",
    "undo": "Undo",
    "redo": "Redo",
}


def fill_menu_bar(bar: QMenuBar, commands: list[Command], actions: dict[str, QAction]) -> dict[str, QMenu]:
    """Put every command into the menu that its entry names; return the menus by their paths."""
    menus: dict[str, QMenu] = {}
    for command in commands:
        menu = _menu(command.menu, bar, menus)
        if command.name in _SEPARATED:
            menu.addSeparator()
        menu.addAction(actions[command.name])
    return menus


def _menu(path: str, bar: QMenuBar, menus: dict[str, QMenu]) -> QMenu:
    """Return the menu of a path such as "View/Show", made where it is missing."""
    key = path.replace("&", "")
    if key not in menus:
        parent, _, title = path.rpartition("/")
        owner = _menu(parent, bar, menus) if parent else bar
        menus[key] = owner.addMenu(title)
        menus[key].setObjectName(f"menu.{key.lower()}")
        menus[key].setToolTipsVisible(True)
    return menus[key]


def make_view_bar(actions: dict[str, QAction], parent: QWidget) -> QToolBar:
    """Return the bar over the view: which surface, how it looks, and from where."""
    bar = _bar("View", "view_bar", parent)
    for layer, text in ((LayerChoice.RAW, "Raw"), (LayerChoice.TRANSFORMED, "Transformed"), (LayerChoice.BOTH, "Both")):
        _add(bar, actions[f"layer_{layer}"], text)
    bar.addSeparator()
    for title, prefixes in _BAR_CHOICES.items():
        groups = [[action for name, action in actions.items() if name.startswith(prefix)] for prefix in prefixes]
        bar.addWidget(_choice(title, groups, bar))
    bar.addSeparator()
    for name, text in _BAR_CAMERAS.items():
        _add(bar, actions[name], text)
    return bar


def make_edit_bar(actions: dict[str, QAction], parent: QWidget) -> QToolBar:
    """Return the bar over the zones: how edits are taken, and back."""
    bar = _bar("Edit", "edit_bar", parent)
    for name, text in _BAR_EDITS.items():
        if name:
            _add(bar, actions[name], text)
        else:
            bar.addSeparator()
    return bar


class RecentMenu(QMenu):
    """The files opened or saved last, looked up whenever the menu opens."""

    def __init__(self, desk: Desk, parent: QWidget) -> None:
        super().__init__("Open &Recent", parent)
        self.setObjectName("menu.recent")
        self.setToolTipsVisible(True)
        self._desk = desk
        self.aboutToShow.connect(self._fill)
        self._fill()

    def _fill(self) -> None:
        self.clear()
        for number, path in enumerate(self._desk.recent, start=1):
            action = self.addAction(f"&{number}  {path.name}".replace("&&", "&"))
            action.setToolTip(str(path))
            action.triggered.connect(lambda _checked, path=path: self._desk.open_source(str(path)))
        if self.isEmpty():
            self.addAction("No files yet").setEnabled(False)
            return
        self.addSeparator()
        self.addAction("&Clear list").triggered.connect(lambda _checked: self._desk.clear_recent())


def _bar(title: str, name: str, parent: QWidget) -> QToolBar:
    bar = QToolBar(title, parent)
    bar.setObjectName(name)
    bar.setMovable(False)
    bar.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextOnly)
    bar.setIconSize(QSize(16, 16))
    return bar


def _add(bar: QToolBar, action: QAction, text: str) -> None:
    action.setIconText(text)
    bar.addAction(action)


def _choice(title: str, groups: list[list[QAction]], parent: QWidget) -> QToolButton:
    button = QToolButton(parent)
    button.setText(title)
    button.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
    button.setAutoRaise(True)
    menu = QMenu(button)
    menu.setToolTipsVisible(True)
    for actions in groups:
        menu.addSeparator()
        menu.addActions(actions)
    button.setMenu(menu)
    return button
