"""Ctrl-C in the terminal and the system's wish that the program end, as Qt signals."""

from __future__ import annotations

import signal
import socket
from typing import Any

from PySide6.QtCore import QObject, QSocketNotifier, Signal

_ENDING = ("SIGINT", "SIGTERM", "SIGHUP")
"""Ctrl-C, a polite kill or the end of the session, and a terminal that is closed; Windows has not all of them."""

_MANY = 64
"""More signals than come at once."""


class EndSignals(QObject):
    """Tells of the signals that ask the program to end.

    Python writes their numbers into a socket at once, which wakes the event loop, also that of a dialog.

    Signals
    -------
    came : the signal's number
    """

    came = Signal(int)

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._numbers = {int(getattr(signal, name)) for name in _ENDING if hasattr(signal, name)}
        self._numbers = {number for number in self._numbers if signal.getsignal(number) is not signal.SIG_IGN}
        self._read, self._write = socket.socketpair()
        for end in (self._read, self._write):
            end.setblocking(False)
        self._notifier = QSocketNotifier(self._read.fileno(), QSocketNotifier.Type.Read, self)
        self._notifier.activated.connect(self._on_written)
        self._before: dict[int, Any] = {number: signal.signal(number, _leave_to_qt) for number in self._numbers}
        self._wakeup_before = signal.set_wakeup_fd(self._write.fileno(), warn_on_full_buffer=False)

    def close(self) -> None:
        """Leave signals to whoever took them before."""
        signal.set_wakeup_fd(self._wakeup_before)
        for number, handler in self._before.items():
            signal.signal(number, handler)
        self._notifier.setEnabled(False)
        self._read.close()
        self._write.close()

    def _on_written(self) -> None:
        for number in self._read.recv(_MANY):
            if number in self._numbers:
                self.came.emit(number)
                return


def _leave_to_qt(_number: int, _frame: object) -> None:
    """Do nothing: that there is a handler is what makes Python tell the socket."""
