"""What happens to the document's file outside: noticed while the window is there, and offered to be read again."""

from __future__ import annotations

from pathlib import Path
from threading import Thread

from PySide6.QtCore import QObject, QTimer, Signal
from PySide6.QtWidgets import QWidget

from qovr_app.state.editor_state import DocumentFile, EditorState
from qovr_app.state.intents import FileFound, OutsideKept
from qovr_app.state.requests import ReloadAsked
from qovr_app.store import Store
from qovr_app.widgets.notice import Notice
from qovr_app.window.sources import file_stamp

_LOOK_MILLISECONDS = 1000
"""How often is looked. Watching by the system is not the same on every share; this is, and costs one call."""


class FileWatch(QObject):
    """Looks at the document's file now and then, in a thread: a share that does not answer delays nothing."""

    _looked = Signal(object, object)

    def __init__(self, store: Store, parent: QObject) -> None:
        super().__init__(parent)
        self._store = store
        self._is_looking = False
        self._looked.connect(self._on_looked)
        self._timer = QTimer(self, interval=_LOOK_MILLISECONDS)
        self._timer.timeout.connect(self.look)
        self._timer.start()

    def look(self) -> None:
        """Look at the file now, unless that is being done."""
        file = self._store.state.file
        if file.path is not None and not self._is_looking:
            self._is_looking = True
            Thread(target=self._ask, args=(file, file.path), daemon=True).start()

    def close(self) -> None:
        """Look no more."""
        self._timer.stop()

    def _ask(self, file: DocumentFile, path: Path) -> None:
        try:
            answer = FileFound(path, file_stamp(path))
        except OSError:
            answer = FileFound(path, file.found)  # it cannot be told: as far as is known, nothing has happened
        try:
            self._looked.emit(file, answer)
        except RuntimeError:  # the window has gone meanwhile
            return

    def _on_looked(self, file: DocumentFile, answer: FileFound) -> None:
        self._is_looking = False
        if self._store.state.file is file:  # else it was read or written here since
            self._store.dispatch(answer)


class OutsideOffer:
    """Says that the file is another one now, and offers to read it again; ``notice`` is the bar."""

    def __init__(self, store: Store, parent: QWidget) -> None:
        self.notice = Notice("outside", parent)
        self.notice.add_answer(
            "reload",
            "Reload",
            "Read the file again; Undo brings back what stands here now",
            lambda: store.dispatch(ReloadAsked()),
        )
        self.notice.add_answer(
            "keep",
            "Keep mine",
            "Go on with what stands here; Save will replace the file",
            lambda: store.dispatch(OutsideKept()),
        )

    def show_state(self, before: EditorState | None, after: EditorState) -> None:
        """Show the offer while it is one."""
        if not after.differs(before, "file"):
            return
        if not after.file.is_changed_outside:
            self.notice.setVisible(False)
        elif after.file.found is None:
            self.notice.ask(f"{after.file.title} was deleted or moved by another program.")
        else:
            self.notice.ask(f"{after.file.title} was changed by another program.")
