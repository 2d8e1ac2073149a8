"""The windows of this process, one document each."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QApplication, QWidget

from qovr_app.state.editor_state import EditorState
from qovr_app.state.intents import Opened
from qovr_app.state.requests import SourceAsked

if TYPE_CHECKING:
    from qovr_app.window.main_window import MainWindow


class Windows:
    """Opens windows, finds them, and lets all of them go.

    Parameters
    ----------
    make : returns a window that shows a source, None for the paper's example; it joins these
    """

    def __init__(self, make: Callable[[str | None], MainWindow]) -> None:
        self._make = make
        self._windows: list[MainWindow] = []

    @property
    def all(self) -> tuple[MainWindow, ...]:
        """The windows in the order in which they were opened."""
        return tuple(self._windows)

    @property
    def last_used(self) -> MainWindow | None:
        """The window in front, or the one opened last; None where there is none yet."""
        in_front = (window for window in self._windows if window.isActiveWindow())
        return next(in_front, self._windows[-1] if self._windows else None)

    def add(self, window: MainWindow) -> None:
        """Count a window as one of these until it is removed."""
        self._windows.append(window)
        window.destroyed.connect(partial(self.remove, window))  # whoever made it may delete it without closing it

    def remove(self, window: MainWindow, *_from_signal: object) -> None:
        """Count a window, which closes, no longer."""
        if window in self._windows:
            self._windows.remove(window)

    def open(self, source: str | None = None) -> MainWindow:
        """Open a window that shows a source, None for the paper's example; it is gone once it is closed."""
        return self._shown(self._make(source))

    def take(self, opened: Opened) -> MainWindow:
        """Open a window that shows a document."""
        window = self._make(None)
        window.store.dispatch(opened)
        window.store.flush()
        return self._shown(window)

    def open_all(self, sources: Sequence[str]) -> None:
        """Open each source in a window of its own, where it is not open already; none at all is the paper's example."""
        for source in sources:
            window = self.last_used
            if window is None:
                self.open(source)
            else:
                bring_forward(window)
                window.store.dispatch(SourceAsked(source, elsewhere=True))
        if not sources:
            self.open()

    def having(self, path: Path | None, *, besides: QWidget | None = None) -> MainWindow | None:
        """Return the window whose document is kept in a file; None where there is none."""
        found = (window for window in self._windows if window is not besides and window.store.state.file.path == path)
        return None if path is None else next(found, None)

    def step_from(self, window: QWidget, step: int) -> None:
        """Bring the next window to the front, or for -1 the one before."""
        places = [k for k, other in enumerate(self._windows) if other is window]
        if places:
            bring_forward(self._windows[(places[0] + step) % len(self._windows)])

    def quit(self) -> None:
        """Ask of each window what is to become of what is not saved, then close all; none where one stays."""
        for window in self.all:
            if window.store.state.is_changed:
                bring_forward(window)
            if not window.may_close():
                return
        for window in self.all:
            window.leave()

    def end(self) -> None:
        """End all at once, without a question: what is not saved is offered at the next start."""
        for window in self.all:
            window.end()

    def _shown(self, window: MainWindow) -> MainWindow:
        window.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        window.show()
        bring_forward(window)
        return window


def is_untouched(state: EditorState) -> bool:
    """Whether a window shows what it began with, and nothing that anybody would miss."""
    says_refusal = state.message is not None and state.message.is_refusal
    return not (state.file.opening or state.history.steps or state.has_pending or says_refusal)


def bring_forward(window: QWidget) -> None:
    """Bring a window to the front, and the keyboard to it; where the system lets nobody do so, it is marked there."""
    window.setWindowState(window.windowState() & ~Qt.WindowState.WindowMinimized)
    window.raise_()
    window.activateWindow()
    QApplication.alert(window)
