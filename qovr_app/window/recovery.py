"""What outlives a crash: every window keeps its unsaved document in a file of its own, which the next start finds."""

from __future__ import annotations

import secrets
import stat
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path

from PySide6.QtCore import QStandardPaths

from qovr_app.state.editor_state import EditorState
from qovr_app.window.process_lock import Hold, ProcessLock
from qovr_app.window.recovery_file import Snapshot, read_snapshot, write_snapshot
from qovr_core import FileError, QovrError
from qovr_core.files.atomic import replacing

_SUFFIX = ".unsaved"

_SET_ASIDE = ".damaged"
"""What is added to the name of a file that nobody can read."""

_LARGEST_FILE = 16_000_000
"""Bytes; what is larger was not written by this program."""


def recovery_folder() -> Path:
    """Return the folder of the recovery files of this user."""
    place = QStandardPaths.StandardLocation.GenericDataLocation
    return Path(QStandardPaths.writableLocation(place)) / "qovr-studio" / "recovery"


def snapshot_of(state: EditorState) -> Snapshot | None:
    """Return what is to be kept of a state; None where all of it is saved."""
    if not state.is_changed:
        return None
    draft = state.pending if state.has_pending else None
    return Snapshot(state.document, state.file.title, state.file.path, state.file.stamp, draft)


@dataclass(frozen=True, eq=False)
class Unsaved:
    """What an earlier run left unsaved; nobody else can take it while this object holds it."""

    snapshot: Snapshot
    changed: float
    _file: Path
    _lock: ProcessLock

    def remove(self) -> None:
        """Delete its file.

        Raises
        ------
        FileError : it cannot be deleted; it will be offered again
        """
        try:
            _delete(self._file)
        finally:
            self._lock.let_go()

    def release(self) -> None:
        """Leave it to the next start."""
        self._lock.let_go()


class RecoveryStore:
    """The recovery file of one window, and those that earlier runs left behind.

    A lock beside each file says that its process lives; the system frees it when the process dies.
    """

    def __init__(self, folder: Path | None = None) -> None:
        self._folder = folder or recovery_folder()
        self._token = secrets.token_hex(8)
        self._lock: ProcessLock | None = None

    def keep(self, snapshot: Snapshot) -> int:
        """Write a document to this window's file, whole or not at all; return how many bytes it takes.

        Raises
        ------
        FileError : the file cannot be written
        """
        if self._lock is None:
            self._claim()
        with replacing(self._file) as (draft,):
            write_snapshot(snapshot, draft)
            return draft.stat().st_size

    def forget(self) -> None:
        """Delete this window's file, if there is one.

        Raises
        ------
        FileError : the file cannot be deleted
        """
        if self._lock is not None:
            _delete(self._file)

    def release(self) -> None:
        """Let this window's file go: what is in it is left to the next start."""
        if self._lock is not None:
            self._lock.let_go()
            self._lock = None

    def found(self) -> tuple[list[Unsaved], list[str]]:
        """Return what dead processes left, the latest first, each claimed for this one; and what could not be read.

        What cannot be read is set aside under another name, and said in a sentence.
        """
        unsaved, sentences = [], []
        try:
            self._sweep()
            files = sorted(self._folder.glob(f"*{_SUFFIX}"), key=_changed, reverse=True)
        except OSError as error:
            reason = error.strerror or error
            return [], [f"What may have been left unsaved cannot be looked for: {self._folder}: {reason}."]
        for file in files:
            lock = _lock_of(file)
            if file == self._file or lock.take() is Hold.OTHERS:
                continue
            try:
                unsaved.append(Unsaved(_read(file), _changed(file), file, lock))
            except FileNotFoundError:  # another instance has just taken it
                lock.let_go()
            except (OSError, ValueError, KeyError, TypeError, RecursionError, QovrError) as error:
                lock.let_go()
                sentences.append(_set_aside(file, error))
        return unsaved, sentences

    @property
    def _file(self) -> Path:
        return self._folder / f"{self._token}{_SUFFIX}"

    def _claim(self) -> None:
        try:
            self._folder.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            raise FileError(f"{self._folder}: cannot be made: {error.strerror or error}") from error
        self._lock = _lock_of(self._file)
        self._lock.take()

    def _sweep(self) -> None:
        """Delete locks that killed processes left in the folder."""
        for orphan in self._folder.glob("*.lock"):
            file = orphan.with_name(orphan.stem + _SUFFIX)
            if not file.exists():
                lock = _lock_of(file)
                if lock.take() is Hold.OURS:
                    lock.let_go()


def _read(file: Path) -> Snapshot:
    """Return what a file holds.

    Raises
    ------
    OSError, ValueError, KeyError, TypeError, RecursionError, QovrError : it is not what ``write_snapshot`` writes
    """
    status = file.stat()
    if not stat.S_ISREG(status.st_mode) or status.st_size > _LARGEST_FILE:
        raise ValueError("it is none of this program's files")
    return read_snapshot(file)


def _set_aside(file: Path, error: Exception) -> str:
    """Rename a file that cannot be read, and say so."""
    aside = file.with_name(file.name + _SET_ASIDE)
    reason = error.strerror if isinstance(error, OSError) else ""
    text = f"A file with unsaved work cannot be read{reason and f' ({reason})'}"
    try:
        file.replace(aside)
    except OSError:
        return f"{text}: {file}."
    return f"{text}; it was set aside as {aside}."


def _delete(file: Path) -> None:
    try:
        file.unlink(missing_ok=True)
    except OSError as error:
        raise FileError(f"{file}: cannot be deleted: {error.strerror or error}") from error


def _changed(file: Path) -> float:
    with suppress(OSError):
        return file.stat().st_mtime
    return 0.0


def _lock_of(file: Path) -> ProcessLock:
    return ProcessLock(file.with_name(file.name.removesuffix(_SUFFIX) + ".lock"))
