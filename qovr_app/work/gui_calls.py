"""Calls that only the GUI thread can make, for a job in another thread of this process."""

from __future__ import annotations

import threading
from collections.abc import Callable
from concurrent.futures import Future
from typing import Any

from PySide6.QtCore import QObject, Qt, Signal

InGui = Callable[[Callable[[], Any]], Any]
"""Calls a function in the GUI thread, and returns what it returns."""


def here(function: Callable[[], Any]) -> Any:
    """Return what a function returns in the thread that asks, which is the GUI's."""
    return function()


class GuiCalls(QObject):
    """Makes calls in the thread in which it was made, one at a time between events: each of them has to be short."""

    _asked = Signal(object)

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._thread = threading.get_ident()
        self._asked.connect(lambda call: call(), Qt.ConnectionType.QueuedConnection)

    def __call__(self, function: Callable[[], Any]) -> Any:
        """Return what a function returns in the GUI thread, or raise what it raises there."""
        if threading.get_ident() == self._thread:
            return function()
        answer: Future[Any] = Future()

        def call() -> None:
            try:
                answer.set_result(function())
            except BaseException as error:  # it is raised where it is waited for
                answer.set_exception(error)

        self._asked.emit(call)
        return answer.result()
