"""The steps that can be undone and redone, as a list to go to one of them."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtWidgets import QMenu, QWidget

from qovr_app.state.history import History
from qovr_app.state.intents import WentTo
from qovr_app.store import Dispatch
from qovr_app.style.symbols import symbols_in_plain
from qovr_app.widgets.plain import menu_text

_MOST = 25
"""As many steps each way as a menu can show at once."""


class HistoryMenu(QMenu):
    """The steps around the document as it stands, which has the mark, looked up whenever the menu opens."""

    def __init__(self, history: Callable[[], History], dispatch: Dispatch, parent: QWidget) -> None:
        super().__init__("&History", parent)
        self.setObjectName("menu.history")
        self._history, self._dispatch = history, dispatch
        self.aboutToShow.connect(self._fill)
        self._fill()

    def _fill(self) -> None:
        self.clear()
        history = self._history()
        first, last = max(0, history.index - _MOST), min(len(history.steps), history.index + _MOST)
        for index in range(first, last + 1):
            text = history.steps[index - 1].text if index else "As opened"
            action = self.addAction(menu_text(symbols_in_plain(text)))
            action.setCheckable(True)
            action.setChecked(index == history.index)
            action.triggered.connect(lambda _checked, index=index: self._dispatch(WentTo(index)))
