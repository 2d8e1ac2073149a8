"""The menu of the windows, and what is asked of all of them together."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QObject
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QMenu, QWidget

from qovr_app.state import requests
from qovr_app.widgets.plain import menu_text, plain_tip
from qovr_app.window.application import NAME
from qovr_app.window.shell import Answers
from qovr_app.window.tour import begin_tour
from qovr_app.window.windows import Windows, bring_forward

if TYPE_CHECKING:
    from qovr_app.window.main_window import MainWindow


def window_answers(windows: Windows, window: MainWindow) -> Answers:
    """Return what answers a window's requests that concern the others."""
    return {
        requests.WindowAsked: lambda _asked: windows.open(),
        requests.WindowStepped: lambda asked: windows.step_from(window, asked.step),
        requests.TourAsked: lambda _asked: begin_tour(windows, window),
        requests.QuitAsked: lambda _asked: windows.quit(),
    }


class WindowList(QObject):
    """Lists the windows under the commands of a menu, looked up whenever it opens; its own window has the mark."""

    def __init__(self, windows: Windows, menu: QMenu, window: QWidget) -> None:
        super().__init__(menu)
        self._windows, self._menu, self._window = windows, menu, window
        self._listed: list[QAction] = []
        menu.aboutToShow.connect(self._fill)

    def _fill(self) -> None:
        for action in self._listed:
            self._menu.removeAction(action)
            action.deleteLater()
        self._listed = [self._menu.addSeparator()]
        for number, window in enumerate(self._windows.all, start=1):
            file, changed = window.store.state.file, " *" if window.isWindowModified() else ""
            digit = f"&{number}  " if number < 10 else ""
            action = self._menu.addAction(f"{digit}{menu_text(file.title)}{changed}")
            action.setObjectName(f"window.{number}")
            action.setToolTip(plain_tip(str(file.path or f"{NAME}: not in a file yet")))
            action.setCheckable(True)
            action.setChecked(window is self._window)
            action.triggered.connect(lambda _checked, window=window: bring_forward(window))
            self._listed.append(action)
