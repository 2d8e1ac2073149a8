"""A part of the window that is told the states of a store while it is seen."""

from __future__ import annotations

from PySide6.QtCore import QElapsedTimer, QEvent, QObject, QTimer
from PySide6.QtWidgets import QWidget

from qovr_app.state.editor_state import EditorState
from qovr_app.store import Listener, Store

BEHIND = 90
"""Milliseconds that a part shows the same during a gesture, at most: with its frame it is never 100 behind."""


class SeenPart(QObject):
    """Tells a part of the window what it shows while it can be seen; else it costs nothing, whatever is edited.

    It is told once at first, and again whenever it is about to be painted and something has changed since: behind
    another tab, in a place that is closed or pushed together, scrolled out of sight, in a minimised window. During a
    gesture, in which every state has a frame of its own, it is told no more often than it must.

    Parameters
    ----------
    part : the widget
    show : shows a state in it, after the one that it was told last
    store : whose states these are
    """

    def __init__(self, part: QWidget, show: Listener, store: Store) -> None:
        super().__init__(part)
        self._part, self._show, self._store = part, show, store
        self._told: EditorState | None = None
        self._since_told, self._since_state = QElapsedTimer(), QElapsedTimer()
        self._since_state.start()
        self._due = QTimer(self, singleShot=True)
        self._due.timeout.connect(self.tell)
        part.installEventFilter(self)

    def show_state(self, _before: EditorState | None, after: EditorState) -> None:
        """Tell the part a state now, or later, or when it is seen."""
        if self._told is not None and not self._is_seen():
            return
        period = self._since_state.restart()
        if self._told is None or after.gesture is None or self._since_told.elapsed() + period >= BEHIND:
            self.tell()  # the next state, if it comes as this one came, would be too late
        elif not self._due.isActive():
            self._due.start(BEHIND - self._since_told.elapsed())

    def tell(self) -> None:
        """Tell the part what is shown now, seen or not."""
        before, after = self._told, self._store.shown
        self._due.stop()
        if before is not after:
            self._told = after
            self._since_told.start()
            self._show(before, after)

    def eventFilter(self, _watched: QObject, event: QEvent) -> bool:
        comes = event.type() is QEvent.Type.Show or (event.type() is QEvent.Type.Paint and not self._due.isActive())
        if comes and self._told is not None:
            self.tell()
        return False

    def _is_seen(self) -> bool:
        part = self._part
        return part.isVisible() and not part.window().isMinimized() and not part.visibleRegion().isEmpty()
