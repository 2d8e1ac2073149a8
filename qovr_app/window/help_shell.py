"""What is asked of the window about itself: help, keys, versions, the palette."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from html import escape
from typing import TYPE_CHECKING

from PySide6.QtCore import QSize
from PySide6.QtWidgets import QApplication, QWidget

from qovr_app.state import requests
from qovr_app.window.about import keys_html, versions_text
from qovr_app.window.actions import Actions
from qovr_app.window.application import NAME
from qovr_app.window.palette import Palette
from qovr_app.window.shell import Answers

if TYPE_CHECKING:
    from qovr_app.dialogs.help_dialog import HelpDialog

_KEYS_SIZE, _ABOUT_SIZE = QSize(460, 640), QSize(460, 240)


class HelpShell:
    """Answers what is asked about the program.

    Parameters
    ----------
    actions : gives the window's actions, which are made after the shell
    """

    def __init__(self, actions: Callable[[], Actions], window: QWidget) -> None:
        self._actions, self._window = actions, window
        self._help: HelpDialog | None = None
        self.answers: Answers = {
            requests.HelpAsked: self._show_help,
            requests.KeysAsked: self._show_keys,
            requests.AboutAsked: self._show_about,
            requests.PaletteAsked: self._show_palette,
        }

    def _show_help(self, _request: requests.HelpAsked) -> None:
        names = list(_names_around(QApplication.focusWidget()))  # before the page takes the keyboard
        if self._help is None:
            from qovr_app.dialogs.help_dialog import HelpDialog

            self._help = HelpDialog(self._window)
        self._help.show_about(names)

    def _show_keys(self, _request: requests.KeysAsked) -> None:
        actions = self._actions()
        html = keys_html((command.menu, actions[command.name]) for command in actions.commands)
        self._show_sheet("keys", "Keys", html, _KEYS_SIZE)

    def _show_about(self, _request: requests.AboutAsked) -> None:
        first, *others = versions_text().splitlines()
        lines = "".join(f"<p>{escape(line)}</p>" for line in others)
        html = f"<h2>{escape(first)}</h2><p>Quartic Overhauser surfaces, exactly. MIT licence.</p>{lines}"
        self._show_sheet("about", f"About {NAME}", html, _ABOUT_SIZE)

    def _show_sheet(self, name: str, title: str, html: str, size: QSize) -> None:
        from qovr_app.dialogs.sheet import Sheet

        Sheet(name, title, html, size, self._window).show()

    def _show_palette(self, _request: requests.PaletteAsked) -> None:
        palette = Palette(self._actions(), self._window)
        palette.finished.connect(palette.deleteLater)
        palette.show()


def _names_around(widget: QWidget | None) -> Iterator[str]:
    """Yield the object names of a widget and of what it is part of, from inside out."""
    while widget is not None:
        yield widget.objectName()
        widget = widget.parentWidget()
