"""Keeps what is not saved of one window where a crash does not reach it."""

from __future__ import annotations

import time

from PySide6.QtCore import QObject, Signal

from qovr_app.state.editor_state import EditorState
from qovr_app.window.recovery import RecoveryStore, Unsaved, snapshot_of
from qovr_app.window.recovery_file import Snapshot
from qovr_app.work.worker import Worker
from qovr_core import FileError, QovrError

_BYTES_A_SECOND = 10_000_000
"""No more is written while a large net is dragged: its file takes two megabytes, and every move asks for it."""


class RecoveryWriter(QObject):
    """Keeps a window's document in a recovery store for as long as it is not saved.

    A thread writes, always the latest document: a slow disk delays no drag, and a kill loses at most what was set
    while one file was written, and while the disk rests from a large one.

    Signals
    -------
    failed : why the document cannot be kept; once until it can be again
    """

    failed = Signal(str)

    def __init__(self, store: RecoveryStore, worker: Worker, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._store, self._worker = store, worker
        self._has_failed = False
        self._asked = 0
        self._superseded: list[Unsaved] = []

    def show_state(self, before: EditorState | None, after: EditorState) -> None:
        """Hand a document that is not saved over to be kept, or let the one before be forgotten."""
        if after.differs(before, "history", "file", "draft", "texts"):
            self._ask(snapshot_of(after))

    def supersede(self, entry: Unsaved, state: EditorState) -> None:
        """Delete what an earlier run left when this window's own file holds a state that came of it."""
        self._superseded.append(entry)
        self._ask(snapshot_of(state))

    def close(self, *, is_wanted: bool) -> None:
        """End; the worker has been closed before, and all is written.

        Parameters
        ----------
        is_wanted : whether what is not saved is left to the next start; else it is saved, or nobody wants it
        """
        for entry in self._superseded:  # none of them was written anew
            entry.release()
        try:
            if not is_wanted:
                self._store.forget()
        except FileError:  # nothing can be done about it any more; it will be offered
            return
        finally:
            self._store.release()

    def _ask(self, snapshot: Snapshot | None) -> None:
        self._asked += 1
        self._worker.in_thread(
            self._write, self._asked, snapshot, on_done=lambda _: self._on_written(), on_failed=self._on_failed
        )

    def _write(self, asked: int, snapshot: Snapshot | None) -> None:
        if asked < self._asked:
            return  # a later call will write a later document
        superseded, size = self._superseded[:], 0
        if snapshot is None:
            self._store.forget()
        else:
            size = self._store.keep(snapshot)
        for entry in superseded:
            self._superseded.remove(entry)
            entry.remove()
        time.sleep(size / _BYTES_A_SECOND)

    def _on_written(self) -> None:
        self._has_failed = False

    def _on_failed(self, error: QovrError) -> None:
        if not self._has_failed:
            self._has_failed = True
            self.failed.emit(f"A crash would lose the unsaved changes: {error}.")
