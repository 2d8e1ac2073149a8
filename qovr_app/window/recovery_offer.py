"""What an earlier run left unsaved, offered in a bar over the work until it is answered."""

from __future__ import annotations

from concurrent.futures import Future, wait
from contextlib import suppress
from datetime import datetime
from functools import partial
from threading import Thread
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal

from qovr_app.state.intents import Opened
from qovr_app.state.looking_intents import MessageShown
from qovr_app.state.requests import RecoveryAnswered
from qovr_app.widgets.notice import Notice
from qovr_app.window.document_shell import DocumentShell
from qovr_app.window.recovery import RecoveryStore, Unsaved
from qovr_app.window.recovery_file import Snapshot
from qovr_app.window.shell import Answers
from qovr_app.window.windows import Windows
from qovr_app.work.worker import Worker
from qovr_core import QovrError

if TYPE_CHECKING:
    from qovr_app.window.main_window import MainWindow

_PATIENCE_SECONDS = 0.2
"""A disk of this computer has told by then; a share that takes longer is waited for without holding the window up."""

Found = tuple[list[Unsaved], list[str]]


class RecoveryOffer(QObject):
    """Offers one document after the other; ``notice`` is the bar."""

    _looked = Signal(object)

    def __init__(self, documents: DocumentShell, windows: Windows, worker: Worker, window: MainWindow) -> None:
        super().__init__(window)
        self._documents, self._windows, self._worker, self._window = documents, windows, worker, window
        self._store = window.store
        self._unsaved: list[Unsaved] = []
        self._is_closed = False
        self._looked.connect(self._on_looked)
        self.answers: Answers = {RecoveryAnswered: self._answer}
        self.notice = Notice("recovery", window)
        for name, text, tip in (
            ("restore", "Restore", "Go on with the unsaved document"),
            ("discard", "Discard", "Delete the unsaved document"),
        ):
            answer = RecoveryAnswered(is_wanted=name == "restore")
            self.notice.add_answer(name, text, tip, partial(self._store.dispatch, answer))

    def offer(self, recovery: RecoveryStore) -> None:
        """Offer what earlier runs left unsaved, as soon as it is known."""
        looked: Future[Found] = Future()
        Thread(target=_look, args=(recovery, looked), daemon=True).start()
        wait([looked], _PATIENCE_SECONDS)
        if looked.done():
            self._on_looked(looked.result())
        else:
            looked.add_done_callback(self._tell)

    def release(self) -> None:
        """Leave what was not answered to the next start."""
        self._is_closed = True
        for entry in self._unsaved:
            entry.release()
        self._unsaved = []

    def _tell(self, looked: Future[Found]) -> None:
        with suppress(RuntimeError):  # the window has gone meanwhile
            self._looked.emit(looked.result())

    def _on_looked(self, found: Found) -> None:
        self._unsaved, sentences = found
        if self._is_closed:
            self.release()
            return
        for sentence in sentences[-1:]:
            self._store.dispatch(MessageShown(sentence, is_refusal=True))
        self._ask()

    def _answer(self, request: RecoveryAnswered) -> None:
        """Go on with the document that is offered, or delete it."""
        entry = self._unsaved.pop(0)
        window = self._restored(entry.snapshot) if request.is_wanted else None
        if window is not None and window.recovery is not None:
            window.recovery.supersede(entry, window.store.state)
        else:
            self._worker.in_thread(entry.remove, on_failed=self._on_not_removed)
        self._ask()

    def _restored(self, kept: Snapshot) -> MainWindow:
        """Go on with a document here, or beside what is not saved here; return the window that does."""
        message = f"Restored {kept.title}; it is not saved yet."
        restored = Opened(
            kept.document, kept.title, kept.path, kept.stamp, is_saved=False, message=message, draft=kept.draft
        )
        if self._store.state.is_changed:
            return self._windows.take(restored)
        self._documents.go_on_with(restored)
        return self._window

    def _on_not_removed(self, error: QovrError) -> None:
        self._store.dispatch(MessageShown(f"{error}.", is_refusal=True))

    def _ask(self) -> None:
        if not self._unsaved:
            self.notice.setVisible(False)
            return
        entry = self._unsaved[0]
        more = f"  ({len(self._unsaved) - 1} more)" if len(self._unsaved) > 1 else ""
        title = entry.snapshot.title
        self.notice.ask(f"Unsaved changes to {title}{_when(entry.changed)} were kept when the program ended.{more}")


def _look(recovery: RecoveryStore, looked: Future[Found]) -> None:
    looked.set_result(recovery.found())


def _when(changed: float) -> str:
    try:
        return datetime.fromtimestamp(changed).strftime(" from %d %B, %H:%M")
    except (OverflowError, OSError, ValueError):  # a clock that was wrong
        return ""
