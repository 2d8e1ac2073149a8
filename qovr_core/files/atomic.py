"""Files that appear whole or not at all: the one way in which anything is written."""

from __future__ import annotations

import logging
import os
import secrets
import shutil
import stat
import time
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager, suppress
from pathlib import Path
from tempfile import TemporaryDirectory

from qovr_core.errors import FileError

LOGGER = logging.getLogger("qovr_core.files")
"""Tells, as a warning, what a user ought to know of a file that was written all the same."""

_PREFIX, _SUFFIX = ".qovr-", ".part"
"""What the names of drafts, and of folders with parts of them, begin and end with; between them stands the number of
the process, so that what a killed one left can be told from what others are writing."""

_ABANDONED_SECONDS = 24 * 3600.0
"""A draft not touched for so long was left by a killed process: no write takes a day."""


@contextmanager
def replacing(*targets: Path) -> Iterator[tuple[Path, ...]]:
    """Yield a new empty file beside each target; on success they take the targets' places, else they vanish.

    Whatever ends the block early - a full disk, an interrupt, a cancelled progress - leaves the targets as they were.
    Several targets take their places one after the other. Links are followed. A file that was there keeps its mode, and
    its group and owner where the system allows; a new one gets its mode from the system.

    Raises
    ------
    FileError : a file cannot be made, written or put in its place
    """
    places = [_place(target) for target in targets]
    folders = {place.parent for place in places}
    for folder in folders:
        _sweep(folder)
    with ExitStack() as stack:
        drafts = tuple(
            stack.enter_context(_draft(target, place)) for target, place in zip(targets, places, strict=True)
        )
        try:
            yield drafts
            for draft in drafts:
                _flush_to_disk(draft)
            for draft, target, place in zip(drafts, targets, places, strict=True):
                _tell_of_new_owner(target, place, draft)
                draft.replace(place)
            for folder in folders:
                _flush_folder(folder)
        except OSError as error:
            raise unwritable(targets[0], error) from error


@contextmanager
def scratch_folder(beside: Path) -> Iterator[Path]:
    """Yield a new folder beside a draft, for what is needed while it is written; it vanishes at the end."""
    with TemporaryDirectory(_SUFFIX, _prefix(os.getpid()), beside.parent, ignore_cleanup_errors=True) as folder:
        yield Path(folder)


def remove_drafts(target: Path, process: int) -> None:
    """Delete what a process that is no more has left beside a file it was writing."""
    for draft in _place(target).parent.glob(f"{_prefix(process)}*{_SUFFIX}"):
        _remove(draft)


def unwritable(path: Path, error: OSError) -> FileError:
    """Return the error to raise where writing a path failed."""
    return FileError(f"{path}: cannot be written: {error.strerror or error}")


def _place(target: Path) -> Path:
    """Return where a target really stands, itself no link; nothing needs to be there."""
    return Path(os.path.realpath(target))


def _prefix(process: int) -> str:
    return f"{_PREFIX}{process}-"


@contextmanager
def _draft(target: Path, place: Path) -> Iterator[Path]:
    draft = place.parent / f"{_prefix(os.getpid())}{secrets.token_hex(6)}{_SUFFIX}"
    try:
        _check(target, place)
        draft.touch(exist_ok=False)
        if place.exists():
            _take_over(draft, place.stat())
    except OSError as error:
        _remove(draft)
        raise unwritable(target, error) from error
    try:
        yield draft
    finally:
        _remove(draft)


def _check(target: Path, place: Path) -> None:
    if place.is_dir():
        raise FileError(f"{target}: cannot be written: it is a folder; expected a file name")
    if not place.parent.is_dir():
        raise FileError(f"{target}: cannot be written: the folder {target.parent} does not exist")
    if place.exists() and not os.access(place, os.W_OK):
        raise FileError(f"{target}: cannot be written: the file is write-protected")


def _take_over(draft: Path, before: os.stat_result) -> None:
    """Give a draft the owner, group and mode of the file it replaces, as far as the system allows.

    Where the group cannot be kept, another one gets no more than all the others had.
    """
    mode = stat.S_IMODE(before.st_mode)
    if hasattr(os, "chown"):
        for owner, group in ((-1, before.st_gid), (before.st_uid, -1)):
            with suppress(OSError):
                os.chown(draft, owner, group)
        if draft.stat().st_gid != before.st_gid:
            mode = mode & ~stat.S_IRWXG | (mode & stat.S_IRWXO) << 3
    with suppress(OSError):  # some shares refuse; their files have the mode that the share gives them
        draft.chmod(mode)


def _tell_of_new_owner(target: Path, place: Path, draft: Path) -> None:
    if place.exists() and place.stat().st_uid != draft.stat().st_uid:
        LOGGER.warning("%s: belongs to you now; the system does not allow it to be given to its owner again", target)


def _sweep(folder: Path) -> None:
    """Delete what killed processes left in a folder long ago, as far as that can be done."""
    limit = time.time() - _ABANDONED_SECONDS
    with suppress(OSError):
        for draft in list(folder.glob(f"{_PREFIX}*{_SUFFIX}")):
            if draft.lstat().st_mtime < limit:
                _remove(draft)


def _remove(draft: Path) -> None:
    with suppress(OSError):
        if draft.is_dir() and not draft.is_symlink():
            shutil.rmtree(draft, ignore_errors=True)
        else:
            draft.unlink(missing_ok=True)


def _flush_to_disk(path: Path) -> None:
    with path.open("ab") as file:
        os.fsync(file.fileno())


def _flush_folder(folder: Path) -> None:
    """Make the new names last, where that can be asked for: only on POSIX systems, and not on every share."""
    if os.name != "posix":
        return
    with suppress(OSError):
        descriptor = os.open(folder, os.O_RDONLY)
        try:
            os.fsync(descriptor)
        finally:
            os.close(descriptor)
