"""What outlives a crash: every window keeps its unsaved document in a file of its own, which the next start finds."""

from __future__ import annotations

import json
import secrets
from dataclasses import dataclass
from pathlib import Path

from PySide6.QtCore import QLockFile, QObject, QStandardPaths, Signal

from qovr_app.state.editor_state import EditorState
from qovr_app.work.worker import Worker
from qovr_core import Document, FileError, QovrError
from qovr_core.files.atomic import replacing
from qovr_core.files.qovr_document import document_from_json, document_to_json

_SUFFIX = ".unsaved.json"


def recovery_folder() -> Path:
    """Return the folder of the recovery files of this user."""
    place = QStandardPaths.StandardLocation.GenericDataLocation
    return Path(QStandardPaths.writableLocation(place)) / "qovr-studio" / "recovery"


@dataclass(frozen=True, eq=False)
class Unsaved:
    """A document that an earlier run left unsaved; nobody else can take it while this object holds it."""

    document: Document
    title: str
    path: Path | None
    changed: float
    _file: Path
    _lock: QLockFile

    def remove(self) -> None:
        """Delete its file."""
        self._file.unlink(missing_ok=True)
        self._lock.unlock()

    def release(self) -> None:
        """Leave it to the next start."""
        self._lock.unlock()


class RecoveryStore:
    """The recovery file of one window, and those that earlier runs left behind.

    A lock beside each file says that its process lives; the system frees it when the process dies.
    """

    def __init__(self, folder: Path | None = None) -> None:
        self._folder = folder or recovery_folder()
        self._token = secrets.token_hex(8)
        self._lock: QLockFile | None = None

    def keep(self, document: Document, title: str, path: Path | None) -> None:
        """Write a document to this window's file, whole or not at all.

        Raises
        ------
        FileError : the file cannot be written
        """
        if self._lock is None:
            self._claim()
        entries = {
            "title": title,
            "path": None if path is None else str(path),
            "document": json.loads(document_to_json(document)),
        }
        with replacing(self._file) as (draft,):
            draft.write_text(json.dumps(entries), encoding="utf-8")

    def forget(self) -> None:
        """Delete this window's file.

        Raises
        ------
        FileError : the file cannot be deleted
        """
        try:
            self._file.unlink(missing_ok=True)
        except OSError as error:
            raise FileError(f"{self._file}: cannot be deleted: {error.strerror or error}") from error

    def close(self) -> None:
        """Delete this window's file, for good."""
        self.forget()
        if self._lock is not None:
            self._lock.unlock()

    def found(self) -> list[Unsaved]:
        """Return what dead processes left, the latest first, each claimed for this one."""
        self._sweep()
        files = sorted(self._folder.glob(f"*{_SUFFIX}"), key=_changed, reverse=True)
        entries = (_claimed(file) for file in files if file != self._file)
        return [entry for entry in entries if entry is not None]

    @property
    def _file(self) -> Path:
        return self._folder / f"{self._token}{_SUFFIX}"

    def _claim(self) -> None:
        try:
            self._folder.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            raise FileError(f"{self._folder}: cannot be made: {error.strerror or error}") from error
        lock = _lock_of(self._file)
        if lock.tryLock(0):
            self._lock = lock

    def _sweep(self) -> None:
        """Delete locks that killed processes left in the folder."""
        for orphan in self._folder.glob("*.lock"):
            file = orphan.with_name(orphan.stem + _SUFFIX)
            lock = _lock_of(file)
            if not file.exists() and lock.tryLock(0):
                lock.unlock()


def _changed(file: Path) -> float:
    try:
        return file.stat().st_mtime
    except OSError:
        return 0.0


def _lock_of(file: Path) -> QLockFile:
    lock = QLockFile(str(file.with_name(file.name.removesuffix(_SUFFIX) + ".lock")))
    lock.setStaleLockTime(0)  # a lock ends with its process, however long that lives
    return lock


def _claimed(file: Path) -> Unsaved | None:
    """Return what a file holds if no living process owns it."""
    lock = _lock_of(file)
    if not lock.tryLock(0):
        return None
    try:
        entries = json.loads(file.read_text(encoding="utf-8"))
        document = document_from_json(json.dumps(entries["document"]))
        path = None if entries["path"] is None else Path(entries["path"])
        return Unsaved(document, str(entries["title"]), path, _changed(file), file, lock)
    except (OSError, ValueError, KeyError, TypeError, QovrError):
        # Another instance has just taken it, or it is none of ours: nothing to offer either way.
        lock.unlock()
        return None


Snapshot = tuple[Document, str, Path | None]
"""A document with its title and its file."""


class RecoveryWriter(QObject):
    """Keeps a window's document in a recovery store for as long as it is not saved.

    A thread writes, always the latest document: a slow disk delays no drag, and a kill loses at most what was set
    while one small file was written.

    Signals
    -------
    failed : why the document cannot be kept; once
    """

    failed = Signal(str)

    def __init__(self, store: RecoveryStore, worker: Worker, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._store, self._worker = store, worker
        self._has_failed = False
        self._asked = 0

    def show_state(self, before: EditorState | None, after: EditorState) -> None:
        """Hand a document that is not saved over to be kept, or let the one before be forgotten."""
        if after.differs(before, "history", "file"):
            self._asked += 1
            snapshot = (after.document, after.file.title, after.file.path) if after.is_changed else None
            self._worker.in_thread(self._write, self._asked, snapshot, on_failed=self._on_failed)

    def close(self) -> None:
        """Forget the document: it is saved, or nobody wants it; the worker has been closed before."""
        self._store.close()

    def _write(self, asked: int, snapshot: Snapshot | None) -> None:
        if asked < self._asked:
            return  # a later call will write a later document
        if snapshot is None:
            self._store.forget()
        else:
            self._store.keep(*snapshot)

    def _on_failed(self, error: QovrError) -> None:
        if not self._has_failed:
            self._has_failed = True
            self.failed.emit(f"A crash would lose the unsaved changes: {error}.")
