"""Menus and the view bar, built from the table of commands."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path

from PySide6.QtCore import QSize, Qt
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QMenu, QMenuBar, QToolBar, QToolButton, QWidget

from qovr_app.state.requests import RecentCleared, SourceAsked
from qovr_app.store import Dispatch
from qovr_app.widgets.plain import menu_text, plain_tip
from qovr_app.window.actions import Actions
from qovr_app.window.bars import Bars
from qovr_app.window.tool_options import ToolField

_BAR_LAYERS = {"layer_raw": "Raw", "layer_transformed": "Transformed", "layer_both": "Both"}
_BAR_SCALES = "scaling_equal", "Equal scales"
_BAR_CAMERAS = {
    "camera_paper": "Paper",
    "camera_top": "Top",
    "camera_front": "Front",
    "camera_right": "Right",
    "fit": "Fit",
}
_BAR_CHOICES = {
    "Style": ["style_", "document_samples"],
    "Colour by": ["colour_by_", "colour_range_", "colour_map_"],
    "Show": ["show_"],
}
"""The commands of each drop-down, by how their names begin; a line parts one kind from the next."""

_BAR_EDITS = {
    "live": "Live",
    "link_curves": "Link curves",
    "link_directions": "Link directions",
    "link_windows": "Link windows",
    "": "",
    "undo": "Undo",
    "redo": "Redo",
}

_SHORTER = {
    "link_directions": "+ directions",
    "link_windows": "+ windows",
    "undo": "↶",
    "redo": "↷",
    "scaling_equal": "1:1",
}
"""What the bars say in a narrow window, so that what is nowhere else on the screen stays in them."""

_BAR_TOOLS = {"snap": ("Snap", "snap_step"), "soft": ("Soft", "soft_radius")}
"""The tools that have a size, by the command: text, and the field of the size beside it."""


def fill_menu_bar(bar: QMenuBar, actions: Actions) -> dict[str, QMenu]:
    """Put every command into the menu that its record names; return the menus by their paths."""
    menus: dict[str, QMenu] = {}
    for command in actions.commands:
        menu = _menu(command.menu, bar, menus)
        if command.begins_part:
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


def make_bars(actions: Actions, parent: QWidget) -> QWidget:
    """Return what stands over everything else, whatever of that is shown: the two bars in one row."""
    shorter = {actions[name]: text for name, text in _SHORTER.items()}
    cameras = [actions[name] for name in _BAR_CAMERAS]
    return Bars(make_edit_bar(actions, parent), make_view_bar(actions, parent), shorter, cameras, parent)


def make_view_bar(actions: Actions, parent: QWidget) -> QToolBar:
    """Return the bar over the view: which surface, how it looks, and from where."""
    bar = _bar("View", "view_bar", parent)
    for name, text in _BAR_LAYERS.items():
        _add(bar, actions[name], text)
    bar.addSeparator()
    _add(bar, actions[_BAR_SCALES[0]], _BAR_SCALES[1])
    for title, prefixes in _BAR_CHOICES.items():
        bar.addWidget(_choice(title, [actions.begun_with(prefix) for prefix in prefixes], bar))
    bar.addSeparator()
    for name, text in _BAR_CAMERAS.items():
        _add(bar, actions[name], text)
    return bar


def make_edit_bar(actions: Actions, parent: QWidget) -> QToolBar:
    """Return the bar over the zones: how edits are taken, and back."""
    bar = _bar("Edit", "edit_bar", parent)
    for name, text in _BAR_EDITS.items():
        if name:
            _add(bar, actions[name], text)
        else:
            bar.addSeparator()
    bar.addSeparator()
    for name, (text, setting) in _BAR_TOOLS.items():
        _add(bar, actions[name], text)
        bar.addWidget(ToolField(setting, actions.store, bar))
    return bar


class RecentMenu(QMenu):
    """The files opened or saved last, read from the preferences whenever the menu opens, and from nowhere else."""

    def __init__(self, recent: Callable[[], Sequence[Path]], dispatch: Dispatch, parent: QWidget) -> None:
        super().__init__("Open &Recent", parent)
        self.setObjectName("menu.recent")
        self.setToolTipsVisible(True)
        self._recent, self._dispatch = recent, dispatch
        self.aboutToShow.connect(self._fill)
        self._fill()

    def _fill(self) -> None:
        self.clear()
        for number, path in enumerate(self._recent(), start=1):
            action = self.addAction(f"&{number}  {menu_text(path.name)}")
            action.setToolTip(plain_tip(str(path)))
            action.triggered.connect(lambda _checked, path=path: self._dispatch(SourceAsked(str(path))))
        if self.isEmpty():
            self.addAction("No files yet").setEnabled(False)
            return
        self.addSeparator()
        self.addAction("&Clear list").triggered.connect(lambda _checked: self._dispatch(RecentCleared()))


def _bar(title: str, name: str, parent: QWidget) -> QToolBar:
    bar = QToolBar(title, parent)
    bar.setObjectName(name)
    bar.setMovable(False)
    bar.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextOnly)
    bar.setIconSize(QSize(16, 16))
    more = bar.findChild(QToolButton, "qt_toolbar_ext_button")
    if more is not None:  # the style's own icon is dark in the dark theme too; text has the palette's ink
        more.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextOnly)
        more.setText("»")
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
