"""Gesture numbers for what has no clear end: keys held down, wheel turns."""

from __future__ import annotations

from PySide6.QtCore import QObject, QTimer

from qovr_app.state.gestures import next_gesture

_PAUSE_MILLISECONDS = 700
"""Steps closer together than this are one movement of the hand, and so one undo step."""


class Bursts(QObject):
    """Gives steps that follow each other quickly the same gesture number."""

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self._gesture = 0
        self._pause = QTimer(self, singleShot=True, interval=_PAUSE_MILLISECONDS)
        self._pause.timeout.connect(self.end)

    def step(self) -> int:
        """Return the number of the burst that this step belongs to."""
        self._gesture = self._gesture or next_gesture()
        self._pause.start()
        return self._gesture

    def end(self) -> None:
        """Let the next step begin a new burst."""
        self._gesture = 0
        self._pause.stop()
