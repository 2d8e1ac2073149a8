"""Drafts: the hidden files in which everything is written before it takes its place, and what killed writers left.

A draft is locked while it is written. So a draft that nobody has locked was left by a process that is no more, whatever
machine or container that ran in; where a share knows no locks, the age of a draft tells.
"""

from __future__ import annotations

import os
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

try:
    import fcntl
except ImportError:  # Windows, where a file that is open cannot be deleted anyway
    _LOCKS_ARE_KNOWN = False
else:
    _LOCKS_ARE_KNOWN = True

_PREFIX, _SUFFIX = ".qovr-", ".part"
"""What the names of drafts, and of folders with parts of them, begin and end with; between them stands the number of
the process, so that those of a process that was ended can be told from what others are writing."""

_ABANDONED_SECONDS = 24 * 3600.0
"""A draft not touched for so long was left by a killed process: no write takes a day."""

_PATIENCE_SECONDS = 2.0
"""What is waited for others at most: putting files in their places takes them milliseconds."""

_NONE, _HELD = -1, -2
"""Instead of a lock's descriptor: there are no locks, or no file; somebody else holds it."""

_OWN_NAMES = f"{_PREFIX}[0-9]*-*{_SUFFIX}"
"""Those of drafts that are locked while they are written."""


@contextmanager
def new_draft(folder: Path) -> Iterator[Path]:
    """Yield a new empty file in a folder, which vanishes at the end unless it has got another name.

    Raises
    ------
    OSError : the folder takes no new file
    """
    with _made(folder, lambda draft: os.close(os.open(draft, os.O_CREAT | os.O_EXCL | os.O_WRONLY, 0o666))) as draft:
        yield draft


@contextmanager
def scratch_folder(beside: Path) -> Iterator[Path]:
    """Yield a new folder beside a draft, for what is needed while it is written; it vanishes at the end."""
    with _made(beside.parent, Path.mkdir) as folder:
        yield folder


def remove_drafts(target: Path, process: int) -> None:
    """Delete what a process that is no more has left beside a file it was writing."""
    with suppress(OSError, ValueError):
        for draft in Path(os.path.realpath(target)).parent.glob(f"{_PREFIX}{process}-*{_SUFFIX}"):
            _remove(draft)


def sweep(folder: Path) -> None:
    """Delete what killed processes left in a folder, as far as that can be done."""
    limit = time.time() - _ABANDONED_SECONDS
    with suppress(OSError):
        for draft in list(folder.glob(f"{_PREFIX}*{_SUFFIX}")):
            with suppress(OSError):
                if draft.lstat().st_mtime < limit:
                    _remove(draft)
                elif draft.match(_OWN_NAMES):
                    _remove_if_unlocked(draft)


@contextmanager
def turn(folder: Path) -> Iterator[None]:
    """Let no other process put several files in their places in a folder at the same time, where locks are known."""
    deadline = time.monotonic() + _PATIENCE_SECONDS
    while (lock := _locked(folder)) < 0 and _LOCKS_ARE_KNOWN and time.monotonic() < deadline:
        time.sleep(_PATIENCE_SECONDS / 200)
    try:
        yield
    finally:
        _close(lock)


@contextmanager
def _made(folder: Path, make: Callable[[Path], None]) -> Iterator[Path]:
    draft, lock = folder, _NONE
    try:
        # Between making and locking, another writer may sweep it away: it is gone, or its lock is held for that.
        while draft == folder or lock == _HELD or not draft.exists():
            _close(lock)
            draft = folder / f"{_PREFIX}{os.getpid()}-{os.urandom(6).hex()}{_SUFFIX}"
            make(draft)
            lock = _locked(draft)
        yield draft
    finally:
        if draft != folder:
            _remove(draft)
        _close(lock)


def _remove_if_unlocked(draft: Path) -> None:
    lock = _locked(draft)
    if lock >= 0:
        _remove(draft)
        _close(lock)


def _locked(path: Path) -> int:
    """Return an open descriptor that holds the lock of a file or folder; where it cannot be had, _HELD or _NONE."""
    if not _LOCKS_ARE_KNOWN:
        return _NONE
    try:
        descriptor = os.open(path, os.O_RDONLY | os.O_NOFOLLOW)
    except OSError:
        return _NONE
    try:
        fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError as error:
        os.close(descriptor)
        return _HELD if isinstance(error, BlockingIOError) else _NONE
    return descriptor


def _close(descriptor: int) -> None:
    if descriptor >= 0:
        fcntl.flock(descriptor, fcntl.LOCK_UN)  # a process forked meanwhile has a copy of the descriptor
        os.close(descriptor)


def _remove(draft: Path) -> None:
    with suppress(OSError):
        if draft.is_dir() and not draft.is_symlink():
            import shutil

            shutil.rmtree(draft, ignore_errors=True)
        else:
            draft.unlink(missing_ok=True)
